using System.Numerics;

namespace RayTracer.Description;

/// <summary>How the samples of a pixel are placed.</summary>
public enum SamplerKind
{
    /// <summary>Owen-scrambled Sobol points.</summary>
    Sobol,

    /// <summary>The report's n×n jittered grid.</summary>
    Jittered,

    /// <summary>The report's uniform grid: the same n×n points in every pixel, which shows aliasing.</summary>
    Regular,

    /// <summary>Independent random numbers.</summary>
    Independent,
}

/// <summary>How light sources that are spheres are sampled.</summary>
public enum SphereLightSampling
{
    /// <summary>Uniformly in the cone of directions in which the sphere is seen.</summary>
    Cone,

    /// <summary>Uniformly over the whole surface, as in the report: half of the points are hidden, which is noisier.</summary>
    Surface,
}

/// <summary>Describes how a scene is rendered: everything that changes the picture, and nothing that does not.</summary>
public sealed record RenderDescription
{
    /// <summary>Width of the picture.</summary>
    [Parameter("Width of the picture.", Unit = "pixels", Minimum = 1, Maximum = 65536)]
    public int Width { get; init; } = 600;

    /// <summary>Height of the picture.</summary>
    [Parameter("Height of the picture.", Unit = "pixels", Minimum = 1, Maximum = 65536)]
    public int Height { get; init; } = 600;

    /// <summary>Number of samples in each pixel.</summary>
    [Parameter("Samples in each pixel. The jittered and regular samplers need a square (1, 4, 9, 16 …).", Minimum = 1, Maximum = 16777216)]
    public int SamplesPerPixel { get; init; } = 16;

    /// <summary>How many diffuse bounces a path may have.</summary>
    [Parameter("How many diffuse bounces a path may have; 0 leaves direct light only.", Minimum = 0, Maximum = 255)]
    public int MaxDiffuseDepth { get; init; } = 4;

    /// <summary>How many specular bounces (mirror, metal, glass) a path may have.</summary>
    [Parameter("How many specular bounces (mirror, metal, glass) a path may have.", Minimum = 0, Maximum = 255)]
    public int MaxSpecularDepth { get; init; } = 4;

    /// <summary>How the samples of a pixel are placed.</summary>
    [Parameter("How the samples of a pixel are placed.")]
    public SamplerKind Sampler { get; init; } = SamplerKind.Sobol;

    /// <summary>How much the surroundings of a pixel's middle count in its colour.</summary>
    [Parameter("How much the surroundings of a pixel's middle count in its colour. Without it, a pixel is the mean of what its square shows.")]
    public FilterDescription Filter { get; init; } = new();

    /// <summary>How sphere lights are sampled.</summary>
    [Parameter("How spheres that shine are sampled: within the cone in which they are seen, or over the whole surface as the report did (noisier).")]
    public SphereLightSampling SphereLightSampling { get; init; } = SphereLightSampling.Cone;

    /// <summary>When the shutter opens and closes, in seconds.</summary>
    [Parameter("When the shutter opens and closes: what moves in between is blurred. Equal times give a sharp picture of that instant.", Unit = "seconds")]
    public Vector2 Shutter { get; init; }

    /// <summary>Pictures a second of an animation.</summary>
    [Parameter("Pictures a second of an animation. A single picture does not depend on it.", Unit = "1/second", Minimum = 0, MinimumIsExclusive = true)]
    public float FramesPerSecond { get; init; } = 24;

    /// <summary>Selects the random numbers.</summary>
    [Parameter("Selects the random numbers: another seed gives another noise of the same picture.", Minimum = 0, Maximum = 4294967295)]
    public long Seed { get; init; }
}
