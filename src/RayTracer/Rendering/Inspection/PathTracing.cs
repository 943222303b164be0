using System.Numerics;
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

    /// <summary>Where paths come from lights too: the number of ways that are listed, the brightest ones.</summary>
    public int MostWays { get; init; } = 64;

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
        if (scene.Render.Integrator.Has(Description.IntegratorTraits.TracesLight))
        {
            SubpathTracing subpaths = new(scene, x, y, MostWays);
            return [.. Enumerable.Range(samples.First, samples.Count).Select(subpaths.Trace)];
        }

        PathRecorder recorder = new(scene);
        Wavefront wavefront = new(scene, StreamSize, 1, recorder);
        List<TracedPath> paths = [];
        for (int first = samples.First; first < samples.End; first += StreamSize)
        {
            SampleRange block = new(first, Math.Min(samples.End, first + StreamSize));
            wavefront.Observe(new(x, y, 1, 1), block);
            paths.AddRange(recorder.Paths());
        }

        return scene.Filter is { HasWeights: true } ? [.. paths.Select(p => p with { Weight = Weight(x, y, p.Sample) })] : paths;
    }

    private float Weight(int x, int y, int sample) =>
        RayGenerator.Weight(scene, Hash.PixelKey((uint)scene.Render.Seed, (uint)((y * scene.Render.Width) + x)), (uint)sample)[0];
}

/// <summary>A light path from the camera to its end.</summary>
/// <param name="Sample">The sample's number in its pixel.</param>
/// <param name="Radiance">The light that it brings; the film gets this times <see cref="Weight"/>.</param>
/// <param name="Vertices">The things that it meets, in order.</param>
public sealed record TracedPath(int Sample, Rgb Radiance, IReadOnlyList<PathVertex> Vertices)
{
    /// <summary>The weight that the pixel filter gives the radiance: 1, unless it has negative lobes.</summary>
    public float Weight { get; init; } = 1;

    /// <summary>
    /// Where paths come from lights too: the ways in which light came to the pixel in the pass of this sample, the brightest of them.
    /// </summary>
    public IReadOnlyList<TracedWay> Ways { get; init; } = [];
}

/// <summary>A path from a light to the camera, made of a part of each (Veach 1997, section 10.2).</summary>
/// <param name="LightVertices">The vertices from the light, that on the light included; 0 where the camera's path meets it.</param>
/// <param name="CameraVertices">The vertices from the camera, that on the lens included.</param>
/// <param name="IsMerge">True where the last vertices of both are taken for one; else an edge joins them.</param>
/// <param name="Radiance">The light that it brings to the pixel.</param>
/// <param name="Unweighted">The light that it would bring if no other way made such paths: <see cref="Radiance"/> is this, times the weight.</param>
public sealed record TracedWay(int LightVertices, int CameraVertices, bool IsMerge, Rgb Radiance, Rgb Unweighted)
{
    /// <summary>The weight: what this way has of such paths.</summary>
    public float Weight => Unweighted.IsBlack ? 0 : Radiance.Luminance / Unweighted.Luminance;

    /// <summary>The light's number, as in <see cref="Scene.SourceOfLight"/>; −1 where no path starts from it or asks it.</summary>
    public int Light { get; init; } = -1;

    /// <summary>The last vertex of the part from the camera; null where that leaves the scene.</summary>
    public Vector3? CameraEnd { get; init; }

    /// <summary>The last vertex of the part from the light; null where there is none.</summary>
    public Vector3? LightEnd { get; init; }

    /// <summary>The factors whose product, with the weight, is the light that it brings.</summary>
    public IReadOnlyList<TracedFactor> Factors { get; init; } = [];

    /// <summary>The vertices of that part in order, the light's own left out: the first ray starts on it.</summary>
    public IReadOnlyList<PathVertex> LightPath { get; init; } = [];
}

/// <summary>A factor of the light that a way brings.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Value">Its value; numbers are the same in all channels.</param>
public readonly record struct TracedFactor(WayFactor Kind, Rgb Value)
{
    /// <summary>True if the light is divided by it.</summary>
    public bool Divides => Kind == WayFactor.Pdf;
}

/// <summary>What the light of a path is a product of.</summary>
public enum WayFactor
{
    /// <summary>The throughput of the camera's part.</summary>
    CameraPart,

    /// <summary>The BSDF, or phase function, at the end of the camera's part, in 1/sr.</summary>
    CameraBsdf,

    /// <summary>Camera rays per area at what is seen, one for each pixel, with the weight of the pixel filter.</summary>
    Lens,

    /// <summary>The cosines at the ends of the edge between both parts, over its squared length where both ends are given; for merges, what the shading normal makes of it.</summary>
    Geometry,

    /// <summary>The part that is left of the light on that edge: all where nothing is in the way.</summary>
    Left,

    /// <summary>The share of a photon's power that counts at a point: 1 / (N·πr²), with N light paths and the radius r.</summary>
    Kernel,

    /// <summary>The BSDF, or phase function, at the end of the light's part, in 1/sr.</summary>
    LightBsdf,

    /// <summary>The power that the light's part carries.</summary>
    LightPart,

    /// <summary>The radiance of a light that is met or asked; the irradiance of one without extent.</summary>
    Radiance,

    /// <summary>The density of the point of a light that is asked, per steradian, with the probability of the light.</summary>
    Pdf,

    /// <summary>Camera paths for each light path, or the part of all that one is.</summary>
    Paths,

    /// <summary>The weight that the pixel filter gives.</summary>
    Filter,
}
