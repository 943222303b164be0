using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>How much a smooth boundary reflects.</summary>
public static class Fresnel
{
    /// <summary>Schlick's approximation, R0 + (1 − R0)(1 − cos)⁵ (An inexpensive BRDF model for physically-based rendering, 1994, eq. 24).</summary>
    /// <param name="cosine">Cosine of the angle on the side of the thinner medium, 0 to 1.</param>
    /// <param name="r0">Reflectance at normal incidence.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Schlick(FloatW cosine, float r0)
    {
        FloatW x = FloatW.Max(1f - cosine, 0f);
        FloatW x2 = x * x;
        return FloatW.MultiplyAdd(x2 * x2 * x, 1f - r0, r0);
    }

    /// <summary>
    /// Reflectance of unpolarised light at the boundary of two dielectrics (Born &amp; Wolf, Principles of Optics, 7th ed.
    /// 1999, section 1.5.2, eq. 21a).
    /// </summary>
    /// <param name="cosIncident">Cosine of incidence, 0 to 1.</param>
    /// <param name="cosTransmitted">Cosine of refraction by Snell's law, 0 to 1.</param>
    /// <param name="eta">Refractive index of the incident medium over that of the transmitted one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Dielectric(FloatW cosIncident, FloatW cosTransmitted, FloatW eta)
    {
        FloatW parallel = (cosIncident - eta * cosTransmitted) / (cosIncident + eta * cosTransmitted);
        FloatW perpendicular = (eta * cosIncident - cosTransmitted) / (eta * cosIncident + cosTransmitted);
        return FloatW.MultiplyAdd(parallel, parallel, perpendicular * perpendicular) * 0.5f;
    }
}
