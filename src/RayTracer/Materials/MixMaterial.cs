using RayTracer.Description;
using RayTracer.Media;
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
        if (side.TurnsNormal)
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
public sealed class MixMaterial(Material first, Material second, Texture weight) : Material
{
    /// <inheritdoc/>
    public override ScatteringProperties Scattering { get; } = Common(first, second);

    /// <inheritdoc/>
    public override bool IsLit => first.IsLit || second.IsLit;

    /// <inheritdoc/>
    public override bool HasDensity => first.HasDensity || second.HasDensity;

    /// <inheritdoc/>
    public override bool Transmits => first.Transmits || second.Transmits;

    /// <inheritdoc/>
    public override Medium? Interior => first.Interior ?? second.Interior;

    /// <inheritdoc/>
    public override bool UsesUv => first.UsesUv || second.UsesUv || weight.Constant is null;

    /// <inheritdoc/>
    public override bool UsesTangent => first.UsesTangent || second.UsesTangent;

    /// <inheritdoc/>
    public override Nesting? Nesting => first.Nesting ?? second.Nesting;

    /// <inheritdoc/>
    public override bool Disperses => first.Disperses || second.Disperses;

    /// <inheritdoc/>
    public override bool UsesDistance => first.UsesDistance || second.UsesDistance;

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        Own(first, surface, out SurfaceW a);
        first.AmbientResponse(a, out RgbW one);
        Own(second, surface, out SurfaceW b);
        second.AmbientResponse(b, out RgbW other);
        response = Mix(one, other, Weight(surface));
    }

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo)
    {
        Own(first, surface, out SurfaceW a);
        first.Albedo(a, out RgbW one);
        Own(second, surface, out SurfaceW b);
        second.Albedo(b, out RgbW other);
        albedo = Mix(one, other, Weight(surface));
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf)
    {
        Own(first, surface, out SurfaceW a);
        first.Brdf(a, out RgbW one);
        Own(second, surface, out SurfaceW b);
        second.Brdf(b, out RgbW other);
        brdf = Mix(one, other, Weight(surface));
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Own(first, surface, out SurfaceW a);
        first.Bsdf(a, direction, out RgbW one);
        Own(second, surface, out SurfaceW b);
        second.Bsdf(b, direction, out RgbW other);
        bsdf = Mix(one, other, Weight(surface));
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Own(first, surface, out SurfaceW a);
        first.DiffuseBsdf(a, direction, out RgbW one);
        Own(second, surface, out SurfaceW b);
        second.DiffuseBsdf(b, direction, out RgbW other);
        bsdf = Mix(one, other, Weight(surface));
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Own(first, surface, out SurfaceW a);
        first.Pdf(a, direction, out FloatW one);
        Own(second, surface, out SurfaceW b);
        second.Pdf(b, direction, out FloatW other);
        pdf = FloatW.MultiplyAdd(other - one, Weight(surface), one);
    }

    /// <inheritdoc/>
    public override bool IsTransparent => first.IsTransparent || second.IsTransparent;

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency)
    {
        Own(first, surface, out SurfaceW a);
        first.Transparency(a, out RgbW one);
        Own(second, surface, out SurfaceW b);
        second.Transparency(b, out RgbW other);
        transparency = Mix(one, other, Weight(surface));
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        MaskW isSecond = samples.Choose(Weight(surface), out FloatW rest);
        Own(first, surface, out SurfaceW a);
        Own(second, surface, out SurfaceW b);
        ScatterBoth(first, second, a, b, isSecond, rest, samples, out scatter);
    }

    /// <summary>What two materials declare together.</summary>
    internal static ScatteringProperties Common(Material first, Material second) => new()
    {
        Specular = first.Scattering.Specular == second.Scattering.Specular ? first.Scattering.Specular : SpecularLobe.Glossy,
        ReciprocityException = first.Scattering.ReciprocityException ?? second.Scattering.ReciprocityException,
        EnergyException = first.Scattering.EnergyException ?? second.Scattering.EnergyException,
        KeepsEnergy = first.Scattering.KeepsEnergy && second.Scattering.KeepsEnergy,
    };

    /// <summary>Scatters by one of two materials in each lane, both with the same number for their own choice.</summary>
    internal static void ScatterBoth(
        Material first, Material second, in SurfaceW atFirst, in SurfaceW atSecond, MaskW isSecond, in FloatW choice, VertexSamples samples, out ScatterW scatter)
    {
        samples.Leave(choice);
        first.Scatter(atFirst, samples, out scatter);
        samples.Leave(choice);
        second.Scatter(atSecond, samples, out ScatterW other);
        scatter.Direction = isSecond.Select(other.Direction, scatter.Direction);
        scatter.Weight = isSecond.Select(other.Weight, scatter.Weight);
        scatter.Specular = isSecond.Select(other.Specular, scatter.Specular);
        scatter.Delta = isSecond.Select(other.Delta, scatter.Delta);
        scatter.Absorbed = isSecond.Select(other.Absorbed, scatter.Absorbed);
    }

    // Each of the two has a diffuse colour of its own.
    private static void Own(Material material, in SurfaceW surface, out SurfaceW own)
    {
        own = surface;
        material.Prepare(ref own);
        if ((material.Inputs & TextureInputs.VertexColor) == TextureInputs.None)
        {
            own.DiffuseColor *= own.Tint;
        }
    }

    private static RgbW Mix(RgbW a, RgbW b, FloatW weight) => a * (1f - weight) + b * weight;

    private FloatW Weight(in SurfaceW surface)
    {
        weight.Evaluate(surface, out RgbW color);
        return FloatW.Max(0f, FloatW.Min(color.R, 1f));
    }
}
