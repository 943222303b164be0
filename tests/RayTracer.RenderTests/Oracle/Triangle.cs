namespace RayTracer.RenderTests.Oracle;

/// <summary>A triangle, by barycentric coordinates (report, section 3.3.3).</summary>
internal sealed class Triangle(Material material, Vec a, Vec b, Vec c, (double U, double V)[] uv) : Shape(material)
{
    // Normal of the front, where the corners are seen counter-clockwise; twice as long as the area.
    private readonly Vec _cross = Vec.Cross(b - a, c - a);

    public override double Hit(Vec origin, Vec direction, double tMin, double tMax)
    {
        double t = Vec.Dot(a - origin, _cross) / Vec.Dot(direction, _cross);
        if (!(t > tMin && t < tMax))
        {
            return double.NaN;
        }

        (double alpha, double beta, double gamma) = Barycentric(origin + (t * direction));
        return alpha >= 0 && beta >= 0 && gamma >= 0 ? t : double.NaN;
    }

    public override Vec Normal(Vec point) => _cross.Unit;

    public override (double U, double V) Uv(Vec point)
    {
        (double alpha, double beta, double gamma) = Barycentric(point);
        return (
            (alpha * uv[0].U) + (beta * uv[1].U) + (gamma * uv[2].U),
            (alpha * uv[0].V) + (beta * uv[1].V) + (gamma * uv[2].V));
    }

    // A point of the parallelogram, turned back into the triangle where it lies beyond.
    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        double beta = random.Next();
        double gamma = random.Next();
        if (beta + gamma > 1)
        {
            (beta, gamma) = (1 - beta, 1 - gamma);
        }

        return (a + (beta * (b - a)) + (gamma * (c - a)), 0.5 * _cross.Length);
    }

    // Each is the share of the area of the triangle that the point and the other two corners span.
    private (double Alpha, double Beta, double Gamma) Barycentric(Vec point)
    {
        double square = Vec.Dot(_cross, _cross);
        double beta = Vec.Dot(Vec.Cross(point - a, c - a), _cross) / square;
        double gamma = Vec.Dot(Vec.Cross(b - a, point - a), _cross) / square;
        return (1 - beta - gamma, beta, gamma);
    }
}
