using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>A light path from the camera to its end.</summary>
/// <param name="Sample">The sample's number in its pixel.</param>
/// <param name="Radiance">What it brings; the film gets this times <see cref="Weight"/>.</param>
/// <param name="Vertices">What it meets, in order.</param>
public sealed record TracedPath(int Sample, Rgb Radiance, IReadOnlyList<PathVertex> Vertices)
{
    /// <summary>The weight that the pixel filter gives the radiance: 1, unless it has negative lobes.</summary>
    public float Weight { get; init; } = 1;
}
