using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// Follows single samples of a pixel once more, in the same stages as a rendering, and reports what they meet. Each is the same to the bit
/// as in a rendering, since no path depends on others.
/// </summary>
/// <param name="scene">The scene.</param>
public sealed class PathTracing(Scene scene)
{
    private const int StreamSize = SampleAccumulator.MaxSamples;

    /// <summary>Follows some samples of a pixel.</summary>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">The pixel's row.</param>
    /// <param name="samples">The samples.</param>
    /// <returns>Their paths, in the order of the samples.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such pixel or sample.</exception>
    /// <exception cref="NotSupportedException">The integrator's light is not that of single camera paths.</exception>
    public IReadOnlyList<TracedPath> Trace(int x, int y, SampleRange samples)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)x, (uint)scene.Render.Width, nameof(x));
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)y, (uint)scene.Render.Height, nameof(y));
        ArgumentOutOfRangeException.ThrowIfNegative(samples.First, nameof(samples));
        ArgumentOutOfRangeException.ThrowIfGreaterThan(samples.End, scene.Render.SamplesPerPixel, nameof(samples));
        if (scene.Render.Integrator.Has(Description.IntegratorTraits.TracesLight))
        {
            throw new NotSupportedException(
                $"The {scene.Render.Integrator.Name} integrator makes a pixel of many light paths, from the camera and from the lights: to look into them one by one, choose path.");
        }

        PathRecorder recorder = new(scene);
        Wavefront wavefront = new(scene, StreamSize, 1, recorder);
        List<TracedPath> paths = [];
        for (int first = samples.First; first < samples.End; first += StreamSize)
        {
            SampleRange block = new(first, Math.Min(samples.End, first + StreamSize));
            wavefront.Follow(new(x, y, 1, 1), block);
            paths.AddRange(recorder.Paths());
        }

        return scene.Filter is { HasWeights: true } ? [.. paths.Select(p => p with { Weight = Weight(x, y, p.Sample) })] : paths;
    }

    private float Weight(int x, int y, int sample) =>
        RayGenerator.Weight(scene, Hash.PixelKey((uint)scene.Render.Seed, (uint)((y * scene.Render.Width) + x)), (uint)sample)[0];
}

/// <summary>A light path from the camera to its end.</summary>
/// <param name="Sample">The sample's number in its pixel.</param>
/// <param name="Radiance">What it brings; the film gets this times <see cref="Weight"/>.</param>
/// <param name="Vertices">What it meets, in order.</param>
public sealed record TracedPath(int Sample, Rgb Radiance, IReadOnlyList<PathVertex> Vertices)
{
    /// <summary>The weight that the pixel filter gives the radiance: 1, unless it has negative lobes.</summary>
    public float Weight { get; init; } = 1;
}
