namespace RayTracer.Textbook;

/// <summary>
/// Three unit vectors, perpendicular to each other, of which the third is given. Materials work in the frame of a surface, whose third vector is
/// the normal: the cosine with the normal is then simply z.
/// </summary>
public readonly struct Frame
{
    private readonly Vector _x;
    private readonly Vector _y;
    private readonly Vector _z;

    /// <summary>From the third vector (Duff et al., Building an orthonormal basis, revisited, 2017).</summary>
    /// <param name="z">A unit vector.</param>
    public Frame(Vector z)
    {
        double sign = Math.CopySign(1, z.Z);
        double a = -1 / (sign + z.Z);
        double b = z.X * z.Y * a;
        _x = new(1 + (sign * z.X * z.X * a), sign * b, -sign * z.X);
        _y = new(b, sign + (z.Y * z.Y * a), -z.Y);
        _z = z;
    }

    /// <summary>The direction in the frame of one in the world.</summary>
    public Vector ToLocal(Vector v) => new(Vector.Dot(v, _x), Vector.Dot(v, _y), Vector.Dot(v, _z));

    /// <summary>The direction in the world of one in the frame.</summary>
    public Vector ToWorld(Vector v) => (v.X * _x) + (v.Y * _y) + (v.Z * _z);
}
