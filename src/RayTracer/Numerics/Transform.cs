using System.Numerics;

namespace RayTracer.Numerics;

/// <summary>
/// An affine map, p ↦ A·p + b: three rows of four numbers. Made and multiplied in double precision with a fixed order of operations,
/// so that a chain of steps costs no accuracy that single precision would show.
/// </summary>
/// <param name="X">The row of the first coordinate: its factors on x, y and z, and the number added.</param>
/// <param name="Y">The row of the second coordinate.</param>
/// <param name="Z">The row of the third coordinate.</param>
public readonly record struct Transform(TransformRow X, TransformRow Y, TransformRow Z)
{
    // How far from an exact similarity a map may be: what angles in single precision leave.
    private const double Tolerance = 1e-6;
    private const double Limit = 1e30;

    /// <summary>The map that moves nothing.</summary>
    public static Transform Identity { get; } = Scaling(Vector3.One);

    /// <summary>True for the identity.</summary>
    public bool IsIdentity => this == Identity;

    /// <summary>True where the axes keep their directions, whatever the factors along them.</summary>
    public bool KeepsAxes => this is { X: { A: > 0, B: 0, C: 0 }, Y: { A: 0, B: > 0, C: 0 }, Z: { A: 0, B: 0, C: > 0 } };

    /// <summary>The determinant of A: the factor on volumes, below zero for maps that mirror.</summary>
    public double Determinant =>
        (X.A * ((Y.B * Z.C) - (Y.C * Z.B))) + (X.B * ((Y.C * Z.A) - (Y.A * Z.C))) + (X.C * ((Y.A * Z.B) - (Y.B * Z.A)));

    /// <summary>True where the map is invertible, and neither it nor its inverse has numbers too large for single precision.</summary>
    public bool IsInvertible => IsModest && double.IsNormal(Determinant) && double.IsNormal(1 / Determinant) && Inverse().IsModest;

    // Comparisons with NaN are false.
    private bool IsModest => X.Largest < Limit && Y.Largest < Limit && Z.Largest < Limit;

    /// <summary>Factors along the axes.</summary>
    public static Transform Scaling(Vector3 factors) => new(new(factors.X, 0, 0, 0), new(0, factors.Y, 0, 0), new(0, 0, factors.Z, 0));

    /// <summary>Adds a vector.</summary>
    public static Transform Translation(Vector3 by) => new(new(1, 0, 0, by.X), new(0, 1, 0, by.Y), new(0, 0, 1, by.Z));

    /// <summary>Turns about an axis through the origin by the right-hand rule (Rodrigues' formula).</summary>
    /// <param name="axis">The axis, of any length above zero.</param>
    /// <param name="degrees">The angle.</param>
    public static Transform Rotation(Vector3 axis, float degrees)
    {
        double length = double.Sqrt(((double)axis.X * axis.X) + ((double)axis.Y * axis.Y) + ((double)axis.Z * axis.Z));
        (double x, double y, double z) = (axis.X / length, axis.Y / length, axis.Z / length);

        // Whole turns are taken off exactly, and sine and cosine brought back onto the circle from single precision.
        double turns = degrees / 360.0;
        LaneMath.SinCosTurn((float)(turns - double.Floor(turns)), out float s, out float c);
        double norm = double.Sqrt(((double)s * s) + ((double)c * c));
        (double sin, double cos) = (s / norm, c / norm);
        double rest = 1 - cos;
        return new(
            new((x * x * rest) + cos, (x * y * rest) - (z * sin), (x * z * rest) + (y * sin), 0),
            new((y * x * rest) + (z * sin), (y * y * rest) + cos, (y * z * rest) - (x * sin), 0),
            new((z * x * rest) - (y * sin), (z * y * rest) + (x * sin), (z * z * rest) + cos, 0));
    }

    /// <summary>The map that applies <paramref name="b"/> first and <paramref name="a"/> second.</summary>
    public static Transform operator *(in Transform a, in Transform b) => new(a.X.Times(b), a.Y.Times(b), a.Z.Times(b));

    /// <summary>The map that undoes this one (by cofactors).</summary>
    public Transform Inverse()
    {
        double scale = 1 / Determinant;
        Transform linear = new(
            new(((Y.B * Z.C) - (Y.C * Z.B)) * scale, ((X.C * Z.B) - (X.B * Z.C)) * scale, ((X.B * Y.C) - (X.C * Y.B)) * scale, 0),
            new(((Y.C * Z.A) - (Y.A * Z.C)) * scale, ((X.A * Z.C) - (X.C * Z.A)) * scale, ((X.C * Y.A) - (X.A * Y.C)) * scale, 0),
            new(((Y.A * Z.B) - (Y.B * Z.A)) * scale, ((X.B * Z.A) - (X.A * Z.B)) * scale, ((X.A * Y.B) - (X.B * Y.A)) * scale, 0));
        return linear * new Transform(new(1, 0, 0, -X.D), new(0, 1, 0, -Y.D), new(0, 0, 1, -Z.D));
    }

    /// <summary>The image of a point.</summary>
    public Vector3 Point(Vector3 p) => new((float)(X.Dot(p) + X.D), (float)(Y.Dot(p) + Y.D), (float)(Z.Dot(p) + Z.D));

    /// <summary>The image of a difference of points.</summary>
    public Vector3 Vector(Vector3 v) => new((float)X.Dot(v), (float)Y.Dot(v), (float)Z.Dot(v));

    /// <summary>A vector multiplied by the transpose of A: of the inverse map, what a normal becomes, of another length.</summary>
    public Vector3 TransposedVector(Vector3 v) => new(
        (float)((X.A * v.X) + (Y.A * v.Y) + (Z.A * v.Z)),
        (float)((X.B * v.X) + (Y.B * v.Y) + (Z.B * v.Z)),
        (float)((X.C * v.X) + (Y.C * v.Y) + (Z.C * v.Z)));

    /// <summary>The factor on all lengths; null where lengths change differently, to more than a part in a million.</summary>
    public double? UniformScale()
    {
        double square = X.Product(X);
        double most = Tolerance * square;
        bool isSimilarity = double.Abs(Y.Product(Y) - square) <= most && double.Abs(Z.Product(Z) - square) <= most
            && double.Abs(X.Product(Y)) <= most && double.Abs(X.Product(Z)) <= most && double.Abs(Y.Product(Z)) <= most;
        return isSimilarity ? double.Sqrt(square) : null;
    }

    /// <summary>Reads what <see cref="Write"/> wrote.</summary>
    internal static unsafe Transform Read(float* from) =>
        new(new(from[0], from[1], from[2], from[3]), new(from[4], from[5], from[6], from[7]), new(from[8], from[9], from[10], from[11]));

    /// <summary>Writes the twelve numbers, row by row, in single precision.</summary>
    internal unsafe void Write(float* to)
    {
        X.Write(to);
        Y.Write(to + 4);
        Z.Write(to + 8);
    }
}

/// <summary>One row of a <see cref="Transform"/>: a·x + b·y + c·z + d.</summary>
/// <param name="A">Factor on x.</param>
/// <param name="B">Factor on y.</param>
/// <param name="C">Factor on z.</param>
/// <param name="D">The number added.</param>
public readonly record struct TransformRow(double A, double B, double C, double D)
{
    internal double Largest => double.Abs(A) + double.Abs(B) + double.Abs(C) + double.Abs(D);

    internal double Dot(Vector3 v) => (A * v.X) + (B * v.Y) + (C * v.Z);

    internal double Product(TransformRow other) => (A * other.A) + (B * other.B) + (C * other.C);

    internal TransformRow Times(in Transform m) => new(
        (A * m.X.A) + (B * m.Y.A) + (C * m.Z.A),
        (A * m.X.B) + (B * m.Y.B) + (C * m.Z.B),
        (A * m.X.C) + (B * m.Y.C) + (C * m.Z.C),
        (A * m.X.D) + (B * m.Y.D) + (C * m.Z.D) + D);

    internal unsafe void Write(float* to)
    {
        to[0] = (float)A;
        to[1] = (float)B;
        to[2] = (float)C;
        to[3] = (float)D;
    }
}
