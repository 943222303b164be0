namespace RayTracer.RenderTests.Oracle;

/// <summary>A disk: what of a square lies within its circle.</summary>
internal sealed class Disk(Material material, Vec center, Vec normal, double radius) : Shape(material)
{
    private readonly Plane _square = new(material, center, normal, (2 * radius, 2 * radius));

    public override double Hit(Vec origin, Vec direction, double tMin, double tMax)
    {
        double t = _square.Hit(origin, direction, tMin, tMax);
        return (origin + (t * direction) - center).Length <= radius ? t : double.NaN;
    }

    public override Vec Normal(Vec point) => _square.Normal(point);

    public override (double U, double V) Uv(Vec point) => _square.Uv(point);

    // Points of the square, until one lies within.
    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        Vec point;
        do
        {
            point = _square.RandomPoint(from, random).Point;
        }
        while ((point - center).Length > radius);

        return (point, Math.PI * radius * radius);
    }
}
