namespace RayTracer.Textbook;

/// <summary>A box parallel to the axes around things (report, section 3.5).</summary>
/// <param name="Low">The corner with the smallest numbers.</param>
/// <param name="High">The corner with the largest numbers.</param>
public readonly record struct Bounds(Vector Low, Vector High)
{
    /// <summary>Around nothing: joined with any other box it gives that one.</summary>
    public static Bounds Empty { get; } = new(Everywhere.High, Everywhere.Low);

    /// <summary>Around everything.</summary>
    public static Bounds Everywhere => new(new(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity), new(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity));

    /// <summary>The middle.</summary>
    public Vector Middle => 0.5 * (Low + High);

    /// <summary>The eight corners.</summary>
    public Vector[] Corners => [Low, new(High.X, Low.Y, Low.Z), new(Low.X, High.Y, Low.Z), new(High.X, High.Y, Low.Z), new(Low.X, Low.Y, High.Z), new(High.X, Low.Y, High.Z), new(Low.X, High.Y, High.Z), High];

    /// <summary>The lengths of the edges.</summary>
    public Vector Size => High - Low;

    /// <summary>The area of the six faces; 0 around nothing.</summary>
    public double Area => Low.X > High.X ? 0 : 2 * ((Size.X * Size.Y) + (Size.Y * Size.Z) + (Size.Z * Size.X));

    /// <summary>True where it ends in all directions.</summary>
    public bool IsFinite => double.IsFinite(Low.X + Low.Y + Low.Z + High.X + High.Y + High.Z);

    /// <summary>The axis along which it is longest.</summary>
    public int LongestAxis => Size.X >= Size.Y && Size.X >= Size.Z ? 0 : Size.Y >= Size.Z ? 1 : 2;

    /// <summary>Around some points.</summary>
    public static Bounds Around(params ReadOnlySpan<Vector> points)
    {
        Bounds all = Empty;
        foreach (Vector point in points)
        {
            all = all.With(new Bounds(point, point));
        }

        return all;
    }

    /// <summary>Around this and another box.</summary>
    public Bounds With(Bounds other) => new(Vector.Min(Low, other.Low), Vector.Max(High, other.High));

    /// <summary>Larger by the same length on all sides.</summary>
    public Bounds Grown(double by) => new(Low - new Vector(by, by, by), High + new Vector(by, by, by));

    /// <summary>
    /// Where a ray is inside: between two planes for each axis, so the box is where all three intervals overlap (Kay &amp; Kajiya, Ray tracing complex
    /// scenes, 1986). False where that is nowhere before <paramref name="end"/>.
    /// </summary>
    /// <param name="ray">The ray.</param>
    /// <param name="begin">Where to begin; then where the ray enters.</param>
    /// <param name="end">Where to end; then where the ray leaves.</param>
    public bool Cut(in Ray ray, ref double begin, ref double end)
    {
        CutAxis(Low.X, High.X, ray.Origin.X, ray.Direction.X, ref begin, ref end);
        CutAxis(Low.Y, High.Y, ray.Origin.Y, ray.Direction.Y, ref begin, ref end);
        CutAxis(Low.Z, High.Z, ray.Origin.Z, ray.Direction.Z, ref begin, ref end);
        return begin <= end;
    }

    // A ray within one of the planes gives 0/0 there, which is not a number: such comparisons are false, and the interval stays as it is.
    private static void CutAxis(double low, double high, double origin, double direction, ref double begin, ref double end)
    {
        double inverse = 1 / direction;
        double near = (low - origin) * inverse;
        double far = (high - origin) * inverse;
        if (inverse < 0)
        {
            (near, far) = (far, near);
        }

        begin = near > begin ? near : begin;
        end = far < end ? far : end;
    }
}
