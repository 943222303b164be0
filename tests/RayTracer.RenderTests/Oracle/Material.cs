namespace RayTracer.RenderTests.Oracle;

/// <summary>A material, with the methods of the report's section 6.2.6.</summary>
internal abstract class Material
{
    /// <summary>Radiance that the surface sends out at an angle to its outward normal.</summary>
    public virtual Vec EmittedRadiance(double cosine, Shape shape, Vec point) => default;

    /// <summary>What ambient light is multiplied by.</summary>
    public virtual Vec AmbientResponse(HitRecord hit) => default;

    /// <summary>The BRDF for light that comes straight from the sources.</summary>
    public virtual Vec ExplicitBrdf(HitRecord hit) => default;

    /// <summary>How the path goes on, or null if it ends here.</summary>
    public abstract Scatter? DiffuseDirection(HitRecord hit, RandomNumbers random);
}

/// <summary>How a path goes on.</summary>
/// <param name="Direction">Unit direction.</param>
/// <param name="Color">Factor on the light that comes from there.</param>
/// <param name="Specular">Whether light that comes straight from the sources is found by this ray only (report: cel).</param>
internal readonly record struct Scatter(Vec Direction, Vec Color, bool Specular);
