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

    /// <summary>The middles of a grid's cells, 2^<paramref name="sideBits"/> a side.</summary>
    public static void OnGrid(int sideBits, PointVisitor visit) => ForEach(new GridSampler(sideBits), 0, visit);

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
