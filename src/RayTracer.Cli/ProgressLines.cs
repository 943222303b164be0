using System.Diagnostics;

namespace RayTracer.Cli;

/// <summary>Progress for files and pipes: a line a second at first, then one each time that a tenth more has passed, and each minute.</summary>
internal sealed class ProgressLines(TextWriter error) : ProgressDisplay
{
    private protected override void Show()
    {
        Stopwatch watch = Stopwatch.StartNew();
        while (!Wait((int)double.Clamp(watch.Elapsed.TotalMilliseconds / 10, 1000, 60_000)))
        {
            error.WriteLine($"{100 * Fraction:F0} %{Pace}");
        }
    }
}
