namespace RayTracer.Textbook;

/// <summary>A surface that rays can meet. It knows nothing of what it is made of.</summary>
public interface IShape
{
    /// <summary>A box around it.</summary>
    Bounds Bounds { get; }

    /// <summary>
    /// Between which values the products of its points with a direction lie: how far it reaches along that. Unless the shape knows better, those of the
    /// box.
    /// </summary>
    /// <param name="direction">A unit direction.</param>
    (double Low, double High) Along(Vector direction)
    {
        double middle = Vector.Dot(Bounds.Middle, direction);
        double reach = 0.5 * ((Math.Abs(direction.X) * Bounds.Size.X) + (Math.Abs(direction.Y) * Bounds.Size.Y) + (Math.Abs(direction.Z) * Bounds.Size.Z));
        return (middle - reach, middle + reach);
    }

    /// <summary>The shapes that it consists of, for trees of all of them; mostly itself.</summary>
    IEnumerable<IShape> Parts => [this];

    /// <summary>Its area; infinite where it has no end.</summary>
    double Area { get; }

    /// <summary>
    /// Finds the first point beyond the ray's origin. Where that is nearer than <see cref="Hit.Distance"/>, this is set, and <see cref="Hit.Part"/> where
    /// the shape has parts; everything else waits for <see cref="Describe"/>, as most hits are hidden by others.
    /// </summary>
    /// <param name="ray">The ray; its direction may have any length.</param>
    /// <param name="hit">The nearest hit so far.</param>
    /// <returns>True where it was changed.</returns>
    bool Intersect(in Ray ray, ref Hit hit);

    /// <summary>Sets point, normals, u and v of a hit that turned out to be the nearest.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="hit">The hit, as <see cref="Intersect"/> left it.</param>
    void Describe(in Ray ray, ref Hit hit);

    /// <summary>A random point of the surface.</summary>
    /// <param name="random">Two random numbers from 0 to 1.</param>
    SurfacePoint PointAt((double U, double V) random);

    /// <summary>The density, per unit of area, with which <see cref="PointAt"/> chooses a point.</summary>
    double PointPdf(in Hit hit) => 1 / Area;

    /// <summary>A random point of the part that may be seen from a place: unless the shape knows better, of the whole surface.</summary>
    /// <param name="from">The place.</param>
    /// <param name="random">Two random numbers from 0 to 1.</param>
    /// <returns>The point, and the density per steradian of its direction: areas look smaller by the cosine and the squared distance.</returns>
    (SurfacePoint Point, double Pdf) PointSeenFrom(Vector from, (double U, double V) random)
    {
        SurfacePoint point = PointAt(random);
        return (point, point.Pdf * PerSteradian(from, point.Point, point.Normal));
    }

    /// <summary>The density per steradian with which <see cref="PointSeenFrom"/> chooses the direction of a hit.</summary>
    double SeenPdf(Vector from, in Hit hit) => PointPdf(hit) * PerSteradian(from, hit.Point, hit.Normal);

    /// <summary>How much of a unit of area at a point makes a steradian as seen from a place.</summary>
    static double PerSteradian(Vector from, Vector point, Vector normal)
    {
        Vector to = point - from;
        double distance2 = Vector.Dot(to, to);
        double cosine = Math.Abs(Vector.Dot(to, normal)) / Math.Sqrt(distance2);
        return cosine > 0 ? distance2 / cosine : 0;
    }
}

/// <summary>A point that was chosen on a surface.</summary>
/// <param name="Point">The point.</param>
/// <param name="Normal">The unit normal there.</param>
/// <param name="U">Where it lies on textures.</param>
/// <param name="V">Where it lies on textures.</param>
/// <param name="Pdf">The density with which it was chosen, per unit of area.</param>
public readonly record struct SurfacePoint(Vector Point, Vector Normal, double U, double V, double Pdf);
