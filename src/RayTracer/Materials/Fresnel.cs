using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>The reflectance of smooth boundaries.</summary>
public static class Fresnel
{
    /// <summary>
    /// Schlick's approximation, R0 + (1 − R0)(1 − cos)⁵ (An inexpensive BRDF model for physically-based rendering, 1994, eq. 24).
    /// </summary>
    /// <param name="cosine">Cosine of the angle on the side of the thinner medium, 0 to 1.</param>
    /// <param name="r0">Reflectance at normal incidence.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Schlick(FloatW cosine, FloatW r0)
    {
        FloatW x = FloatW.Max(1f - cosine, 0f);
        FloatW x2 = x * x;
        return FloatW.MultiplyAdd(x2 * x2 * x, 1f - r0, r0);
    }

    /// <summary>
    /// Reflectance of unpolarised light at the boundary of two dielectrics (Born &amp; Wolf, Principles of Optics, 7th ed.
    /// 1999, section 1.5.2).
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

    /// <summary>As above, where Snell's law still is to be applied: 1 in total reflection.</summary>
    /// <param name="cosIncident">Cosine of incidence, 0 to 1.</param>
    /// <param name="eta">Refractive index of the incident medium over that of the transmitted one.</param>
    /// <param name="cosTransmitted">Cosine of refraction; 0 in total reflection.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Dielectric(FloatW cosIncident, FloatW eta, out FloatW cosTransmitted)
    {
        FloatW sin2 = eta * eta * FloatW.Max(FloatW.NegatedMultiplyAdd(cosIncident, cosIncident, 1f), 0f);
        cosTransmitted = FloatW.Sqrt(FloatW.Max(1f - sin2, 0f));
        return (sin2 >= 1f).Select(1f, Dielectric(cosIncident, cosTransmitted, eta));
    }

    /// <summary>
    /// The mean reflectance of light from all directions alike: twice the integral of reflectance · cosine over the cosine.
    /// </summary>
    /// <param name="eta">Refractive index of the incident medium over that of the transmitted one.</param>
    public static float DiffuseReflectance(float eta)
    {
        // The midpoint rule in the angle's sine squared, which is even over the light; up to the critical angle, beyond which all is
        // reflected.
        const int Count = 1 << 14;
        double limit = eta > 1 ? 1 / ((double)eta * eta) : 1;
        double sum = 0;
        for (int i = 0; i < Count; i++)
        {
            double t = (i + 0.5) / Count;

            // Near the end the reflectance grows as a square root: steps are narrower there.
            double sin2 = limit * (1 - (t * t));
            double cosIncident = Math.Sqrt(1 - sin2);
            double cosTransmitted = Math.Sqrt(Math.Max(0, 1 - (sin2 * eta * eta)));
            double parallel = (cosIncident - (eta * cosTransmitted)) / (cosIncident + (eta * cosTransmitted));
            double perpendicular = ((eta * cosIncident) - cosTransmitted) / ((eta * cosIncident) + cosTransmitted);
            sum += ((parallel * parallel) + (perpendicular * perpendicular)) * t / Count;
        }

        return (float)((limit * sum) + 1 - limit);
    }
}
