namespace RayTracer.Textbook;

/// <summary>What happens to light at a smooth boundary: reflection, refraction, and how much of each (report, section 4.2.3).</summary>
public static class Refraction
{
    /// <summary>The mirror image of a direction: the angle to the normal (0, 0, 1) stays the same, on the other side of it.</summary>
    public static Vector Reflect(Vector from) => new(-from.X, -from.Y, from.Z);

    /// <summary>
    /// The direction on the other side of the surface, by Snell's law: the sine is eta times as large. Null in total reflection, where that would be
    /// above 1.
    /// </summary>
    /// <param name="from">Where the light comes from, above the surface.</param>
    /// <param name="eta">The refractive index on the side of <paramref name="from"/> over that of the other.</param>
    public static Vector? Refract(Vector from, double eta)
    {
        double sin2 = eta * eta * (1 - (from.Z * from.Z));
        return sin2 >= 1 ? null : new Vector(-eta * from.X, -eta * from.Y, -Math.Sqrt(1 - sin2));
    }

    /// <summary>How much unpolarised light is reflected where two clear media meet (Fresnel; Born &amp; Wolf, Principles of Optics, 7th ed. 1999, section 1.5.2).</summary>
    /// <param name="cosIncident">Cosine of the angle from which light comes.</param>
    /// <param name="cosTransmitted">Cosine of the angle of refraction.</param>
    /// <param name="eta">The refractive index on the side from which light comes, over that of the other.</param>
    public static double Fresnel(double cosIncident, double cosTransmitted, double eta)
    {
        double parallel = (cosIncident - (eta * cosTransmitted)) / (cosIncident + (eta * cosTransmitted));
        double perpendicular = ((eta * cosIncident) - cosTransmitted) / ((eta * cosIncident) + cosTransmitted);
        return 0.5 * ((parallel * parallel) + (perpendicular * perpendicular));
    }

    /// <summary>Schlick's approximation of it (An inexpensive BRDF model for physically-based rendering, 1994, eq. 24).</summary>
    /// <param name="cosine">Cosine of the angle on the side of the lower index.</param>
    /// <param name="r0">How much is reflected of light along the normal.</param>
    public static double Schlick(double cosine, double r0) => r0 + ((1 - r0) * Math.Pow(Math.Clamp(1 - cosine, 0, 1), 5));

    /// <summary>How much a metal reflects (Born &amp; Wolf, section 14.4, in the form of its absolute squares).</summary>
    /// <param name="cosine">Cosine of the angle from which light comes.</param>
    /// <param name="eta">Real part of the refractive index.</param>
    /// <param name="k">Imaginary part: how fast light fades in the metal.</param>
    public static double Metal(double cosine, double eta, double k)
    {
        // a² + b² is the squared magnitude of √((n + ik)² − sin²), and a its real part.
        double cos2 = cosine * cosine;
        double sin2 = 1 - cos2;
        double real = (eta * eta) - (k * k) - sin2;
        double square = Math.Sqrt((real * real) + (4 * eta * eta * k * k));
        double twoA = 2 * cosine * Math.Sqrt(Math.Max(0, 0.5 * (square + real)));
        double perpendicular = (square + cos2 - twoA) / (square + cos2 + twoA);
        double product = (square * cos2) + (sin2 * sin2);
        double parallel = perpendicular * (product - (twoA * sin2)) / (product + (twoA * sin2));
        return 0.5 * (parallel + perpendicular);
    }
}
