using System.Numerics;

namespace RayTracer.Numerics;

/// <summary>A box parallel to the axes.</summary>
/// <param name="Minimum">The corner of the smallest coordinates.</param>
/// <param name="Maximum">The corner of the largest coordinates.</param>
public readonly record struct Bounds(Vector3 Minimum, Vector3 Maximum)
{
    /// <summary>The box around nothing.</summary>
    public static Bounds Empty => new(new(float.PositiveInfinity), new(float.NegativeInfinity));

    /// <summary>Everything.</summary>
    public static Bounds Infinite => new(new(float.NegativeInfinity), new(float.PositiveInfinity));

    /// <summary>True where all coordinates are finite.</summary>
    public bool IsFinite => Minimum.IsFinite() && Maximum.IsFinite();

    /// <summary>The eight corners.</summary>
    public IEnumerable<Vector3> Corners()
    {
        for (int i = 0; i < 8; i++)
        {
            yield return new(
                (i & 1) == 0 ? Minimum.X : Maximum.X, (i & 2) == 0 ? Minimum.Y : Maximum.Y, (i & 4) == 0 ? Minimum.Z : Maximum.Z);
        }
    }

    /// <summary>The smallest box around what the box becomes by a map; infinite where the box is.</summary>
    public Bounds Transformed(Transform by)
    {
        if (!IsFinite)
        {
            return Minimum.X > Maximum.X ? Empty : Infinite;
        }

        Bounds all = Empty;
        foreach (Vector3 corner in Corners())
        {
            Vector3 p = by.Point(corner);
            all = all.Union(new(p, p));
        }

        return all;
    }

    /// <summary>The smallest box around both.</summary>
    public Bounds Union(Bounds other) => new(Vector3.Min(Minimum, other.Minimum), Vector3.Max(Maximum, other.Maximum));
}
