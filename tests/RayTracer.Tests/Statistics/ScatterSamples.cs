using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Statistics;

/// <summary>Takes one scattered path of a packet.</summary>
/// <param name="scatter">The packet.</param>
/// <param name="lane">Which path.</param>
internal delegate void ScatterVisitor(in ScatterW scatter, int lane);

/// <summary>Calls of <see cref="Material.Scatter"/>.</summary>
internal static class ScatterSamples
{
    /// <summary>Scatters once for each cell of a grid of 2^<paramref name="sideBits"/> cells a side.</summary>
    public static void OnGrid(Material material, in SurfaceW surface, int sideBits, ScatterVisitor visit) =>
        ForEach(material, surface, new GridSampler(sideBits), 0, visit);

    /// <summary>Scatters with independent random numbers.</summary>
    /// <param name="material">The material.</param>
    /// <param name="surface">Where.</param>
    /// <param name="count">How often.</param>
    /// <param name="stream">Numbers of different streams are independent.</param>
    /// <param name="visit">Takes each path.</param>
    public static void AtRandom(Material material, in SurfaceW surface, int count, int stream, ScatterVisitor visit) =>
        ForEach(material, surface, new IndependentSampler(count), Hash.PixelKey((uint)TestSettings.Seed, (uint)stream), visit);

    private static void ForEach(Material material, in SurfaceW surface, Sampler sampler, uint key, ScatterVisitor visit)
    {
        VertexSamples samples = new(sampler);
        for (int first = 0; first < sampler.SamplesPerPixel; first += FloatW.Count)
        {
            samples.Begin(key, UIntW.Iota + (uint)first, 0u);
            material.Scatter(surface, samples, out ScatterW scatter);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                visit(scatter, lane);
            }
        }
    }
}
