namespace RayTracer.RenderTests.Oracle;

/// <summary>A torus.</summary>
internal sealed class Torus(Material material, Vec center, Vec axis, double radius, double tube) : Solid(material, center, 1.001 * (radius + tube))
{
    private readonly Vec _axis = axis.Unit;

    public override bool MayHideItself => true;

    public override (double U, double V) Uv(Vec point)
    {
        (double r, double h, double turn) = Round.Around(point - Center, _axis);
        return (turn, 0.5 + (Math.Atan2(h, r - radius) / (2 * Math.PI)));
    }

    // Of circles around the axis, the longer ones are taken more often.
    public override (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random)
    {
        double angle;
        do
        {
            angle = 2 * Math.PI * random.Next();
        }
        while (random.Next() * (radius + tube) > radius + (tube * Math.Cos(angle)));

        double turn = 2 * Math.PI * random.Next();
        double r = radius + (tube * Math.Cos(angle));
        return (Center + _axis.ToWorld(r * Math.Cos(turn), r * Math.Sin(turn), tube * Math.Sin(angle)), 4 * Math.PI * Math.PI * radius * tube);
    }

    protected override double Distance(Vec p)
    {
        (double r, double h, _) = Round.Around(p - Center, _axis);
        return double.Hypot(r - radius, h) - tube;
    }
}
