namespace RayTracer.Cli;

/// <summary>The command <c>raytracer</c>.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        LanesOption.Obey(args);
        return CommandLine.Run(args, new(Console.Out, new UnfailingWriter(Console.Error), HasTerminal: Streams.IsTerminal(
            Console.IsErrorRedirected, Environment.GetEnvironmentVariable("TERM"))));
    }
}
