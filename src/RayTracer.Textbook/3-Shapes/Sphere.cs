namespace RayTracer.Textbook;

/// <summary>A sphere (report, section 3.3.5).</summary>
/// <param name="center">The centre.</param>
/// <param name="radius">The radius.</param>
public sealed class Sphere(Vector center, double radius) : IShape
{
    /// <inheritdoc/>
    public Bounds Bounds { get; } = new Bounds(center, center).Grown(radius);

    /// <inheritdoc/>
    public double Area => 4 * Math.PI * radius * radius;

    /// <summary>
    /// By algebra: |O + t·D − C|² = r² is a quadratic equation in t. The discriminant is computed from the distance between centre and ray, since
    /// b² − 4ac loses all its digits for small spheres far away (Haines et al. 2019).
    /// </summary>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        Vector toCenter = center - ray.Origin;
        double a = Vector.Dot(ray.Direction, ray.Direction);
        double middle = Vector.Dot(toCenter, ray.Direction) / a;
        Vector off = toCenter - (middle * ray.Direction);
        double square = (radius * radius) - Vector.Dot(off, off);
        if (square < 0)
        {
            return false;
        }

        double half = Math.Sqrt(square / a);
        double t = middle - half > 0 ? middle - half : middle + half;
        if (!(t > 0 && t < hit.Distance))
        {
            return false;
        }

        hit.Distance = t;
        return true;
    }

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        Vector normal = (ray.At(hit.Distance) - center).Unit;
        hit.Point = center + (radius * normal);
        hit.Normal = hit.Shading = normal;
        (hit.U, hit.V) = Uv(normal);
    }

    /// <inheritdoc/>
    public SurfacePoint PointAt((double U, double V) random) => At(Warp.Sphere(random), 1 / Area);

    /// <summary>Uniformly in the cone of directions in which the sphere is seen (Shirley, Wang &amp; Zimmerman 1996, section 3.2).</summary>
    public (SurfacePoint Point, double Pdf) PointSeenFrom(Vector from, (double U, double V) random)
    {
        Vector toCenter = center - from;
        double distance2 = Vector.Dot(toCenter, toCenter);
        double rim2 = radius * radius / distance2;
        if (rim2 >= 1)
        {
            // From inside it shines on nothing.
            return (At(Warp.Sphere(random), 1 / Area), 0);
        }

        Vector local = Warp.Cone(random, RimHeight(rim2));
        double sin2 = (local.X * local.X) + (local.Y * local.Y);
        double t = (Math.Sqrt(distance2) * local.Z) - Math.Sqrt(Math.Max(0, (radius * radius) - (distance2 * sin2)));
        Vector point = from + (t * new Frame(toCenter.Unit).ToWorld(local));
        return (At((point - center).Unit, 1 / Area), 1 / (2 * Math.PI * RimHeight(rim2)));
    }

    /// <inheritdoc/>
    public double SeenPdf(Vector from, in Hit hit)
    {
        Vector toCenter = center - from;
        double rim2 = radius * radius / Vector.Dot(toCenter, toCenter);
        return rim2 < 1 ? 1 / (2 * Math.PI * RimHeight(rim2)) : 0;
    }

    // 1 − cos of the angle to the rim, without cancellation for small spheres.
    private static double RimHeight(double sin2) => sin2 / (1 + Math.Sqrt(1 - sin2));

    private SurfacePoint At(Vector normal, double pdf)
    {
        (double u, double v) = Uv(normal);
        return new(center + (radius * normal), normal, u, v, pdf);
    }

    // Longitude and latitude.
    private static (double U, double V) Uv(Vector n) => (0.5 + (Math.Atan2(n.X, n.Z) / (2 * Math.PI)), Math.Acos(Math.Clamp(-n.Y, -1, 1)) / Math.PI);
}
