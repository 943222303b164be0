namespace RayTracer.RenderTests.Oracle;

/// <summary>A shape (report, section 3.3.5).</summary>
/// <param name="material">What it is made of.</param>
internal abstract class Shape(Material material)
{
    public Material Material => material;

    /// <summary>The smallest t in (tMin, tMax) at which a ray meets the shape, or NaN.</summary>
    public abstract double Hit(Vec origin, Vec direction, double tMin, double tMax);

    /// <summary>The outward unit normal at a point of the surface.</summary>
    public abstract Vec Normal(Vec point);

    /// <summary>Texture coordinates of a point of the surface.</summary>
    public abstract (double U, double V) Uv(Vec point);

    /// <summary>
    /// A random point, uniform in area over a part of the surface that holds all points whose front is seen from
    /// <paramref name="from"/>, and the area of that part: one over the pdf.
    /// </summary>
    public abstract (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random);
}
