namespace RayTracer.Textbook;

/// <summary>Where a ray meets a surface. (The report's HitRecord.)</summary>
public struct Hit
{
    /// <summary>The distance along the ray: at first that beyond which nothing counts.</summary>
    public double Distance;

    /// <summary>The number of the thing in the scene, or of the shape in a tree.</summary>
    public int Index;

    /// <summary>The number of the triangle, or of the face, within the shape.</summary>
    public int Part;

    /// <summary>What was met; null where the ray goes into the open.</summary>
    public Thing? Thing;

    /// <summary>The point.</summary>
    public Vector Point;

    /// <summary>The unit normal of the surface itself, outwards.</summary>
    public Vector Normal;

    /// <summary>The unit normal that it is shaded with: that of what the triangles of a mesh stand for, and else the same.</summary>
    public Vector Shading;

    /// <summary>Where it lies on textures, along them.</summary>
    public double U;

    /// <summary>Where it lies on textures, upwards.</summary>
    public double V;

    /// <summary>True where the ray comes from inside, from behind the normal.</summary>
    public bool Inside;

    /// <summary>The frame of the surface: its third direction is the normal with which it is shaded, on the side that the ray comes from.</summary>
    public Frame Frame;

    /// <summary>The number of nodes of trees that the ray has visited.</summary>
    public int Visits;

    /// <summary>The number of shapes that it was tested against.</summary>
    public int Tests;

    /// <summary>Is shown each node that is visited, by the corners of its box or of the plane that cuts it, and the tests before; null where nobody looks.</summary>
    public Action<Vector[], int>? Watch;

    /// <summary>A hit with nothing yet.</summary>
    /// <param name="limit">The distance beyond which nothing counts.</param>
    public static Hit None(double limit = double.PositiveInfinity) => new() { Distance = limit };

    /// <summary>Sets the side that the ray comes from, and the frame.</summary>
    /// <param name="incoming">The ray's unit direction.</param>
    public void Face(Vector incoming)
    {
        Inside = Vector.Dot(incoming, Normal) > 0;
        Vector side = Inside ? -Normal : Normal;
        if (Shading == Normal)
        {
            Frame = new(side);
            return;
        }

        // Near the outlines of meshes the ray may come from behind the shading normal: there it is mirrored, so that it does not.
        Vector shading = Vector.Dot(Shading, side) < 0 ? -Shading : Shading;
        double along = Math.Max(Vector.Dot(incoming, shading), 0);
        Frame = new(shading - (2 * along * incoming));
    }

    /// <summary>
    /// True for directions between the surface and the plane that it is shaded as: what seems reflected would go through it (Veach 1997, section
    /// 5.3). They carry no light.
    /// </summary>
    /// <param name="direction">A direction in the world.</param>
    /// <param name="cosine">Its cosine with the normal of the frame.</param>
    public readonly bool Leaks(Vector direction, double cosine) =>
        Shading != Normal && Vector.Dot(direction, Inside ? -Normal : Normal) * cosine <= 0;

    /// <summary>A ray that leaves the point. It starts a little off the surface, or rounding would let it meet that again.</summary>
    /// <param name="direction">A unit direction.</param>
    public readonly Ray Leave(Vector direction)
    {
        double offset = 1e-8 * (Point.Largest + Distance);
        return new(Point + (Normal * Math.CopySign(offset, Vector.Dot(direction, Normal))), direction);
    }
}
