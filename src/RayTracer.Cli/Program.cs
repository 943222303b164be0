using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>The command <c>raytracer</c>.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        if (args is ["render" or "sweep" or "resume" or "verify" or "bench" or "reproduce", ..])
        {
            WideVectors.Enable(args);
        }

        return CommandLine.Run(args, new(Console.Out, new UnfailingWriter(Console.Error), HasTerminal: Streams.IsTerminal(
            Console.IsErrorRedirected, Environment.GetEnvironmentVariable("TERM"))));
    }
}
