using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="DiffuseSpecularMaterial"/>.</summary>
[SceneType("diffuseSpecular", "A matt surface under a clear coat: polished stone, plastic, varnish. The coat reflects more at grazing "
    + "angles: a share of the light that Schlick's approximation gives from r0 is reflected as by the specular material, and the rest "
    + "as by the diffuse one.")]
public sealed record DiffuseSpecularMaterialDescription : MaterialDescription
{
    /// <summary>The matt surface.</summary>
    [Parameter("The matt surface below the coat: a diffuse material.")]
    public MaterialDescription Diffuse { get; init; } = new DiffuseMaterialDescription();

    /// <summary>The material that the coat reflects like.</summary>
    [Parameter("How the coat reflects: a phongMetal or dielectric material.")]
    public MaterialDescription Specular { get; init; } = new PhongMetalMaterialDescription { Color = new Textures.SolidTextureDescription { Color = Rgb.White } };

    /// <summary>Reflectance of the coat seen head-on.</summary>
    [Parameter("Fraction that the coat reflects when seen head-on (Schlick's R0): 0.04 for glass, plastic and varnish.",
        Minimum = 0, Maximum = 1)]
    public float R0 { get; init; } = 0.04f;

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        if (Diffuse is not DiffuseMaterialDescription)
        {
            builder.Error(this, nameof(Diffuse), "the \"diffuse\" part must be a diffuse material");
        }

        if (Specular is not (PhongMetalMaterialDescription or DielectricMaterialDescription))
        {
            builder.Error(this, nameof(Specular), "the \"specular\" part must be a phongMetal or dielectric material");
        }

        return new DiffuseSpecularMaterial(builder.Material(Diffuse), builder.Material(Specular), R0);
    }
}

/// <summary>
/// Scatters by one of two materials, chosen at random by Schlick's reflectance (Schlick 1994, eq. 24) of the angle of
/// incidence. Light sources are sampled for the diffuse part, weighted by its share: the expected value of the
/// report's choice (section 6.2.6) with less noise.
/// </summary>
/// <remarks>
/// The coat is chosen with the probability √R, for what it mirrors, lamps above all, is brighter than the diffuse part: with R itself, a lamp in a
/// coat of 4 % is seen by one path of 25.
/// </remarks>
/// <param name="diffuse">The part of which 1 − R is seen.</param>
/// <param name="specular">The part of which R is seen.</param>
/// <param name="r0">R at normal incidence, 0 to 1.</param>
internal sealed class DiffuseSpecularMaterial(Material diffuse, Material specular, float r0) : TwoPartMaterial(diffuse, specular)
{
    /// <inheritdoc/>
    public override MaterialTraits Traits => base.Traits with
    {
        ReciprocityException = "the coat is chosen by the angle to one of the two directions only (the report's Schlick choice)",
        Interior = null,
        IsTransparent = false,
    };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => First.Prepare(ref surface);

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo) => AmbientResponse(surface, out albedo);

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        FloatW reflectance = Fresnel.Schlick(surface.Cosine, r0);
        FloatW chance = FloatW.Sqrt(reflectance);
        FloatW choice = samples.Choice();
        samples.Leave(choice);
        base.Scatter(surface, samples, out scatter);

        // R/√R, or (1 − R)/(1 − √R).
        scatter.Weight *= (choice < chance).Select(chance, 1f + chance);
        if (surface.CarriesLight && scatter.Delta.Any)
        {
            // The coat's share is by the angle on the camera's side, which after a refraction is another one.
            FloatW share = Fresnel.Schlick(FloatW.Abs(Vec3W.Dot(scatter.Direction, surface.Facing)), r0);
            scatter.Weight *= scatter.Delta.Select(share / reflectance, 1f);
        }
    }

    /// <inheritdoc/>
    protected override MaskW Choose(in SurfaceW surface, VertexSamples samples, out FloatW rest)
    {
        rest = samples.Choice();
        return rest < FloatW.Sqrt(Fresnel.Schlick(surface.Cosine, r0));
    }

    /// <inheritdoc/>
    protected override ref readonly SurfaceW See(Material part, in SurfaceW surface, ref SurfaceW room) => ref surface;

    /// <inheritdoc/>
    protected override RgbW Join(in SurfaceW surface, in RgbW one, in RgbW other)
    {
        FloatW reflectance = Fresnel.Schlick(surface.Cosine, r0);
        return other * reflectance + one * (1f - reflectance);
    }

    /// <inheritdoc/>
    protected override FloatW Join(in SurfaceW surface, FloatW one, FloatW other)
    {
        FloatW chance = FloatW.Sqrt(Fresnel.Schlick(surface.Cosine, r0));
        return FloatW.MultiplyAdd(other, chance, one * (1f - chance));
    }
}
