namespace RayTracer.RenderTests.Oracle;

/// <summary>Three numbers: a point, a direction, or a colour (linear red, green, blue).</summary>
internal readonly record struct Vec(double X, double Y, double Z)
{
    public static readonly Vec One = new(1, 1, 1);

    public double Length => Math.Sqrt(Dot(this, this));

    public Vec Unit => this / Length;

    public static Vec operator +(Vec a, Vec b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Vec operator -(Vec a, Vec b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Vec operator -(Vec a) => new(-a.X, -a.Y, -a.Z);

    public static Vec operator *(Vec a, Vec b) => new(a.X * b.X, a.Y * b.Y, a.Z * b.Z);

    public static Vec operator *(double s, Vec a) => new(s * a.X, s * a.Y, s * a.Z);

    public static Vec operator /(Vec a, double s) => new(a.X / s, a.Y / s, a.Z / s);

    public static double Dot(Vec a, Vec b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    public static Vec Cross(Vec a, Vec b) =>
        new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

    /// <summary>A direction given by its components along three unit vectors perpendicular to each other, of which this is the third.</summary>
    public Vec ToWorld(double x, double y, double z)
    {
        Vec other = Math.Abs(X) < 0.5 ? new(1, 0, 0) : new(0, 1, 0);
        Vec first = Cross(other, this).Unit;
        return (x * first) + (y * Cross(this, first)) + (z * this);
    }
}
