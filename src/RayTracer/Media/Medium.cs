using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Media;

/// <summary>A medium that absorbs and scatters light.</summary>
/// <param name="Extinction">Extinction coefficient, per scene unit.</param>
/// <param name="Albedo">The part of the extinction that is scattered.</param>
/// <param name="Anisotropy">Mean cosine of the angle of scattering, between −1 and 1.</param>
public sealed record Medium(Rgb Extinction, Rgb Albedo, float Anisotropy)
{
    /// <summary>What varies in space; null where the medium is even.</summary>
    internal VaryingMedium? Varying { get; init; }

    /// <summary>The light that an even medium sends for each unit of length.</summary>
    internal Rgb Emission { get; init; }

    /// <summary>How it spreads what it scatters over directions; null for Henyey and Greenstein's phase function, by <see cref="Anisotropy"/>.</summary>
    internal PhaseFunction? Phase { get; init; }

    /// <summary>The flakes that scatter instead; null for none.</summary>
    internal Microflakes? Flakes { get; init; }
}

/// <summary>The inside of a shape.</summary>
/// <param name="Medium">The medium inside; null for nothing.</param>
/// <param name="Nesting">Its priority among others that overlap it; null for a boundary whose index is relative to what is around.</param>
public sealed record Interior(Medium? Medium, Nesting? Nesting);

/// <summary>
/// The priority of a dielectric's inside among others that overlap it (Schmidt &amp; Budge, Simple nested dielectrics in ray traced images,
/// 2002).
/// </summary>
/// <param name="Priority">The priority, above 0: where several overlap, the one with the highest is there.</param>
/// <param name="Index">Refractive index, relative to empty space.</param>
/// <param name="Extinction">Extinction coefficient of what only absorbs, per scene unit.</param>
public sealed record Nesting(int Priority, Dispersion Index, Rgb Extinction);
