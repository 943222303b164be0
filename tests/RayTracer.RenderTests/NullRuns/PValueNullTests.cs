using Xunit.Abstractions;

namespace RayTracer.RenderTests.NullRuns;

/// <summary>The formulas of <see cref="PValues"/>, on numbers whose distribution is known.</summary>
[Trait("Category", "Thorough")]
public class PValueNullTests(ITestOutputHelper output)
{
    [Fact]
    public void P_values_of_means_are_small_no_more_often_than_they_say()
    {
        Random random = new(1 + TestSettings.Seed);
        NullRun.Check("means", output, 100, _ =>
        {
            double[] normal = [.. Enumerable.Range(0, 16).Select(_ => Normal(random))];
            double[] uniform = [.. Enumerable.Range(0, 64).Select(_ => random.NextDouble())];
            double[] wide = [.. Enumerable.Range(0, 8).Select(_ => 5 * Normal(random))];
            return
            [
                ("z of a normal number", PValues.Normal(normal[0])),
                ("t of 16 normal numbers", PValues.Mean(normal, 0)),
                ("t of 64 uniform numbers", PValues.Mean(uniform, 0.5)),
                ("Welch's t of 16 and of 8 numbers of five times the deviation", BlockTest.Welch(Estimate(normal), Estimate(wide))),
                ("the smallest of two", PValues.Smallest([PValues.Normal(normal[0]), PValues.Normal(normal[1])])),
            ];
        });
    }

    [Fact]
    public void P_values_of_counts_are_small_no_more_often_than_they_say()
    {
        Random random = new(2 + TestSettings.Seed);
        NullRun.Check("counts", output, 100, _ =>
        {
            // Cells of shares 1 : 3 : 5 : …, the first of which are so small that they are put together.
            double[] observed = new double[30];
            for (int i = 0; i < 2000; i++)
            {
                observed[(int)(30 * Math.Sqrt(random.NextDouble()))]++;
            }

            double[] expected = [.. Enumerable.Range(0, 30).Select(i => 2000 * ((2 * i) + 1) / 900.0)];
            int successes = Enumerable.Range(0, 500).Count(_ => random.NextDouble() < 0.03);
            return
            [
                ("χ² of 30 cells", PValues.ChiSquared(observed, expected)),
                ("successes of 500 trials", PValues.Binomial(successes, 500, 0.03)),
            ];
        });
    }

    private static BlockEstimate Estimate(double[] values)
    {
        double mean = values.Average();
        return new(mean, values.Sum(v => (v - mean) * (v - mean)) / (values.Length - 1) / values.Length, values.Length - 1);
    }

    // Box & Muller (1958).
    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
