namespace RayTracer.RenderTests.Oracle;

/// <summary>A shape (report, section 3.3.5).</summary>
/// <param name="material">What it is made of.</param>
internal abstract class Shape(Material material)
{
    public Material Material => material;

    /// <summary>Whether a part whose front is seen may lie behind another part.</summary>
    public virtual bool MayHideItself => false;

    /// <summary>The smallest t in (tMin, tMax) at which a ray meets the shape, or NaN.</summary>
    public abstract double Hit(Vec origin, Vec direction, double tMin, double tMax);

    /// <summary>The outward unit normal at a point of the surface.</summary>
    public abstract Vec Normal(Vec point);

    /// <summary>Texture coordinates of a point of the surface.</summary>
    public abstract (double U, double V) Uv(Vec point);

    /// <summary>
    /// A random point of the surface, and one over its pdf, an area. All points whose front is seen from <paramref name="from"/>
    /// may be chosen.
    /// </summary>
    public abstract (Vec Point, double Area) RandomPoint(Vec from, RandomNumbers random);
}
