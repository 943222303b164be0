using Xunit.Abstractions;

namespace RayTracer.RenderTests.NullRuns;

/// <summary>
/// Statistical tests where the null hypothesis holds by construction, run again and again with fresh random numbers: p-values below a
/// must be no more frequent than a.
/// </summary>
internal static class NullRun
{
    /// <summary>Runs tests again and again, and checks how often each comes below 0.05, 0.01 and 0.001.</summary>
    /// <param name="test">What is repeated, for messages.</param>
    /// <param name="output">Takes what was counted.</param>
    /// <param name="everyday">How often it is repeated every day; 200 times in a thorough run.</param>
    /// <param name="run">Runs it once, with random numbers that depend on the number of the run, and returns its p-values by name.</param>
    public static void Check(string test, ITestOutputHelper output, int everyday, Func<int, IReadOnlyList<(string Name, double P)>> run)
    {
        var runs = Enumerable.Range(0, TestSettings.Scale(everyday, 200)).Select(run).ToArray();
        Assert.All(Enumerable.Range(0, runs[0].Count), i => Check($"{test}, {runs[0][i].Name}", output, [.. runs.Select(r => r[i].P)]));
    }

    private static void Check(string name, ITestOutputHelper output, double[] pValues)
    {
        foreach (double level in new[] { 0.05, 0.01, 0.001 })
        {
            int below = pValues.Count(p => !(p > level));

            // Fewer are no fault: bounds such as Bonferroni's make p-values too large.
            double p = below <= level * pValues.Length ? 1 : PValues.Binomial(below, pValues.Length, level);
            string found = FormattableString.Invariant($"{name}: {below} of {pValues.Length} p-values up to {level}");
            output.WriteLine(found);
            ErrorBudget.NullRuns.Check(p, found);
        }
    }
}
