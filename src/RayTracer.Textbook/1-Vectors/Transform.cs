namespace RayTracer.Textbook;

/// <summary>
/// An affine map (report, section 3.3.4): a matrix of three rows and four columns, the fourth of which is added. The fourth row of the report's
/// homogeneous matrices is always 0, 0, 0, 1, so that it need not be kept.
/// </summary>
/// <param name="X">The images of the three axes, as columns of the matrix: where (1, 0, 0) goes.</param>
/// <param name="Y">Where (0, 1, 0) goes.</param>
/// <param name="Z">Where (0, 0, 1) goes.</param>
/// <param name="Shift">Where the origin goes.</param>
public sealed record Transform(Vector X, Vector Y, Vector Z, Vector Shift)
{
    /// <summary>Changes nothing.</summary>
    public static Transform Identity { get; } = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), default);

    /// <summary>The factor by which it changes volumes; below 0 where it mirrors.</summary>
    public double Determinant => Vector.Dot(X, Vector.Cross(Y, Z));

    /// <summary>Where a point goes.</summary>
    public Vector Point(Vector p) => Direction(p) + Shift;

    /// <summary>Where a difference of points goes.</summary>
    public Vector Direction(Vector d) => (d.X * X) + (d.Y * Y) + (d.Z * Z);

    /// <summary>
    /// Where a normal goes: it stays perpendicular to the surface, so that it goes by the inverse's transpose, whose columns are the products
    /// below over the determinant. The length is that by which areas across the normal grow, over the determinant.
    /// </summary>
    public Vector Normal(Vector n) => ((n.X * Vector.Cross(Y, Z)) + (n.Y * Vector.Cross(Z, X)) + (n.Z * Vector.Cross(X, Y))) * (1 / Determinant);

    /// <summary>First the other map, then this one.</summary>
    public Transform After(Transform first) => new(Direction(first.X), Direction(first.Y), Direction(first.Z), Point(first.Shift));

    /// <summary>The map back (Cramer's rule).</summary>
    public Transform Inverse()
    {
        double scale = 1 / Determinant;
        Vector a = Vector.Cross(Y, Z) * scale;
        Vector b = Vector.Cross(Z, X) * scale;
        Vector c = Vector.Cross(X, Y) * scale;
        Transform linear = new(new(a.X, b.X, c.X), new(a.Y, b.Y, c.Y), new(a.Z, b.Z, c.Z), default);
        return linear with { Shift = -linear.Direction(Shift) };
    }

    /// <summary>Moves everything.</summary>
    public static Transform Translation(Vector by) => Identity with { Shift = by };

    /// <summary>Makes everything larger or smaller along the axes.</summary>
    public static Transform Scaling(Vector by) => new(new(by.X, 0, 0), new(0, by.Y, 0), new(0, 0, by.Z), default);

    /// <summary>Turns everything counter-clockwise about an axis that points at the viewer (Rodrigues' formula).</summary>
    /// <param name="axis">The axis, of any length.</param>
    /// <param name="degrees">The angle.</param>
    public static Transform Rotation(Vector axis, double degrees)
    {
        Vector k = axis.Unit;
        (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180);
        Vector Turned(Vector v) => (v * cos) + (Vector.Cross(k, v) * sin) + (k * (Vector.Dot(k, v) * (1 - cos)));
        return new(Turned(Identity.X), Turned(Identity.Y), Turned(Identity.Z), default);
    }

    /// <summary>The box around the image of a box: around the images of its eight corners.</summary>
    public Bounds Box(Bounds box)
    {
        Bounds all = Bounds.Empty;
        for (int corner = 0; corner < 8; corner++)
        {
            Vector point = Point(new(
                (corner & 1) == 0 ? box.Low.X : box.High.X,
                (corner & 2) == 0 ? box.Low.Y : box.High.Y,
                (corner & 4) == 0 ? box.Low.Z : box.High.Z));
            all = all.With(new Bounds(point, point));
        }

        return all;
    }
}
