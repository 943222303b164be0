using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="MixMaterial"/>.</summary>
[SceneType("mix", "Two materials in one: rust on iron, dirt on paint. A weight, which may be a texture, gives the share of the second.")]
public sealed record MixMaterialDescription : MaterialDescription
{
    /// <summary>The material where the weight is 0.</summary>
    [Parameter("The material where the weight is 0; of any type but a luminaire.", Required = true)]
    public MaterialDescription First { get; init; } = new DiffuseMaterialDescription();

    /// <summary>The material where the weight is 1.</summary>
    [Parameter("The material where the weight is 1; of any type but a luminaire.", Required = true)]
    public MaterialDescription Second { get; init; } = new DiffuseMaterialDescription();

    /// <summary>Share of the second material.</summary>
    [Parameter("Share of the second material: its red channel counts.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Weight { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) =>
        new MixMaterial(Side(builder, nameof(First), First), Side(builder, nameof(Second), Second), builder.NumberTexture(Weight));

    private Material Side(SceneBuilder builder, string property, MaterialDescription description)
    {
        Material side = WrapperMaterial.Part(builder, this, property, description);
        if (side.Traits.TurnsNormal)
        {
            builder.Error(this, property, "a mix cannot hold normal or bump maps: put the map around the mix");
        }

        return side;
    }
}

/// <summary>Two materials, of which each path meets one, at random.</summary>
/// <param name="first">Met with probability 1 − weight.</param>
/// <param name="second">Met with probability weight.</param>
/// <param name="weight">The weight; its red channel counts.</param>
internal sealed class MixMaterial(Material first, Material second, Texture weight) : TwoPartMaterial(first, second)
{
    /// <inheritdoc/>
    public override MaterialTraits Traits => base.Traits with { UsesUv = base.Traits.UsesUv || weight.Constant is null };

    /// <inheritdoc/>
    protected override MaskW Choose(in SurfaceW surface, VertexSamples samples, out FloatW rest) => samples.Choose(Weight(surface), out rest);

    /// <inheritdoc/>
    protected override ref readonly SurfaceW See(Material part, in SurfaceW surface, ref SurfaceW room)
    {
        // Each part has its diffuse colour.
        room = surface;
        part.Prepare(ref room);
        if ((part.Inputs & TextureInputs.VertexColor) == TextureInputs.None)
        {
            room.DiffuseColor *= room.Tint;
        }

        return ref room;
    }

    /// <inheritdoc/>
    protected override RgbW Join(in SurfaceW surface, in RgbW one, in RgbW other)
    {
        FloatW share = Weight(surface);
        return one * (1f - share) + other * share;
    }

    /// <inheritdoc/>
    protected override FloatW Join(in SurfaceW surface, FloatW one, FloatW other) => FloatW.MultiplyAdd(other - one, Weight(surface), one);

    private FloatW Weight(in SurfaceW surface)
    {
        weight.Evaluate(surface, out RgbW color);
        return FloatW.Max(0f, FloatW.Min(color.R, 1f));
    }
}
