using System.Numerics;

namespace RayTracer.Numerics;

/// <summary>
/// The motion between two keyframes. Each is taken apart into translation, rotation and stretch (polar decomposition: Shoemake &amp; Duff,
/// Matrix animation and polar decomposition, 1992); translation and stretch change in proportion to time, the rotation at constant
/// speed the shorter way round.
/// </summary>
internal sealed class MotionSegment
{
    // Pieces in which the way of a box is bounded: more of them give a tighter box.
    private const int BoundedPieces = 32;
    private readonly Transform _stretch0;
    private readonly Transform _stretch1;
    private readonly Quaternion64 _start;
    private readonly Quaternion64 _across;
    private readonly double _halfAngle;

    /// <summary>The motion from one place to another.</summary>
    /// <param name="time0">The time of the first keyframe.</param>
    /// <param name="place0">The place then.</param>
    /// <param name="time1">The time of the second keyframe, later.</param>
    /// <param name="place1">The place then.</param>
    public MotionSegment(double time0, in Transform place0, double time1, in Transform place1)
    {
        (Start, End) = (time0, time1);
        Transform rotation0 = Polar(place0);
        Transform rotation1 = Polar(place1);
        (_stretch0, _stretch1) = (rotation0.Inverse() * Linear(place0), rotation1.Inverse() * Linear(place1));
        (From, To) = (place0, place1);
        _start = Quaternion64.FromRotation(rotation0);
        Quaternion64 end = Quaternion64.FromRotation(rotation1);
        double cosine = _start.Dot(end);
        end *= cosine < 0 ? -1 : 1;
        cosine = double.Abs(cosine);

        // What is left of the end beside the start, of length sin: the start turns towards it.
        Quaternion64 rest = end + (_start * -cosine);
        double sine = double.Sqrt(rest.Dot(rest));
        _halfAngle = LaneMath.Atan2((float)sine, (float)cosine);
        _across = sine > 0 ? rest * (1 / sine) : default;
    }

    /// <summary>Time of the first keyframe.</summary>
    public double Start { get; }

    /// <summary>Time of the second keyframe.</summary>
    public double End { get; }

    private Transform From { get; }

    private Transform To { get; }

    /// <summary>The place at a time between the two.</summary>
    public Transform At(double time)
    {
        if (time <= Start || time >= End)
        {
            return time <= Start ? From : To;
        }

        double t = (time - Start) / (End - Start);
        LaneMath.SinCos((float)(_halfAngle * t), out float sin, out float cos);
        Transform stretch = Mix(_stretch0, _stretch1, t);
        Transform linear = ((_start * cos) + (_across * sin)).Unit().ToRotation() * stretch;
        return new(linear.X with { D = Mix(From.X.D, To.X.D, t) }, linear.Y with { D = Mix(From.Y.D, To.Y.D, t) }, linear.Z with { D = Mix(From.Z.D, To.Z.D, t) });
    }

    /// <summary>A box around all places of a box from one time to another.</summary>
    /// <remarks>
    /// Between the ends of a piece of duration h a point leaves the straight line by at most h²/8 times its largest acceleration, which
    /// for rotation at speed ω of a stretched vector s is ω²|s| + 2ω|s′|.
    /// </remarks>
    public Bounds Bound(in Bounds box, double from, double to)
    {
        (from, to) = (double.Clamp(from, Start, End), double.Clamp(to, Start, End));
        double h = (to - from) / BoundedPieces;
        double speed = 2 * _halfAngle / (End - Start);
        double reach = 0;
        double growth = 0;
        foreach (Vector3 corner in box.Corners())
        {
            Vector3 s0 = _stretch0.Vector(corner);
            Vector3 s1 = _stretch1.Vector(corner);
            reach = double.Max(reach, float.Max(s0.Norm(), s1.Norm()));
            growth = double.Max(growth, (s1 - s0).Norm() / (End - Start));
        }

        // A thousandth more for sines and cosines in single precision, which are off by some 1e-7 of the reach.
        var slack = new Vector3((float)((((speed * speed * reach) + (2 * speed * growth)) * h * h / 8 * 1.001) + (1e-6 * reach)));
        Bounds all = Bounds.Empty;
        for (int i = 0; i <= BoundedPieces; i++)
        {
            all = all.Union(box.Transformed(At(i == BoundedPieces ? to : from + (i * h))));
        }

        return new(all.Minimum - slack, all.Maximum + slack);
    }

    // The rotation nearest to a map's linear part; for a map that mirrors, the mirroring is left to the stretch. Newton's iteration
    // for the orthogonal factor: the mean of the matrix and its inverse transposed.
    private static Transform Polar(in Transform map)
    {
        Transform q = Linear(map);
        if (q.Determinant < 0)
        {
            q = Mix(q, q, 0, -1);
        }

        for (int i = 0; i < 60; i++)
        {
            Transform next = Mix(q, Transposed(q.Inverse()), 0.5);
            if (next == q)
            {
                break;
            }

            q = next;
        }

        return q;
    }

    private static Transform Linear(in Transform m) => new(m.X with { D = 0 }, m.Y with { D = 0 }, m.Z with { D = 0 });

    private static Transform Transposed(in Transform m) =>
        new(new(m.X.A, m.Y.A, m.Z.A, 0), new(m.X.B, m.Y.B, m.Z.B, 0), new(m.X.C, m.Y.C, m.Z.C, 0));

    private static double Mix(double a, double b, double t) => (a * (1 - t)) + (b * t);

    private static Transform Mix(in Transform a, in Transform b, double t) => Mix(a, b, t, 1);

    private static Transform Mix(in Transform a, in Transform b, double t, double scale) => new(Mix(a.X, b.X, t, scale), Mix(a.Y, b.Y, t, scale), Mix(a.Z, b.Z, t, scale));

    private static TransformRow Mix(TransformRow a, TransformRow b, double t, double scale) =>
        new(Mix(a.A, b.A, t) * scale, Mix(a.B, b.B, t) * scale, Mix(a.C, b.C, t) * scale, 0);
}
