using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>An even medium that absorbs and scatters light.</summary>
/// <param name="Extinction">Extinction coefficient, per scene unit.</param>
/// <param name="Albedo">What part of that is scattered.</param>
/// <param name="Anisotropy">Mean cosine of the angle of scattering, between −1 and 1.</param>
public sealed record Medium(Rgb Extinction, Rgb Albedo, float Anisotropy);
