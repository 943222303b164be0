namespace RayTracer.Textbook;

/// <summary>
/// What lies in a plane (report, section 3.3.5): points are corner + u·edgeU + v·edgeV, and the outline says which u and v belong to it.
/// </summary>
/// <param name="corner">Where u and v are 0.</param>
/// <param name="edgeU">From there to where u is 1.</param>
/// <param name="edgeV">From there to where v is 1.</param>
public abstract class Flat(Vector corner, Vector edgeU, Vector edgeV) : IShape
{
    private readonly Vector _normal = Vector.Cross(edgeU, edgeV).Unit;

    // Along the edge of the other coordinate, these do not change.
    private readonly Vector _alongU = Reciprocal(edgeU, edgeV);
    private readonly Vector _alongV = Reciprocal(edgeV, edgeU);

    /// <inheritdoc/>
    public abstract Bounds Bounds { get; }

    /// <inheritdoc/>
    public abstract double Area { get; }

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        double t = Vector.Dot(corner - ray.Origin, _normal) / Vector.Dot(ray.Direction, _normal);
        if (!(t > 0 && t < hit.Distance))
        {
            return false;
        }

        (double u, double v) = Uv(ray.At(t));
        if (!IsInside(u, v))
        {
            return false;
        }

        hit.Distance = t;
        return true;
    }

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        Vector point = ray.At(hit.Distance);
        hit.Point = point - (Vector.Dot(point - corner, _normal) * _normal);
        hit.Normal = hit.Shading = _normal;
        (hit.U, hit.V) = TextureAt(Uv(hit.Point));
    }

    /// <inheritdoc/>
    public SurfacePoint PointAt((double U, double V) random)
    {
        (double u, double v) = Choose(random);
        (double textureU, double textureV) = TextureAt((u, v));
        return new(corner + (u * edgeU) + (v * edgeV), _normal, textureU, textureV, 1 / Area);
    }

    /// <summary>True for u and v within the outline.</summary>
    protected abstract bool IsInside(double u, double v);

    /// <summary>A random point within the outline, uniform by area.</summary>
    protected abstract (double U, double V) Choose((double U, double V) random);

    /// <summary>The place on textures.</summary>
    protected virtual (double U, double V) TextureAt((double U, double V) at) => at;

    /// <summary>The four corners of the rectangle of the two edges.</summary>
    protected Bounds RectangleBounds => Bounds.Around(corner, corner + edgeU, corner + edgeV, corner + edgeU + edgeV);

    /// <summary>The area of the rectangle of the two edges.</summary>
    protected double RectangleArea { get; } = Vector.Cross(edgeU, edgeV).Length;

    private (double U, double V) Uv(Vector point) => (Vector.Dot(point - corner, _alongU), Vector.Dot(point - corner, _alongV));

    private static Vector Reciprocal(Vector edge, Vector other)
    {
        Vector across = Vector.Cross(other, Vector.Cross(edge, other));
        return across * (1 / Vector.Dot(edge, across));
    }
}

/// <summary>A rectangle, or a parallelogram where its edges are not perpendicular.</summary>
/// <param name="corner">A corner.</param>
/// <param name="edgeU">An edge from there.</param>
/// <param name="edgeV">The other edge from there.</param>
public sealed class Rectangle(Vector corner, Vector edgeU, Vector edgeV) : Flat(corner, edgeU, edgeV)
{
    /// <inheritdoc/>
    public override Bounds Bounds => RectangleBounds;

    /// <inheritdoc/>
    public override double Area => RectangleArea;

    /// <inheritdoc/>
    protected override bool IsInside(double u, double v) => u >= 0 && u <= 1 && v >= 0 && v <= 1;

    /// <inheritdoc/>
    protected override (double U, double V) Choose((double U, double V) random) => random;
}

/// <summary>A triangle: half of the rectangle of two of its edges, where u and v are barycentric coordinates (report, section 3.3.3).</summary>
/// <param name="a">First corner, where the others are seen counter-clockwise from the front.</param>
/// <param name="b">Second corner.</param>
/// <param name="c">Third corner.</param>
/// <param name="uv">The places of the corners on textures, each as (u, v, 0).</param>
public sealed class Triangle(Vector a, Vector b, Vector c, (Vector A, Vector B, Vector C) uv) : Flat(a, b - a, c - a)
{
    /// <inheritdoc/>
    public override Bounds Bounds { get; } = Bounds.Around(a, b, c);

    /// <inheritdoc/>
    public override double Area => RectangleArea / 2;

    /// <inheritdoc/>
    protected override bool IsInside(double u, double v) => u >= 0 && v >= 0 && u + v <= 1;

    /// <inheritdoc/>
    protected override (double U, double V) Choose((double U, double V) random) => Warp.Triangle(random);

    /// <inheritdoc/>
    protected override (double U, double V) TextureAt((double U, double V) at)
    {
        Vector place = ((1 - at.U - at.V) * uv.A) + (at.U * uv.B) + (at.V * uv.C);
        return (place.X, place.Y);
    }
}

/// <summary>A disk, in the square around it.</summary>
/// <param name="corner">A corner of the square.</param>
/// <param name="edgeU">An edge of the square from there.</param>
/// <param name="edgeV">The other edge from there.</param>
public sealed class Disk(Vector corner, Vector edgeU, Vector edgeV) : Flat(corner, edgeU, edgeV)
{
    /// <inheritdoc/>
    public override Bounds Bounds => RectangleBounds;

    /// <inheritdoc/>
    public override double Area => RectangleArea * Math.PI / 4;

    /// <inheritdoc/>
    protected override bool IsInside(double u, double v) => ((u - 0.5) * (u - 0.5)) + ((v - 0.5) * (v - 0.5)) <= 0.25;

    /// <inheritdoc/>
    protected override (double U, double V) Choose((double U, double V) random)
    {
        (double x, double y) = Warp.Disk(random);
        return (0.5 + (0.5 * x), 0.5 + (0.5 * y));
    }
}

/// <summary>A plane without end, which cannot shine.</summary>
/// <param name="point">A point of it.</param>
/// <param name="edgeU">Where textures have u = 1, from there.</param>
/// <param name="edgeV">Where textures have v = 1, from there.</param>
public sealed class Plane(Vector point, Vector edgeU, Vector edgeV) : Flat(point, edgeU, edgeV)
{
    /// <inheritdoc/>
    public override Bounds Bounds => Bounds.Everywhere;

    /// <inheritdoc/>
    public override double Area => double.PositiveInfinity;

    /// <inheritdoc/>
    protected override bool IsInside(double u, double v) => true;

    /// <inheritdoc/>
    protected override (double U, double V) Choose((double U, double V) random) => throw new NotSupportedException("a plane without end has no uniform points");
}
