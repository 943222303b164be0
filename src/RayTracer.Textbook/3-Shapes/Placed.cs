namespace RayTracer.Textbook;

/// <summary>
/// A shape somewhere else, larger, turned or stretched (report, sections 3.3.4 and 6.1): instead of the shape, the ray is moved, by the map back. Its
/// direction is not made a unit vector there, so that distances along it stay the same.
/// </summary>
/// <param name="shape">The shape.</param>
/// <param name="place">The map from its space to the world.</param>
public sealed class Placed(IShape shape, Transform place) : IShape
{
    private readonly Transform _back = place.Inverse();

    /// <inheritdoc/>
    public Bounds Bounds { get; } = shape.Bounds.IsFinite ? place.Box(shape.Bounds) : Bounds.Everywhere;

    /// <inheritdoc/>
    public IEnumerable<IShape> Parts => shape.Parts.Select(part => new Placed(part, place));

    /// <summary>Of maps that scale all directions alike; of others a mean.</summary>
    public double Area { get; } = shape.Area * Math.Pow(Math.Abs(place.Determinant), 2.0 / 3);

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit) => shape.Intersect(Moved(ray), ref hit);

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        shape.Describe(Moved(ray), ref hit);
        bool isFlat = hit.Shading == hit.Normal;
        hit.Point = place.Point(hit.Point);
        hit.Normal = place.Normal(hit.Normal).Unit;
        hit.Shading = isFlat ? hit.Normal : place.Normal(hit.Shading).Unit;
    }

    /// <inheritdoc/>
    public SurfacePoint PointAt((double U, double V) random)
    {
        SurfacePoint point = shape.PointAt(random);
        Vector normal = place.Normal(point.Normal);
        return point with { Point = place.Point(point.Point), Normal = normal.Unit, Pdf = point.Pdf / (Math.Abs(place.Determinant) * normal.Length) };
    }

    /// <summary>Areas grow by the determinant times the length that the map gives to their normal.</summary>
    public double PointPdf(in Hit hit)
    {
        Vector inner = _back.Normal(hit.Normal).Unit;
        return shape.PointPdf(hit) / (Math.Abs(place.Determinant) * place.Normal(inner).Length);
    }

    private Ray Moved(in Ray ray) => new(_back.Point(ray.Origin), _back.Direction(ray.Direction));
}
