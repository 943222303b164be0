namespace RayTracer.RenderTests.Oracle;

/// <summary>A rectangle by a corner and two edges: two triangles.</summary>
internal sealed class Parallelogram(Material material, Vec corner, Vec edgeU, Vec edgeV) : Shape(material)
{
    private readonly Triangle _first = new(material, corner, corner + edgeU, corner + edgeU + edgeV, [(0, 0), (1, 0), (1, 1)]);
    private readonly Triangle _second = new(material, corner, corner + edgeU + edgeV, corner + edgeV, [(0, 0), (1, 1), (0, 1)]);

    public override double Hit(Vec origin, Vec direction, double tMin, double tMax)
    {
        double t = _first.Hit(origin, direction, tMin, tMax);
        return double.IsNaN(t) ? _second.Hit(origin, direction, tMin, tMax) : t;
    }

    public override Vec Normal(Vec point) => _first.Normal(point);

    // Barycentric coordinates go on beyond a triangle.
    public override (double U, double V) Uv(Vec point) => _first.Uv(point);

    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        (Vec point, double half) = (random.Next() < 0.5 ? _first : _second).RandomPoint(from, random);
        return (point, 2 * half);
    }
}
