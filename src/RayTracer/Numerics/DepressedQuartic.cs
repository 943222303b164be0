using System.Numerics;

namespace RayTracer.Numerics;

/// <summary>
/// The polynomial s⁴ + p·s² + q·s + r in each lane. Its sign changes are found without fail: between stationary points, which are the roots of the
/// derivative and lie between the inflections, it rises or falls, and Newton's method, kept within an interval that shrinks, cannot miss
/// (Yuksel 2022). What a lane comes to does not depend on the others.
/// </summary>
/// <param name="p">Factor of s².</param>
/// <param name="q">Factor of s.</param>
/// <param name="r">The constant.</param>
internal readonly struct DepressedQuartic(Vector<double> p, Vector<double> q, Vector<double> r)
{
    // Double roots are approached by halves: as many steps as a double has digits, and some.
    private const int MaxSteps = 64;
    private const double Tolerance = 1.0 / (1L << 46);
    private readonly Vector<double> _p = p, _q = q, _r = r;

    /// <summary>The first place between two where the sign changes; NaN where it does not.</summary>
    /// <param name="begin">The lower end.</param>
    /// <param name="end">The upper end, not below the lower one.</param>
    /// <param name="onlyUpwards">True if only changes from below zero to above count.</param>
    public Vector<double> FirstCrossing(Vector<double> begin, Vector<double> end, bool onlyUpwards)
    {
        Vector<double> inflection = Vector.SquareRoot(Vector.Max(_p * new Vector<double>(-1.0 / 6), Vector<double>.Zero));
        Vector<double> first = Vector.Min(Vector.Max(-inflection, begin), end);
        Vector<double> second = Vector.Min(Vector.Max(inflection, begin), end);
        ReadOnlySpan<Vector<double>> ends = [Stationary(begin, first), Stationary(first, second), Stationary(second, end), end];

        Vector<double> found = new(double.NaN);
        Vector<long> open = Vector<long>.AllBitsSet;
        Vector<double> from = begin;
        Vector<long> wasBelow = Vector.LessThan(Value(from), Vector<double>.Zero);
        foreach (Vector<double> to in ends)
        {
            Vector<long> isBelow = Vector.LessThan(Value(to), Vector<double>.Zero);
            Vector<long> changes = onlyUpwards ? Vector.AndNot(wasBelow, isBelow) : wasBelow ^ isBelow;
            changes &= open;
            if (changes != Vector<long>.Zero)
            {
                found = Vector.ConditionalSelect(changes, Root(from, to, changes, ofSlope: false), found);
                open = Vector.AndNot(open, changes);
            }

            from = to;
            wasBelow = isBelow;
        }

        return found;
    }

    // Where the slope changes its sign between two neighbouring inflections; the upper end where it does not.
    private Vector<double> Stationary(Vector<double> from, Vector<double> to)
    {
        Vector<long> changes = Vector.LessThan(Slope(from), Vector<double>.Zero) ^ Vector.LessThan(Slope(to), Vector<double>.Zero);
        return changes == Vector<long>.Zero ? to : Vector.ConditionalSelect(changes, Root(from, to, changes, ofSlope: true), to);
    }

    // The root of the polynomial or of its slope between two places of different signs.
    private Vector<double> Root(Vector<double> low, Vector<double> high, Vector<long> active, bool ofSlope)
    {
        Vector<double> tolerance = (high - low) * new Vector<double>(Tolerance);
        Vector<double> half = new(0.5);
        Vector<double> s = (low + high) * half;
        Vector<long> startsBelow = Vector.LessThan(ofSlope ? Slope(low) : Value(low), Vector<double>.Zero);
        for (int step = 0; step < MaxSteps; step++)
        {
            Vector<double> value = ofSlope ? Slope(s) : Value(s);
            Vector<double> slope = ofSlope ? Curvature(s) : Slope(s);
            active &= Vector.GreaterThan(Vector.Abs(value), tolerance * Vector.Abs(slope));
            if (active == Vector<long>.Zero)
            {
                break;
            }

            Vector<long> isBeyond = Vector.LessThan(value, Vector<double>.Zero) ^ startsBelow;
            high = Vector.ConditionalSelect(isBeyond, s, high);
            low = Vector.ConditionalSelect(isBeyond, low, s);
            Vector<double> next = s - (value / slope);
            Vector<long> within = Vector.GreaterThan(next, low) & Vector.LessThan(next, high);
            next = Vector.ConditionalSelect(within, next, (low + high) * half);
            s = Vector.ConditionalSelect(active, next, s);
        }

        return s;
    }

    private Vector<double> Value(Vector<double> s) => Fma(Fma(Fma(s, s, _p), s, _q), s, _r);

    private Vector<double> Slope(Vector<double> s) => Fma(Fma(s * s, new(4), _p + _p), s, _q);

    private Vector<double> Curvature(Vector<double> s) => Fma(s * s, new(12), _p + _p);

    private static Vector<double> Fma(Vector<double> a, Vector<double> b, Vector<double> c) => Vector.FusedMultiplyAdd(a, b, c);
}
