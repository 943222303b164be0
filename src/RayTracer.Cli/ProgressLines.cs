namespace RayTracer.Cli;

/// <summary>Progress for files and pipes: a line a second.</summary>
internal sealed class ProgressLines(TextWriter error) : ProgressDisplay
{
    private const int Interval = 1000;

    private protected override void Show()
    {
        while (!Wait(Interval))
        {
            error.WriteLine($"{100 * Fraction:F0} %{Pace}");
        }
    }
}
