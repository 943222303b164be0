using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Statistics;

/// <summary>Takes one point of a packet of points of the unit square.</summary>
/// <param name="u">First coordinates.</param>
/// <param name="v">Second coordinates.</param>
/// <param name="lane">Which point.</param>
internal delegate void PointVisitor(FloatW u, FloatW v, int lane);

/// <summary>Points of the unit square.</summary>
internal static class UnitSquare
{
    /// <summary>Independent random points.</summary>
    public static void AtRandom(int count, PointVisitor visit) =>
        ForEach(new IndependentSampler(count), Hash.PixelKey((uint)TestSettings.Seed, 0), visit);

    /// <summary>One point in each of a grid's cells, 2^<paramref name="sideBits"/> a side: <see cref="GridSampler"/>.</summary>
    public static void OnGrid(int sideBits, PointVisitor visit) => ForEach(new GridSampler(sideBits), 0, visit);

    /// <summary>
    /// Fails unless a map of the square to itself preserves areas: the mean of s, t, s², t² and s·t over a fine grid. It has no
    /// noise, so it sees what a χ² test of as many points does not.
    /// </summary>
    /// <param name="what">What the map is, for the message.</param>
    /// <param name="map">The map, of one lane of a packet.</param>
    public static void AssertPreservesArea(string what, Func<FloatW, FloatW, int, (double S, double T)> map)
    {
        double[] expected = [0.5, 0.5, 1 / 3.0, 1 / 3.0, 0.25];
        double[] mean = new double[5];
        OnGrid(9, (u, v, lane) =>
        {
            (double s, double t) = map(u, v, lane);
            double[] terms = [s, t, s * s, t * t, s * t];
            for (int k = 0; k < terms.Length; k++)
            {
                mean[k] += terms[k] / (512 * 512);
            }
        });
        for (int k = 0; k < mean.Length; k++)
        {
            Assert.True(Math.Abs(mean[k] - expected[k]) < 5e-4, $"{what}: moment {k} is {mean[k]:G6} instead of {expected[k]:G6}");
        }
    }

    private static void ForEach(Sampler sampler, uint key, PointVisitor visit)
    {
        VertexSamples samples = new(sampler);
        for (int first = 0; first < sampler.SamplesPerPixel; first += FloatW.Count)
        {
            samples.Begin(key, UIntW.Iota + (uint)first, 0u);
            samples.Direction(out FloatW u, out FloatW v);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                visit(u, v, lane);
            }
        }
    }
}
