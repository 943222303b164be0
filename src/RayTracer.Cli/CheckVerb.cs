using System.CommandLine;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary><c>raytracer check SCENE…</c></summary>
internal static class CheckVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string[]> scenes = new("SCENE") { Description = "Scene files.", Arity = ArgumentArity.OneOrMore };
        command.Arguments.Add(scenes);
        command.SetAction(result => result.GetValue(scenes)!.Max(path => Check(path, streams)));
    }

    private static int Check(string path, Streams streams)
    {
        SceneLoadResult result = SceneFile.Load(path);
        SceneFile.Show(result, streams);
        if (result.Scene is null)
        {
            return SceneFile.FailureStatus(path);
        }

        if (result.Diagnostics.Count == 0)
        {
            streams.Output.WriteLine($"{path}: fine");
        }

        return ExitStatus.Fine;
    }
}
