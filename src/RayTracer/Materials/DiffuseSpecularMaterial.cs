using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="DiffuseSpecularMaterial"/>.</summary>
[SceneType("diffuseSpecular", "A matt surface under a clear coat: polished stone, plastic, varnish. The coat reflects more at grazing angles: with a probability given by Schlick's approximation from r0, a ray continues as from the specular material, and otherwise as from the diffuse one.")]
public sealed record DiffuseSpecularMaterialDescription : MaterialDescription
{
    /// <summary>The matt surface.</summary>
    [Parameter("The matt surface below the coat: a diffuse material.")]
    public MaterialDescription Diffuse { get; init; } = new DiffuseMaterialDescription();

    /// <summary>What the coat reflects like.</summary>
    [Parameter("How the coat reflects: a phongMetal or dielectric material.")]
    public MaterialDescription Specular { get; init; } = new PhongMetalMaterialDescription { Color = new Textures.SolidTextureDescription { Color = Rgb.White } };

    /// <summary>Reflectance of the coat seen head-on.</summary>
    [Parameter("Fraction that the coat reflects when seen head-on (Schlick's R0): 0.04 for glass, plastic and varnish.", Minimum = 0, Maximum = 1)]
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
/// incidence. Light sources are sampled for the diffuse part, weighted by its probability: the expected value of the
/// report's choice (section 6.2.6) with less noise.
/// </summary>
/// <param name="diffuse">The part that is chosen with probability 1 − R.</param>
/// <param name="specular">The part that is chosen with probability R.</param>
/// <param name="r0">R at normal incidence, 0 to 1.</param>
public sealed class DiffuseSpecularMaterial(Material diffuse, Material specular, float r0) : Material
{
    /// <inheritdoc/>
    public override ScatteringProperties Scattering { get; } = new()
    {
        Specular = specular.Scattering.Specular,
        ReciprocityException = "the coat is chosen by the angle to one of the two directions only (the report's Schlick choice)",
        KeepsEnergy = diffuse.Scattering.KeepsEnergy && specular.Scattering.KeepsEnergy,
    };

    /// <inheritdoc/>
    public override bool IsLit => true;

    /// <inheritdoc/>
    public override bool HasDensity => diffuse.HasDensity || specular.HasDensity;

    /// <inheritdoc/>
    public override bool UsesUv => diffuse.UsesUv || specular.UsesUv;

    /// <inheritdoc/>
    public override Media.Nesting? Nesting => specular.Nesting;

    /// <inheritdoc/>
    public override bool Disperses => diffuse.Disperses || specular.Disperses;

    /// <inheritdoc/>
    public override bool UsesDistance => specular.UsesDistance;

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => diffuse.Prepare(ref surface);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        FloatW reflectance = Fresnel.Schlick(surface.Cosine, r0);
        diffuse.AmbientResponse(surface, out RgbW below);
        specular.AmbientResponse(surface, out RgbW coat);
        response = coat * reflectance + below * (1f - reflectance);
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf)
    {
        diffuse.Brdf(surface, out RgbW below);
        brdf = below * (1f - Fresnel.Schlick(surface.Cosine, r0));
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        FloatW reflectance = Fresnel.Schlick(surface.Cosine, r0);
        diffuse.Bsdf(surface, direction, out RgbW below);
        specular.Bsdf(surface, direction, out RgbW coat);
        bsdf = coat * reflectance + below * (1f - reflectance);
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        diffuse.Bsdf(surface, direction, out bsdf);
        bsdf *= 1f - Fresnel.Schlick(surface.Cosine, r0);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        FloatW reflectance = Fresnel.Schlick(surface.Cosine, r0);
        diffuse.Pdf(surface, direction, out FloatW below);
        specular.Pdf(surface, direction, out FloatW coat);
        pdf = FloatW.MultiplyAdd(coat, reflectance, below * (1f - reflectance));
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        MaskW reflected = samples.Choice() < Fresnel.Schlick(surface.Cosine, r0);
        diffuse.Scatter(surface, samples, out scatter);
        if (!reflected.Any)
        {
            return;
        }

        specular.Scatter(surface, samples, out ScatterW coat);
        scatter.Direction = reflected.Select(coat.Direction, scatter.Direction);
        scatter.Weight = reflected.Select(coat.Weight, scatter.Weight);
        scatter.Specular = reflected.Select(coat.Specular, scatter.Specular);
        scatter.Delta = reflected.Select(coat.Delta, scatter.Delta);
        scatter.Absorbed = reflected.Select(coat.Absorbed, scatter.Absorbed);
    }
}
