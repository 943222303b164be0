namespace RayTracer.Textbook;

/// <summary>
/// A point with a fourth number: (x, y, z, w) stands for (x/w, y/w, z/w), and with w = 0 for a direction (report, section 3.3.4). So a matrix can do what
/// no affine map can: make what is far away small.
/// </summary>
/// <param name="X">Along x, times w.</param>
/// <param name="Y">Along y, times w.</param>
/// <param name="Z">Along z, times w.</param>
/// <param name="W">What the others are divided by.</param>
public readonly record struct Homogeneous(double X, double Y, double Z, double W)
{
    /// <summary>The point, after the division.</summary>
    public Vector Point => new(X / W, Y / W, Z / W);

    /// <summary>Between this and another point.</summary>
    public Homogeneous Towards(Homogeneous other, double share) =>
        new(X + (share * (other.X - X)), Y + (share * (other.Y - Y)), Z + (share * (other.Z - Z)), W + (share * (other.W - W)));
}

/// <summary>A matrix of four rows and four columns, by its rows.</summary>
/// <param name="X">The row that gives x.</param>
/// <param name="Y">The row that gives y.</param>
/// <param name="Z">The row that gives z.</param>
/// <param name="W">The row that gives w.</param>
public sealed record Matrix(Homogeneous X, Homogeneous Y, Homogeneous Z, Homogeneous W)
{
    /// <summary>Where a point goes.</summary>
    public Homogeneous Of(Homogeneous p) => new(Dot(X, p), Dot(Y, p), Dot(Z, p), Dot(W, p));

    /// <summary>Where a point goes.</summary>
    public Homogeneous Of(Vector p) => Of(new Homogeneous(p.X, p.Y, p.Z, 1));

    /// <summary>First the other matrix, then this one: its columns are where this one takes the other's.</summary>
    public Matrix After(Matrix first)
    {
        Homogeneous a = Of(new Homogeneous(first.X.X, first.Y.X, first.Z.X, first.W.X));
        Homogeneous b = Of(new Homogeneous(first.X.Y, first.Y.Y, first.Z.Y, first.W.Y));
        Homogeneous c = Of(new Homogeneous(first.X.Z, first.Y.Z, first.Z.Z, first.W.Z));
        Homogeneous d = Of(new Homogeneous(first.X.W, first.Y.W, first.Z.W, first.W.W));
        return new(new(a.X, b.X, c.X, d.X), new(a.Y, b.Y, c.Y, d.Y), new(a.Z, b.Z, c.Z, d.Z), new(a.W, b.W, c.W, d.W));
    }

    /// <summary>The model's matrix: from where a thing was made to its place in the world.</summary>
    public static Matrix Model(Transform t) => new(new(t.X.X, t.Y.X, t.Z.X, t.Shift.X), new(t.X.Y, t.Y.Y, t.Z.Y, t.Shift.Y), new(t.X.Z, t.Y.Z, t.Z.Z, t.Shift.Z), new(0, 0, 0, 1));

    /// <summary>The view: the world as seen by an eye, with x to the right, y upwards and z forward, all three of length 1.</summary>
    public static Matrix View(Vector eye, Vector right, Vector up, Vector forward)
    {
        Homogeneous Row(Vector axis) => new(axis.X, axis.Y, axis.Z, -Vector.Dot(axis, eye));
        return new(Row(right), Row(up), Row(forward), new(0, 0, 0, 1));
    }

    /// <summary>The projection: what the window at distance 1 shows lies between −1 and 1 after the division, what is near at z = 0, what is far at z = 1.</summary>
    /// <param name="width">Width of that window.</param>
    /// <param name="height">Height of that window.</param>
    /// <param name="near">The distance at which the picture begins.</param>
    /// <param name="far">The distance at which it ends.</param>
    public static Matrix Perspective(double width, double height, double near, double far) =>
        new(new(2 / width, 0, 0, 0), new(0, 2 / height, 0, 0), new(0, 0, far / (far - near), -far * near / (far - near)), new(0, 0, 1, 0));

    /// <summary>The viewport: from −1 and 1 to columns from the left and rows from the top.</summary>
    public static Matrix Viewport(int width, int height) =>
        new(new(0.5 * width, 0, 0, 0.5 * width), new(0, -0.5 * height, 0, 0.5 * height), new(0, 0, 1, 0), new(0, 0, 0, 1));

    private static double Dot(Homogeneous a, Homogeneous b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W);
}
