namespace RayTracer.RenderTests.Oracle;

/// <summary>A box parallel to the axes.</summary>
internal sealed class Box(Material material, Vec a, Vec b) : Solid(material, 0.5 * (a + b), 0.5001 * (a - b).Length)
{
    private readonly Vec _half = new(Math.Abs(a.X - b.X) / 2, Math.Abs(a.Y - b.Y) / 2, Math.Abs(a.Z - b.Z) / 2);

    public override (double U, double V) Uv(Vec point)
    {
        Vec p = point - (0.5 * (a + b));
        Vec n = Normal(point);
        (double x, double y, double z) = (p.X / _half.X, p.Y / _half.Y, p.Z / _half.Z);
        (double u, double v) = Math.Abs(n.X) > 0.5 ? (-z * n.X, y) : Math.Abs(n.Y) > 0.5 ? (x * n.Y, -z) : (x * n.Z, y);
        return ((u + 1) / 2, (v + 1) / 2);
    }

    // On one of the six faces, the larger the likelier.
    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        (double x, double y, double z) = (4 * _half.Y * _half.Z, 4 * _half.Z * _half.X, 4 * _half.X * _half.Y);
        double choice = random.Next() * (x + y + z);
        int side = random.Next() < 0.5 ? -1 : 1;
        Vec p = new(2 * random.Centred() * _half.X, 2 * random.Centred() * _half.Y, 2 * random.Centred() * _half.Z);
        p = choice < x ? p with { X = side * _half.X } : choice < x + y ? p with { Y = side * _half.Y } : p with { Z = side * _half.Z };
        return ((0.5 * (a + b)) + p, 2 * (x + y + z));
    }

    protected override double Distance(Vec p)
    {
        Vec q = p - (0.5 * (a + b));
        Vec beyond = new(Math.Abs(q.X) - _half.X, Math.Abs(q.Y) - _half.Y, Math.Abs(q.Z) - _half.Z);
        double inside = Math.Max(beyond.X, Math.Max(beyond.Y, beyond.Z));
        return inside < 0 ? inside : new Vec(Math.Max(beyond.X, 0), Math.Max(beyond.Y, 0), Math.Max(beyond.Z, 0)).Length;
    }
}
