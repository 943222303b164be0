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
/// <param name="inner">The material that is seen from outside.</param>
internal sealed class OneSidedMaterial(Material inner) : WrapperMaterial(inner)
{
    /// <inheritdoc/>
    public override MaterialTraits Traits => base.Traits with { KeepsEnergy = false, IsBoundary = false };

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        base.Scatter(surface, samples, out scatter);
        scatter.Absorbed |= IsBehind(surface, scatter.Direction);
    }

    /// <inheritdoc/>
    protected override void Dim(in SurfaceW surface, ref RgbW response) => response = surface.Inside.Select(default, response);

    /// <inheritdoc/>
    protected override void Dim(in SurfaceW surface, in Vec3W direction, ref RgbW bsdf, ref FloatW pdf)
    {
        MaskW isBehind = IsBehind(surface, direction);
        bsdf = isBehind.Select(default, bsdf);
        pdf = isBehind.Select(0f, pdf);
    }

    // The camera is: where particles of light come along the ray, it is where they go.
    private static MaskW IsBehind(in SurfaceW surface, in Vec3W direction)
    {
        if (!surface.CarriesLight)
        {
            return surface.Inside;
        }

        MaskW crosses = Vec3W.Dot(direction, surface.Facing) < 0f;
        return (surface.Inside | crosses).Except(surface.Inside & crosses);
    }
}
