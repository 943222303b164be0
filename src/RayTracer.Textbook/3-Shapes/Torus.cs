namespace RayTracer.Textbook;

/// <summary>A torus around the y axis; placed elsewhere by <see cref="Placed"/>.</summary>
/// <param name="radius">From the middle to that of the tube.</param>
/// <param name="tube">Radius of the tube.</param>
public sealed class Torus(double radius, double tube) : IShape
{
    /// <inheritdoc/>
    public Bounds Bounds => new(new(-radius - tube, -tube, -radius - tube), new(radius + tube, tube, radius + tube));

    /// <inheritdoc/>
    public double Area => 4 * Math.PI * Math.PI * radius * tube;

    /// <summary>
    /// Points of the tube satisfy (|P|² + R² − r²)² = 4R²(x² + z²): with P = O + t·D, an equation of the fourth degree in t (Hanrahan, A
    /// survey of ray-surface intersection algorithms, 1989).
    /// </summary>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        double begin = 0;
        double end = hit.Distance;
        if (!Bounds.Cut(ray, ref begin, ref end))
        {
            return false;
        }

        // From where the ray enters the box, so that far origins cost no digits.
        Vector o = ray.At(begin);
        Vector d = ray.Direction;
        double dd = Vector.Dot(d, d);
        double od = Vector.Dot(o, d);
        double k = Vector.Dot(o, o) + (radius * radius) - (tube * tube);
        double ring = 4 * radius * radius;
        ReadOnlySpan<double> polynomial =
        [
            (k * k) - (ring * ((o.X * o.X) + (o.Z * o.Z))),
            (4 * k * od) - (2 * ring * ((o.X * d.X) + (o.Z * d.Z))),
            (4 * od * od) + (2 * k * dd) - (ring * ((d.X * d.X) + (d.Z * d.Z))),
            4 * od * dd,
            dd * dd,
        ];
        if (Polynomial.FirstRoot(polynomial, 0, end - begin) is not { } t || !(begin + t > 0))
        {
            return false;
        }

        hit.Distance = begin + t;
        return true;
    }

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        Vector p = ray.At(hit.Distance);
        SurfacePoint at = At(Math.Atan2(p.X, p.Z), Math.Atan2(p.Y, Math.Sqrt((p.X * p.X) + (p.Z * p.Z)) - radius));
        (hit.Point, hit.Normal, hit.Shading, hit.U, hit.V) = (at.Point, at.Normal, at.Normal, at.U, at.V);
    }

    /// <summary>
    /// Uniform by area: circles around the axis are longer on the outer side of the tube, in proportion to R + r·cos, so that its angle is
    /// accepted with that probability, or mirrored to the other side, whose chance makes up for it.
    /// </summary>
    public SurfacePoint PointAt((double U, double V) random)
    {
        // The angle and its mirror image on the inner side together have the same share everywhere.
        double angle = (random.V * 4 % 1) * Math.PI / 2;
        int quarter = (int)Math.Min(random.V * 4, 3);
        double outer = (radius + (tube * Math.Cos(angle))) / (2 * radius);
        double u = random.U;
        bool isOuter = u < outer;
        double turn = isOuter ? u / outer : (u - outer) / (1 - outer);
        double around = isOuter ? angle : Math.PI - angle;
        return At(2 * Math.PI * turn, quarter % 2 == 0 ? around : -around);
    }

    // u once around the axis, v once around the tube: from the inner side over the bottom, the outer side and the top.
    private SurfacePoint At(double around, double tubeAngle)
    {
        (double sin, double cos) = Math.SinCos(around);
        (double up, double outwards) = Math.SinCos(tubeAngle);
        Vector normal = new(sin * outwards, up, cos * outwards);
        Vector point = new Vector(sin * radius, 0, cos * radius) + (tube * normal);
        return new(point, normal, Turn(0.5 + (around / (2 * Math.PI))), Turn(0.5 + (tubeAngle / (2 * Math.PI))), 1 / Area);
    }

    private static double Turn(double turns) => turns - Math.Floor(turns);
}

/// <summary>Zeros of polynomials.</summary>
internal static class Polynomial
{
    /// <summary>
    /// The smallest zero in an interval, null where there is none. Between two zeros of the derivative a polynomial only rises or only falls, so
    /// that it has one zero there or none, which halving finds; those of the derivative are found in the same way.
    /// </summary>
    /// <param name="coefficients">From the constant to the highest power, up to the fourth.</param>
    /// <param name="from">Where the interval begins.</param>
    /// <param name="to">Where it ends.</param>
    public static double? FirstRoot(ReadOnlySpan<double> coefficients, double from, double to)
    {
        Span<double> turns = stackalloc double[4];
        int count = Turns(coefficients, from, to, turns);
        double left = from;
        for (int i = 0; i <= count; i++)
        {
            double right = i < count ? turns[i] : to;
            if (RootBetween(coefficients, left, right) is { } root)
            {
                return root;
            }

            left = right;
        }

        return null;
    }

    // The zeros of the derivative within the interval, in their order.
    private static int Turns(ReadOnlySpan<double> coefficients, double from, double to, Span<double> turns)
    {
        int degree = coefficients.Length - 1;
        if (degree < 2)
        {
            return 0;
        }

        Span<double> derivative = stackalloc double[degree];
        for (int i = 0; i < degree; i++)
        {
            derivative[i] = (i + 1) * coefficients[i + 1];
        }

        Span<double> inner = stackalloc double[4];
        int count = Turns(derivative, from, to, inner);
        int found = 0;
        double left = from;
        for (int i = 0; i <= count; i++)
        {
            double right = i < count ? inner[i] : to;
            if (RootBetween(derivative, left, right) is { } root)
            {
                turns[found++] = root;
            }

            left = right;
        }

        return found;
    }

    // Newton's steps, or halving where they would leave the interval.
    private static double? RootBetween(ReadOnlySpan<double> p, double left, double right)
    {
        double atLeft = Value(p, left, out _);
        double atRight = Value(p, right, out _);
        if (!(atLeft < 0 != atRight < 0))
        {
            return null;
        }

        double t = 0.5 * (left + right);
        for (int step = 0; step < 100; step++)
        {
            double value = Value(p, t, out double slope);
            (left, right) = value < 0 == atLeft < 0 ? (t, right) : (left, t);
            double next = t - (value / slope);
            next = next > left && next < right ? next : 0.5 * (left + right);
            if (Math.Abs(next - t) <= 1e-15 * Math.Abs(t) || next == left || next == right)
            {
                return next;
            }

            t = next;
        }

        return t;
    }

    // Horner's rule.
    private static double Value(ReadOnlySpan<double> p, double t, out double slope)
    {
        double value = 0;
        slope = 0;
        for (int i = p.Length - 1; i >= 0; i--)
        {
            slope = (slope * t) + value;
            value = (value * t) + p[i];
        }

        return value;
    }
}
