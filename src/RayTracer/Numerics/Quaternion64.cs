namespace RayTracer.Numerics;

/// <summary>A unit quaternion as a rotation (Shoemake, Animating rotation with quaternion curves, 1985), in double precision.</summary>
/// <param name="X">First imaginary part.</param>
/// <param name="Y">Second imaginary part.</param>
/// <param name="Z">Third imaginary part.</param>
/// <param name="W">Real part.</param>
internal readonly record struct Quaternion64(double X, double Y, double Z, double W)
{
    public static Quaternion64 operator +(Quaternion64 a, Quaternion64 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z, a.W + b.W);

    public static Quaternion64 operator *(Quaternion64 a, double s) => new(a.X * s, a.Y * s, a.Z * s, a.W * s);

    /// <summary>The rotation of a matrix (Shepperd 1978: divided by the largest of the four parts).</summary>
    public static Quaternion64 FromRotation(in Transform m)
    {
        double trace = m.X.A + m.Y.B + m.Z.C;
        double largest = double.Max(double.Max(trace, m.X.A), double.Max(m.Y.B, m.Z.C));
        Quaternion64 q = largest == trace
            ? new(m.Z.B - m.Y.C, m.X.C - m.Z.A, m.Y.A - m.X.B, 1 + trace)
            : largest == m.X.A ? new(1 + m.X.A - m.Y.B - m.Z.C, m.X.B + m.Y.A, m.X.C + m.Z.A, m.Z.B - m.Y.C)
            : largest == m.Y.B ? new(m.X.B + m.Y.A, 1 + m.Y.B - m.X.A - m.Z.C, m.Y.C + m.Z.B, m.X.C - m.Z.A)
            : new(m.X.C + m.Z.A, m.Y.C + m.Z.B, 1 + m.Z.C - m.X.A - m.Y.B, m.Y.A - m.X.B);
        return q.Unit();
    }

    public double Dot(Quaternion64 other) => (X * other.X) + (Y * other.Y) + (Z * other.Z) + (W * other.W);

    public Quaternion64 Unit() => this * (1 / double.Sqrt(Dot(this)));

    /// <summary>The rotation on the shorter way between two, at constant speed (Shoemake 1985).</summary>
    /// <param name="from">The first, of length 1.</param>
    /// <param name="to">The last, of length 1.</param>
    /// <param name="t">0 for the first, 1 for the last.</param>
    public static Quaternion64 Slerp(Quaternion64 from, Quaternion64 to, double t)
    {
        double cosine = from.Dot(to);
        Quaternion64 rest = (to * (cosine < 0 ? -1 : 1)) + (from * -double.Abs(cosine));
        double sine = double.Sqrt(rest.Dot(rest));
        if (!(sine > 0))
        {
            return from;
        }

        LaneMath.SinCos((float)(LaneMath.Atan2((float)sine, (float)double.Abs(cosine)) * t), out float sin, out float cos);
        return ((from * cos) + (rest * (sin / sine))).Unit();
    }

    /// <summary>The rotation's matrix.</summary>
    public Transform ToRotation() => new(
        new(1 - (2 * ((Y * Y) + (Z * Z))), 2 * ((X * Y) - (Z * W)), 2 * ((X * Z) + (Y * W)), 0),
        new(2 * ((X * Y) + (Z * W)), 1 - (2 * ((X * X) + (Z * Z))), 2 * ((Y * Z) - (X * W)), 0),
        new(2 * ((X * Z) - (Y * W)), 2 * ((Y * Z) + (X * W)), 1 - (2 * ((X * X) + (Y * Y))), 0));
}
