namespace RayTracer.Textbook;

/// <summary>A point, a direction or a normal: three numbers along x, y and z.</summary>
/// <param name="X">Along x.</param>
/// <param name="Y">Along y.</param>
/// <param name="Z">Along z.</param>
public readonly record struct Vector(double X, double Y, double Z)
{
    /// <summary>Its length.</summary>
    public double Length => Math.Sqrt(Dot(this, this));

    /// <summary>The same direction with length 1.</summary>
    public Vector Unit => this * (1 / Length);

    /// <summary>The largest of the absolute values.</summary>
    public double Largest => Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z)));

    /// <summary>The number along an axis: 0 is x, 1 is y, 2 is z.</summary>
    public double this[int axis] => axis == 0 ? X : axis == 1 ? Y : Z;

    /// <summary>As (x, y, z): what records write by themselves would go on with <see cref="Unit"/> for ever.</summary>
    public override string ToString() => $"({X}, {Y}, {Z})";

    /// <summary>The numbers of scene files are in single precision.</summary>
    public static implicit operator Vector(System.Numerics.Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>Number by number.</summary>
    public static Vector operator +(Vector a, Vector b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Number by number.</summary>
    public static Vector operator -(Vector a, Vector b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite direction.</summary>
    public static Vector operator -(Vector a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>Longer or shorter.</summary>
    public static Vector operator *(Vector a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>Longer or shorter.</summary>
    public static Vector operator *(double s, Vector a) => a * s;

    /// <summary>The product of the lengths and the cosine of the angle between.</summary>
    public static double Dot(Vector a, Vector b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    /// <summary>Perpendicular to both, by the right-hand rule; as long as the area between them.</summary>
    public static Vector Cross(Vector a, Vector b) => new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

    /// <summary>The smaller numbers of both.</summary>
    public static Vector Min(Vector a, Vector b) => new(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z));

    /// <summary>The larger numbers of both.</summary>
    public static Vector Max(Vector a, Vector b) => new(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z));
}
