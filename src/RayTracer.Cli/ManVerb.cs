using System.CommandLine;

namespace RayTracer.Cli;

/// <summary><c>raytracer man</c></summary>
internal static class ManVerb
{
    public static void Build(Command command, Streams streams) =>
        command.SetAction(_ => streams.Output.Write(ManualPage.Write(CommandLine.Help(streams))));
}
