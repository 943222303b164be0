namespace RayTracer.Cli;

/// <summary>The statuses that the command returns to the shell.</summary>
internal static class ExitStatus
{
    public const int Fine = 0;
    public const int Different = 1;
    public const int Usage = 2;
    public const int Scene = 3;
    public const int InputOutput = 4;
    public const int Noisy = 5;
    public const int Internal = 70;
    public const int HungUp = 129;
    public const int Interrupted = 130;
    public const int Terminated = 143;

    /// <summary>The list for <c>--help</c>.</summary>
    public const string Help = """
        Exit status: 0 fine, 1 comparison differs, 2 wrong usage, 3 bad scene, 4 input, output or memory,
        5 limit before the wanted noise, 70 internal error, 129 SIGHUP, 130 Ctrl-C, 143 SIGTERM.
        """;
}
