namespace RayTracer.RenderTests.Oracle;

/// <summary>
/// A closed surface that is known by how far points are from it: rays walk as far as is safe, until they are on the other side
/// (Hart 1996), and normals are differences. No equation is solved.
/// </summary>
/// <param name="material">What it is made of.</param>
/// <param name="center">The middle of a sphere around it.</param>
/// <param name="reach">Radius of that sphere.</param>
internal abstract class Solid(Material material, Vec center, double reach) : Shape(material)
{
    private const double ShortestStep = 1e-7;

    protected Vec Center => center;

    public override double Hit(Vec origin, Vec direction, double tMin, double tMax)
    {
        double length = direction.Length;
        Vec unit = direction / length;
        double nearest = Vec.Dot(center - origin, unit);
        Vec off = origin + (nearest * unit) - center;
        double end = Math.Min(tMax * length, nearest + reach);
        if (Vec.Dot(off, off) > reach * reach || end < 0)
        {
            return double.NaN;
        }

        double before = tMin * length;
        double side = Math.Sign(Distance(origin + (before * unit)));
        for (double t = before; t < end; before = t)
        {
            t += Math.Max(ShortestStep, Math.Abs(Distance(origin + (t * unit))));
            if (Distance(origin + (t * unit)) * side < 0)
            {
                double found = Bisect(before, t, s => Distance(origin + (s * unit)) * side) / length;
                return found < tMax ? found : double.NaN;
            }
        }

        return double.NaN;
    }

    public override Vec Normal(Vec point)
    {
        const double step = 1e-6;
        double Along(Vec axis) => Distance(point + (step * axis)) - Distance(point - (step * axis));
        return new Vec(Along(new(1, 0, 0)), Along(new(0, 1, 0)), Along(new(0, 0, 1))).Unit;
    }

    /// <summary>Distance of a point from the surface, negative inside.</summary>
    protected abstract double Distance(Vec p);

    private static double Bisect(double low, double high, Func<double, double> value)
    {
        for (int i = 0; i < 50; i++)
        {
            double middle = (low + high) / 2;
            (low, high) = value(middle) > 0 ? (middle, high) : (low, middle);
        }

        return low;
    }
}
