namespace RayTracer.Cli;

/// <summary>The command <c>raytracer</c>.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        WideVectors.Enable(args);
        return CommandLine.Run(args, new(Console.Out, Console.Error, HasTerminal: !Console.IsErrorRedirected));
    }
}
