using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="TwoSidedMaterial"/>.</summary>
[SceneType("twoSided", "Two materials back to back: one is seen from outside, the other from behind. One-sided materials are then seen from both sides.")]
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
        if (side is DielectricMaterial or ThinDielectricMaterial or MaskMaterial || side.Transmits)
        {
            builder.Error(this, property, "a material that lets light through has no separate sides; twoSided needs materials that only reflect");
        }

        return side;
    }
}

/// <summary>One material for rays from outside and one for rays from behind; each of them takes its rays for rays from outside.</summary>
/// <param name="front">For rays from outside.</param>
/// <param name="back">For rays from behind.</param>
public sealed class TwoSidedMaterial(Material front, Material back) : Material
{
    /// <inheritdoc/>
    public override ScatteringProperties Scattering { get; } = MixMaterial.Common(front, back);

    /// <inheritdoc/>
    public override bool IsLit => front.IsLit || back.IsLit;

    /// <inheritdoc/>
    public override bool HasDensity => front.HasDensity || back.HasDensity;

    /// <inheritdoc/>
    public override bool UsesUv => front.UsesUv || back.UsesUv;

    /// <inheritdoc/>
    public override bool UsesTangent => front.UsesTangent || back.UsesTangent;

    /// <inheritdoc/>
    public override bool TurnsNormal => front.TurnsNormal || back.TurnsNormal;

    /// <inheritdoc/>
    public override bool MirrorsNormal => front.MirrorsNormal || back.MirrorsNormal;

    /// <inheritdoc/>
    public override Media.Nesting? Nesting => front.Nesting ?? back.Nesting;

    /// <inheritdoc/>
    public override bool Disperses => front.Disperses || back.Disperses;

    /// <inheritdoc/>
    public override bool UsesDistance => front.UsesDistance || back.UsesDistance;

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface)
    {
        // Maps take both sides for the outside, so that hills are hills on both.
        MaskW inside = surface.Inside;
        surface.Inside = MaskW.None;
        SurfaceW behind = surface;
        front.Prepare(ref surface);
        surface.Inside = inside;
        if (front == back)
        {
            return;
        }

        back.Prepare(ref behind);
        surface.DiffuseColor = surface.Inside.Select(behind.DiffuseColor, surface.DiffuseColor);
        if (TurnsNormal)
        {
            surface.Facing = surface.Inside.Select(behind.Facing, surface.Facing);
            surface.Cosine = surface.Inside.Select(behind.Cosine, surface.Cosine);
            surface.Tangent = surface.Inside.Select(behind.Tangent, surface.Tangent);
            surface.Shading = surface.Inside.Select(behind.Shading, surface.Shading);
        }
    }

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        FromOutside(surface, out SurfaceW turned);
        front.AmbientResponse(turned, out response);
        if (front != back)
        {
            back.AmbientResponse(turned, out RgbW behind);
            response = surface.Inside.Select(behind, response);
        }
    }

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo)
    {
        FromOutside(surface, out SurfaceW turned);
        front.Albedo(turned, out albedo);
        if (front != back)
        {
            back.Albedo(turned, out RgbW behind);
            albedo = surface.Inside.Select(behind, albedo);
        }
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf)
    {
        FromOutside(surface, out SurfaceW turned);
        front.Brdf(turned, out brdf);
        if (front != back)
        {
            back.Brdf(turned, out RgbW behind);
            brdf = surface.Inside.Select(behind, brdf);
        }
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        FromOutside(surface, out SurfaceW turned);
        front.Bsdf(turned, direction, out bsdf);
        if (front != back)
        {
            back.Bsdf(turned, direction, out RgbW behind);
            bsdf = surface.Inside.Select(behind, bsdf);
        }
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        FromOutside(surface, out SurfaceW turned);
        front.DiffuseBsdf(turned, direction, out bsdf);
        if (front != back)
        {
            back.DiffuseBsdf(turned, direction, out RgbW behind);
            bsdf = surface.Inside.Select(behind, bsdf);
        }
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        FromOutside(surface, out SurfaceW turned);
        front.Pdf(turned, direction, out pdf);
        if (front != back)
        {
            back.Pdf(turned, direction, out FloatW behind);
            pdf = surface.Inside.Select(behind, pdf);
        }
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        FromOutside(surface, out SurfaceW turned);
        if (front == back)
        {
            front.Scatter(turned, samples, out scatter);
            return;
        }

        MixMaterial.ScatterBoth(front, back, turned, turned, surface.Inside, samples.Choice(), samples, out scatter);
    }

    private static void FromOutside(in SurfaceW surface, out SurfaceW turned)
    {
        turned = surface;
        turned.Inside = MaskW.None;
        turned.Normal = surface.Inside.Select(-surface.Normal, surface.Normal);
    }
}
