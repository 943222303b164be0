namespace RayTracer.RenderTests.Oracle;

/// <summary>A closed cylinder, cone or frustum.</summary>
internal sealed class Cone(Material material, Vec bottom, Vec top, double radius, double topRadius)
    : Solid(material, 0.5 * (bottom + top), 1.001 * ((0.5 * (top - bottom).Length) + Math.Max(radius, topRadius)))
{
    private readonly Vec _axis = (top - bottom).Unit;
    private readonly double _height = (top - bottom).Length;

    private double Slant => double.Hypot(_height, radius - topRadius);

    public override (double U, double V) Uv(Vec point)
    {
        (double r, double h, double turn) = Cylindrical(point);
        double along = Vec.Dot(Normal(point), _axis);
        if (Math.Abs(along) < 0.9999)
        {
            return (turn, h / _height);
        }

        double part = r / (2 * (along > 0 ? topRadius : radius));
        double x = Math.Sin(2 * Math.PI * (turn - 0.5)) * part;
        double y = Math.Cos(2 * Math.PI * (turn - 0.5)) * part;
        return (0.5 + (along > 0 ? x : -x), 0.5 - y);
    }

    // Side or an end, by their areas; of the places on each, those with longer circles are taken more often.
    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        double side = Math.PI * (radius + topRadius) * Slant;
        (double low, double high) = (Math.PI * radius * radius, Math.PI * topRadius * topRadius);
        double choice = random.Next() * (side + low + high);
        (double r0, double r1, double h0, double h1) = choice < side ? (radius, topRadius, 0.0, _height)
            : choice < side + low ? (0.0, radius, 0.0, 0.0) : (0.0, topRadius, _height, _height);
        double part = random.Next();
        while (random.Next() * Math.Max(r0, r1) > r0 + (part * (r1 - r0)))
        {
            part = random.Next();
        }

        double angle = 2 * Math.PI * random.Next();
        double r = r0 + (part * (r1 - r0));
        return (bottom + _axis.ToWorld(r * Math.Cos(angle), r * Math.Sin(angle), h0 + (part * (h1 - h0))), side + low + high);
    }

    protected override double Distance(Vec p)
    {
        (double r, double h, _) = Cylindrical(p);
        double nearest = Math.Min(ToLine(r, h, radius, 0, topRadius, _height), Math.Min(ToLine(r, h, 0, 0, radius, 0), ToLine(r, h, 0, _height, topRadius, _height)));
        return h > 0 && h < _height && r < radius + (h / _height * (topRadius - radius)) ? -nearest : nearest;
    }

    private static double ToLine(double x, double y, double ax, double ay, double bx, double by)
    {
        (double dx, double dy) = (bx - ax, by - ay);
        double squared = (dx * dx) + (dy * dy);
        double part = squared > 0 ? Math.Clamp((((x - ax) * dx) + ((y - ay) * dy)) / squared, 0, 1) : 0;
        return double.Hypot(x - ax - (part * dx), y - ay - (part * dy));
    }

    private (double Radius, double Height, double Turn) Cylindrical(Vec p) => Round.Around(p - bottom, _axis);
}
