namespace RayTracer.Textbook;

/// <summary>A box parallel to the axes.</summary>
/// <param name="bounds">The box.</param>
public sealed class Box(Bounds bounds) : IShape
{
    // The six faces: along each axis the lower and the upper one.
    private readonly Rectangle[] _faces = [.. Enumerable.Range(0, 6).Select(i => Face(bounds, i / 2, i % 2 == 1))];

    /// <inheritdoc/>
    public Bounds Bounds => bounds;

    /// <inheritdoc/>
    public double Area => bounds.Area;

    /// <summary>Where the ray enters the box, or leaves it where it starts inside.</summary>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        double begin = double.NegativeInfinity;
        double end = double.PositiveInfinity;
        if (!bounds.Cut(ray, ref begin, ref end))
        {
            return false;
        }

        double t = begin > 0 ? begin : end;
        if (!(t > 0 && t < hit.Distance))
        {
            return false;
        }

        hit.Distance = t;
        return true;
    }

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        // Of the point's six distances to the faces, the smallest.
        Vector point = ray.At(hit.Distance);
        int face = 0;
        double least = double.PositiveInfinity;
        for (int i = 0; i < 6; i++)
        {
            int axis = i / 2;
            double distance = Math.Abs(point[axis] - (i % 2 == 1 ? bounds.High : bounds.Low)[axis]);
            (face, least) = distance < least ? (i, distance) : (face, least);
        }

        _faces[face].Describe(ray, ref hit);
    }

    /// <inheritdoc/>
    public SurfacePoint PointAt((double U, double V) random)
    {
        double rest = random.V * Area;
        int face = 0;
        while (face < 5 && rest >= _faces[face].Area)
        {
            rest -= _faces[face++].Area;
        }

        return _faces[face].PointAt((random.U, Math.Min(rest / _faces[face].Area, 1))) with { Pdf = 1 / Area };
    }

    // Seen from outside with y up, u grows to the right and v upwards; on top and bottom −z takes the place of y.
    private static Rectangle Face(Bounds box, int axis, bool isUpper)
    {
        Vector normal = new Vector(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0) * (isUpper ? 1 : -1);
        (Vector right, Vector up) = Sides(normal);
        Vector middle = box.Middle + (normal * (0.5 * box.Size[axis]));
        Vector edgeU = right * Math.Abs(Vector.Dot(right, box.Size));
        Vector edgeV = up * Math.Abs(Vector.Dot(up, box.Size));
        return new(middle - (0.5 * (edgeU + edgeV)), edgeU, edgeV);
    }

    /// <summary>The directions in which u and v grow on a plane with a unit normal.</summary>
    internal static (Vector Right, Vector Up) Sides(Vector normal)
    {
        bool isLevel = (normal.X * normal.X) + (normal.Z * normal.Z) < 1e-6;
        Vector right = Vector.Cross(isLevel ? new(0, 0, -1) : new(0, 1, 0), normal).Unit;
        return (right, Vector.Cross(normal, right));
    }
}
