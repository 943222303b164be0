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
    public IReadOnlyList<TracedPath> Trace(int x, int y, SampleRange samples)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)x, (uint)scene.Render.Width, nameof(x));
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)y, (uint)scene.Render.Height, nameof(y));
        ArgumentOutOfRangeException.ThrowIfNegative(samples.First, nameof(samples));
        ArgumentOutOfRangeException.ThrowIfGreaterThan(samples.End, scene.Render.SamplesPerPixel, nameof(samples));
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
