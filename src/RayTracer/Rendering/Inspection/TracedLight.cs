using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// A point of a light that a path asks at a vertex. What it brings is throughput · radiance · BSDF · cosine · transmittance · weight / pdf.
/// </summary>
public sealed record TracedLight
{
    /// <summary>The light's number, as in <see cref="Scene.SourceOfLight"/>.</summary>
    public required int Light { get; init; }

    /// <summary>What became of its light.</summary>
    public required LightOutcome Outcome { get; init; }

    /// <summary>The surface in its way, where it is <see cref="LightOutcome.Blocked"/>.</summary>
    public SurfaceName Blocker { get; init; } = SurfaceName.None;

    /// <summary>The unit direction to the point.</summary>
    public Vector3 Direction { get; init; }

    /// <summary>The distance of the point; infinite for light from far away.</summary>
    public float Distance { get; init; }

    /// <summary>The radiance that it sends; of lights without extent, the irradiance of a surface that faces it.</summary>
    public Rgb Radiance { get; init; }

    /// <summary>
    /// The density with which the point was chosen, in 1/sr, of all points that are asked, with the probability of choosing the light; of lights without
    /// extent, this probability alone.
    /// </summary>
    public float Pdf { get; init; }

    /// <summary>The density with which scattering would have chosen the direction; null where no scattered ray finds the light.</summary>
    public float? ScatterPdf { get; init; }

    /// <summary>The BSDF, or a medium's phase function.</summary>
    public Rgb Bsdf { get; init; }

    /// <summary>The cosine between the direction and the normal; 1 in a medium.</summary>
    public float Cosine { get; init; }

    /// <summary>The share that sampling the light has of what scattered rays find too.</summary>
    public float Weight { get; init; } = 1;

    /// <summary>The fraction of the light that media and transparent things on the way leave.</summary>
    public Rgb Transmittance { get; init; } = Rgb.White;

    /// <summary>The light that it adds to the path, as rendered.</summary>
    public Rgb Contribution { get; init; }
}

/// <summary>What becomes of the light from a point that a path asks.</summary>
public enum LightOutcome
{
    /// <summary>It is added.</summary>
    Arrives,

    /// <summary>The light cannot be seen from there, or sends nothing that way: its point has no density.</summary>
    Unlit,

    /// <summary>The direction is behind the surface.</summary>
    Behind,

    /// <summary>It would come through the surface itself, on whose side the shading normal is not.</summary>
    Leaks,

    /// <summary>The surface scatters none of it towards the path.</summary>
    NotScattered,

    /// <summary>Something is in its way.</summary>
    Blocked,
}

/// <summary>Light that a path meets: what shines is hit, or the surroundings are.</summary>
/// <param name="Light">The light's number; −1 where no path asks it.</param>
/// <param name="Radiance">The radiance that it sends.</param>
/// <param name="ScatterPdf">The density with which the ray's direction was chosen; null where nothing else finds this light.</param>
/// <param name="LightPdf">The density with which the vertex before asks for this direction.</param>
/// <param name="Weight">The share that meeting it by scattering has; 0 where it has been counted before.</param>
public sealed record TracedEmission(int Light, Rgb Radiance, float? ScatterPdf, float? LightPdf, float Weight);

/// <summary>Reasons for which a path ends where it could be scattered.</summary>
public enum PathEnd
{
    /// <summary>It does not.</summary>
    None,

    /// <summary>The scene allows no more edges.</summary>
    Depth,

    /// <summary>It lost the game of chance that ends paths which carry little.</summary>
    Roulette,

    /// <summary>It carries nothing any more.</summary>
    Dark,

    /// <summary>It would go through the surface.</summary>
    Leaks,

    /// <summary>What else comes to it comes by paths from the lights.</summary>
    Gathered,
}
