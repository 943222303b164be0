using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="OneSidedMaterial"/>.</summary>
[SceneType("oneSided", "Another material, seen from outside only: from behind, against the shape's normal, it is black.")]
public sealed record OneSidedMaterialDescription : MaterialDescription
{
    /// <summary>The material that is seen from outside.</summary>
    [Parameter("The material that is seen from outside; of any type but a luminaire.", Required = true)]
    public MaterialDescription Material { get; init; } = new DiffuseMaterialDescription();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new OneSidedMaterial(WrapperMaterial.Part(builder, this, nameof(Material), Material));
}

/// <summary>Black from behind.</summary>
/// <param name="inner">What is seen from outside.</param>
public sealed class OneSidedMaterial(Material inner) : WrapperMaterial(inner)
{
    /// <inheritdoc/>
    public override ScatteringProperties Scattering { get; } = inner.Scattering with { KeepsEnergy = false };

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        Inner.AmbientResponse(surface, out response);
        response = surface.Inside.Select(default, response);
    }

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo)
    {
        Inner.Albedo(surface, out albedo);
        albedo = surface.Inside.Select(default, albedo);
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf)
    {
        Inner.Brdf(surface, out brdf);
        brdf = surface.Inside.Select(default, brdf);
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Inner.Bsdf(surface, direction, out bsdf);
        bsdf = surface.Inside.Select(default, bsdf);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Inner.Pdf(surface, direction, out pdf);
        pdf = surface.Inside.Select(0f, pdf);
    }

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Inner.Evaluate(surface, direction, out bsdf, out pdf);
        bsdf = surface.Inside.Select(default, bsdf);
        pdf = surface.Inside.Select(0f, pdf);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        Inner.Scatter(surface, samples, out scatter);
        scatter.Absorbed |= surface.Inside;
    }
}
