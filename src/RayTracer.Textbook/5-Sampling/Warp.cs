namespace RayTracer.Textbook;

/// <summary>
/// Maps from the unit square, whose points are uniform, to what integrals are taken over (Shirley, Nonuniform random point sets via warping, 1992).
/// Directions are in a frame around z.
/// </summary>
public static class Warp
{
    /// <summary>The disk of radius 1, uniformly; near points stay near (Shirley &amp; Chiu, A low distortion map between disk and square, 1997).</summary>
    public static (double X, double Y) Disk((double U, double V) random)
    {
        (double a, double b) = ((2 * random.U) - 1, (2 * random.V) - 1);
        if (a == 0 && b == 0)
        {
            return (0, 0);
        }

        bool isWide = Math.Abs(a) > Math.Abs(b);
        double radius = isWide ? a : b;
        double angle = isWide ? Math.PI / 4 * (b / a) : (Math.PI / 2) - (Math.PI / 4 * (a / b));
        return (radius * Math.Cos(angle), radius * Math.Sin(angle));
    }

    /// <summary>Directions above the surface, in proportion to the cosine: the disk, projected upwards (Malley's method).</summary>
    public static Vector CosineHemisphere((double U, double V) random)
    {
        (double x, double y) = Disk(random);
        return new(x, y, Math.Sqrt(Math.Max(0, 1 - (x * x) - (y * y))));
    }

    /// <summary>The density of <see cref="CosineHemisphere"/>, per steradian.</summary>
    public static double CosineHemispherePdf(double cosine) => Math.Max(cosine, 0) / Math.PI;

    /// <summary>All directions, uniformly: heights of a sphere are uniform (Archimedes). The density is 1/4π.</summary>
    public static Vector Sphere((double U, double V) random) => Around(1 - (2 * random.V), random.U);

    /// <summary>Directions in a cone around z, uniformly.</summary>
    /// <param name="random">Two random numbers.</param>
    /// <param name="height">1 − cosine of the angle to its edge; the density is 1/(2π·height).</param>
    public static Vector Cone((double U, double V) random, double height) => Around(1 - (random.V * height), random.U);

    /// <summary>Directions around z, in proportion to a power of the cosine (report, section 6.2.6).</summary>
    public static Vector CosinePower((double U, double V) random, double exponent) => Around(Math.Pow(1 - random.V, 1 / (exponent + 1)), random.U);

    /// <summary>The density of <see cref="CosinePower"/>, per steradian.</summary>
    public static double CosinePowerPdf(double cosine, double exponent) => cosine > 0 ? (exponent + 1) / (2 * Math.PI) * Math.Pow(cosine, exponent) : 0;

    /// <summary>Barycentric coordinates of the second and third corner of a triangle, uniformly (Turk, Generating random points in triangles, 1990).</summary>
    public static (double OfB, double OfC) Triangle((double U, double V) random)
    {
        double root = Math.Sqrt(random.U);
        return (1 - root, random.V * root);
    }

    private static Vector Around(double z, double turn)
    {
        double r = Math.Sqrt(Math.Max(0, 1 - (z * z)));
        (double sin, double cos) = Math.SinCos(2 * Math.PI * turn);
        return new(r * cos, r * sin, z);
    }
}
