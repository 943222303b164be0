using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="TwoSidedMaterial"/>.</summary>
[SceneType("twoSided", "Two materials back to back: one is seen from outside, the other from behind. One-sided materials are then seen "
    + "from both sides.")]
public sealed record TwoSidedMaterialDescription : MaterialDescription
{
    /// <summary>The material that is seen from outside.</summary>
    [Parameter("The material that is seen from outside; of any type that lets nothing through.", Required = true)]
    public MaterialDescription Front { get; init; } = new DiffuseMaterialDescription();

    /// <summary>The material that is seen from behind; null for the same.</summary>
    [Parameter("The material that is seen from behind, if different.")]
    public MaterialDescription? Back { get; init; }

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        Material front = Side(builder, nameof(Front), Front);
        return new TwoSidedMaterial(front, Back is null ? front : Side(builder, nameof(Back), Back));
    }

    private Material Side(SceneBuilder builder, string property, MaterialDescription description)
    {
        Material side = WrapperMaterial.Part(builder, this, property, description);
        if (side.Traits is { Transmits: true } or { IsTransparent: true })
        {
            builder.Error(this, property, "a material that lets light through has no separate sides; twoSided needs materials that only reflect");
        }

        return side;
    }
}

/// <summary>One material for rays from outside and one for rays from behind; each of them takes its rays for rays from outside.</summary>
/// <param name="front">For rays from outside.</param>
/// <param name="back">For rays from behind.</param>
internal sealed class TwoSidedMaterial(Material front, Material back) : TwoPartMaterial(front, back)
{
    private readonly bool _turnsNormal = (front.Traits | back.Traits).TurnsNormal;

    /// <inheritdoc/>
    public override MaterialTraits Traits => base.Traits with { Interior = null };

    /// <inheritdoc/>
    protected override bool IsOne => First == Second;

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface)
    {
        // Maps take both sides for the outside, so that hills are hills on both.
        MaskW inside = surface.Inside;
        surface.Inside = MaskW.None;
        SurfaceW behind = surface;
        First.Prepare(ref surface);
        surface.Inside = inside;
        if (IsOne)
        {
            return;
        }

        Second.Prepare(ref behind);
        surface.DiffuseColor = surface.Inside.Select(behind.DiffuseColor, surface.DiffuseColor);
        if (_turnsNormal)
        {
            surface.Facing = surface.Inside.Select(behind.Facing, surface.Facing);
            surface.Cosine = surface.Inside.Select(behind.Cosine, surface.Cosine);
            surface.Tangent = surface.Inside.Select(behind.Tangent, surface.Tangent);
            surface.Unmapped = surface.Inside.Select(behind.Unmapped, surface.Unmapped);
        }
    }

    /// <inheritdoc/>
    protected override MaskW Choose(in SurfaceW surface, VertexSamples samples, out FloatW rest)
    {
        rest = samples.Choice();
        return surface.Inside;
    }

    /// <inheritdoc/>
    protected override ref readonly SurfaceW See(Material part, in SurfaceW surface, ref SurfaceW room)
    {
        room = surface;
        room.Inside = MaskW.None;
        room.Normal = surface.Inside.Select(-surface.Normal, surface.Normal);
        return ref room;
    }

    /// <inheritdoc/>
    protected override RgbW Join(in SurfaceW surface, in RgbW one, in RgbW other) => surface.Inside.Select(other, one);

    /// <inheritdoc/>
    protected override FloatW Join(in SurfaceW surface, FloatW one, FloatW other) => surface.Inside.Select(other, one);
}
