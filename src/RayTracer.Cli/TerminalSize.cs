namespace RayTracer.Cli;

/// <summary>The size of a terminal in letters.</summary>
/// <param name="Columns">Beside each other.</param>
/// <param name="Rows">Below each other.</param>
internal readonly record struct TerminalSize(int Columns, int Rows)
{
    private static readonly TerminalSize s_standard = new(80, 24);

    /// <summary>The size of the terminal of this process; 80×24 where there is none, or it does not say.</summary>
    public static TerminalSize Current
    {
        get
        {
            try
            {
                return Console.WindowWidth < 1 || Console.WindowHeight < 1 ? s_standard : new(Console.WindowWidth, Console.WindowHeight);
            }
            catch (IOException)
            {
                return s_standard;
            }
        }
    }
}
