using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="MaskMaterial"/>.</summary>
[SceneType("mask", "Another material with holes: leaves, wire mesh, lace. Where the opacity is 0, light passes straight through.")]
public sealed record MaskMaterialDescription : MaterialDescription
{
    /// <summary>The material where the opacity is 1.</summary>
    [Parameter("The material where the opacity is 1; of any type but a luminaire.", Required = true)]
    public MaterialDescription Material { get; init; } = new DiffuseMaterialDescription();

    /// <summary>Share of the light that meets the material.</summary>
    [Parameter("Fraction of the light that meets the material; the rest passes straight through. The red channel counts.",
        Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Opacity { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <summary>The medium inside.</summary>
    [Parameter("What fills the inside of the (closed) shape, unless the material says so itself. Shown by path, volPath and the integrators that trace light.")]
    public MediumDescription Interior { get; init; } = new();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) =>
        new MaskMaterial(WrapperMaterial.Part(builder, this, nameof(Material), Material), builder.NumberTexture(Opacity), builder.Medium(Interior));
}

/// <summary>Lets a share of the light straight through, and scatters the rest by another material.</summary>
/// <param name="inner">The other material.</param>
/// <param name="opacity">The share that meets it; its red channel counts.</param>
/// <param name="interior">The medium inside; null for nothing. That of the other material comes first.</param>
internal sealed class MaskMaterial(Material inner, Texture opacity, Medium? interior = null) : WrapperMaterial(inner)
{
    /// <inheritdoc/>
    public override MaterialTraits Traits => base.Traits with
    {
        Interior = Inner.Traits.Interior ?? interior,
        IsTransparent = true,
        PassesStraight = true,
        Specular = Inner.Traits.HasDensity ? SpecularLobe.Glossy : SpecularLobe.Delta,
        UsesUv = Inner.Traits.UsesUv || opacity.Constant is null,
    };

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency)
    {
        Inner.Transparency(surface, out RgbW through);
        FloatW opaque = Opacity(surface);
        FloatW free = 1f - opaque;
        transparency = (through * opaque) + new RgbW(free, free, free);
    }

    /// <inheritdoc/>
    public override void Straight(in SurfaceW surface, out RgbW share)
    {
        base.Straight(surface, out share);
        FloatW free = 1f - Opacity(surface);
        share += new RgbW(free, free, free);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        MaskW meets = samples.Choose(Opacity(surface), out FloatW rest);
        samples.Leave(rest);
        Inner.Scatter(surface, samples, out scatter);
        scatter.Direction = meets.Select(scatter.Direction, surface.Incoming);
        scatter.Weight = meets.Select(scatter.Weight, Rgb.White);
        scatter.Specular |= ~meets;
        scatter.Delta |= ~meets;
        scatter.Absorbed &= meets;
    }

    /// <inheritdoc/>
    protected override void Dim(in SurfaceW surface, ref RgbW response) => response *= Opacity(surface);

    /// <inheritdoc/>
    protected override void Dim(in SurfaceW surface, in Vec3W direction, ref RgbW bsdf, ref FloatW pdf)
    {
        FloatW opaque = Opacity(surface);
        bsdf *= opaque;
        pdf *= opaque;
    }

    private FloatW Opacity(in SurfaceW surface)
    {
        opacity.Evaluate(surface, out RgbW color);
        return FloatW.Max(0f, FloatW.Min(color.R, 1f));
    }
}
