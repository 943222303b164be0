namespace RayTracer.RenderTests.Analytic;

/// <summary>A vector in double precision, so that closed forms are not computed with the product's own arithmetic.</summary>
internal readonly record struct Vec3D(double X, double Y, double Z)
{
    public double Length => Math.Sqrt(Dot(this));

    public Vec3D Unit => this * (1 / Length);

    public static Vec3D operator +(Vec3D a, Vec3D b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Vec3D operator -(Vec3D a, Vec3D b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Vec3D operator *(Vec3D a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    public double Dot(Vec3D b) => (X * b.X) + (Y * b.Y) + (Z * b.Z);

    public Vec3D Cross(Vec3D b) => new((Y * b.Z) - (Z * b.Y), (Z * b.X) - (X * b.Z), (X * b.Y) - (Y * b.X));

    /// <summary>As a scene file writes it.</summary>
    public override string ToString() => FormattableString.Invariant($"[{X:R}, {Y:R}, {Z:R}]");
}
