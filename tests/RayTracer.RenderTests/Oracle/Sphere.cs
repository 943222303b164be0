namespace RayTracer.RenderTests.Oracle;

/// <summary>A sphere.</summary>
internal sealed class Sphere(Material material, Vec center, double radius) : Shape(material)
{
    public override double Hit(Vec origin, Vec direction, double tMin, double tMax)
    {
        Vec fromCenter = origin - center;
        double a = Vec.Dot(direction, direction);
        double b = Vec.Dot(direction, fromCenter);
        double c = Vec.Dot(fromCenter, fromCenter) - (radius * radius);
        double root = Math.Sqrt((b * b) - (a * c));
        double near = (-b - root) / a;
        double far = (-b + root) / a;
        return near > tMin && near < tMax ? near : far > tMin && far < tMax ? far : double.NaN;
    }

    public override Vec Normal(Vec point) => (point - center).Unit;

    public override (double U, double V) Uv(Vec point)
    {
        Vec n = Normal(point);
        return (0.5 + (Math.Atan2(n.X, n.Z) / (2 * Math.PI)), 0.5 + (Math.Asin(Math.Clamp(n.Y, -1, 1)) / Math.PI));
    }

    // The cap that is seen from a point, so that its disc as seen from far away is covered evenly.
    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        Vec axis = from - center;
        double rim = radius / axis.Length;
        if (rim >= 1)
        {
            return (center, 0);
        }

        double disc = 1 - (rim * rim);
        double cosine = Math.Sqrt(1 - (random.Next() * disc));
        Vec d = random.Around(cosine);
        return (center + (radius * axis.Unit.ToWorld(d.X, d.Y, d.Z)), Math.PI * radius * radius * disc / cosine);
    }
}
