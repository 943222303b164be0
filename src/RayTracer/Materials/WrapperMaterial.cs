using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>A material that answers as another one does, but for what derived classes change.</summary>
/// <param name="inner">The other material.</param>
public abstract class WrapperMaterial(Material inner) : Material
{
    /// <summary>The other material.</summary>
    protected Material Inner => inner;

    /// <inheritdoc/>
    public override ScatteringProperties Scattering => inner.Scattering;

    /// <inheritdoc/>
    public override bool IsLit => inner.IsLit;

    /// <inheritdoc/>
    public override bool HasDensity => inner.HasDensity;

    /// <inheritdoc/>
    public override bool Transmits => inner.Transmits;

    /// <inheritdoc/>
    public override Medium? Interior => inner.Interior;

    /// <inheritdoc/>
    public override bool UsesUv => inner.UsesUv;

    /// <inheritdoc/>
    public override bool UsesTangent => inner.UsesTangent;

    /// <inheritdoc/>
    public override bool TurnsNormal => inner.TurnsNormal;

    /// <inheritdoc/>
    public override bool MirrorsNormal => inner.MirrorsNormal;

    /// <inheritdoc/>
    public override Nesting? Nesting => inner.Nesting;

    /// <inheritdoc/>
    public override bool Disperses => inner.Disperses;

    /// <inheritdoc/>
    public override bool UsesDistance => inner.UsesDistance;

    /// <summary>The material that a part of a record describes: of any type but a luminaire, which is an error.</summary>
    /// <param name="builder">Builds it.</param>
    /// <param name="whole">The record.</param>
    /// <param name="property">The part's C# property.</param>
    /// <param name="part">The part.</param>
    public static Material Part(SceneBuilder builder, MaterialDescription whole, string property, MaterialDescription part)
    {
        if (part is not LuminaireMaterialDescription)
        {
            return builder.Material(part);
        }

        builder.Error(whole, property, "a luminaire must not be inside another material: put that material inside the luminaire");
        return new DiffuseMaterial(new SolidTexture(Rgb.Black));
    }

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => inner.Prepare(ref surface);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response) => inner.AmbientResponse(surface, out response);

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo) => inner.Albedo(surface, out albedo);

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf) => inner.Brdf(surface, out brdf);

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) => inner.Bsdf(surface, direction, out bsdf);

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) => inner.DiffuseBsdf(surface, direction, out bsdf);

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf) => inner.Pdf(surface, direction, out pdf);

    /// <inheritdoc/>
    public override bool IsTransparent => inner.IsTransparent;

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency) => inner.Transparency(surface, out transparency);

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter) => inner.Scatter(surface, samples, out scatter);
}
