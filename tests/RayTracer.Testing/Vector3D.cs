using System.Globalization;
using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Testing;

/// <summary>A vector in double precision, for what the lanes' results are compared with.</summary>
/// <param name="X">First coordinate.</param>
/// <param name="Y">Second coordinate.</param>
/// <param name="Z">Third coordinate.</param>
public readonly record struct Vector3D(double X, double Y, double Z)
{
    /// <summary>The square of the length.</summary>
    public double Squared => Dot(this);

    /// <summary>The length.</summary>
    public double Length => Math.Sqrt(Squared);

    /// <summary>The vector scaled to length 1.</summary>
    public Vector3D Unit => this * (1 / Length);

    /// <summary>One lane of a packet.</summary>
    public static Vector3D Of(in Vec3W v, int lane = 0) => new(v.X[lane], v.Y[lane], v.Z[lane]);

    /// <summary>With more digits, which are zero.</summary>
    public static implicit operator Vector3D(Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>Rounded to single precision.</summary>
    public static explicit operator Vector3(Vector3D v) => new((float)v.X, (float)v.Y, (float)v.Z);

    /// <summary>The sum.</summary>
    public static Vector3D operator +(Vector3D a, Vector3D b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>The difference.</summary>
    public static Vector3D operator -(Vector3D a, Vector3D b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The vector the other way round.</summary>
    public static Vector3D operator -(Vector3D a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>The vector scaled.</summary>
    public static Vector3D operator *(Vector3D a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>The scalar product.</summary>
    public double Dot(Vector3D b) => (X * b.X) + (Y * b.Y) + (Z * b.Z);

    /// <summary>The vector product.</summary>
    public Vector3D Cross(Vector3D b) => new((Y * b.Z) - (Z * b.Y), (Z * b.X) - (X * b.Z), (X * b.Y) - (Y * b.X));

    /// <summary>The coordinates, for messages.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"({X:G7}, {Y:G7}, {Z:G7})");

    /// <summary>Any unit vector perpendicular to this one.</summary>
    public Vector3D Perpendicular() => Cross(Math.Abs(X) < 0.6 * Length ? new(1, 0, 0) : new(0, 1, 0)).Unit;
}
