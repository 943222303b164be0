using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>
/// A material that answers as another one does, but for what derived classes change: the surface that the other one sees
/// (<see cref="See"/>), and what they take from its answers (<see cref="Dim(in SurfaceW, ref RgbW)"/>).
/// </summary>
/// <param name="inner">The other material; what it emits is not seen.</param>
public abstract class WrapperMaterial(Material inner) : Material
{
    /// <summary>The other material.</summary>
    protected Material Inner => inner;

    /// <inheritdoc/>
    public override MaterialTraits Traits => inner.Traits with { Emits = false };

    /// <inheritdoc/>
    internal override int Parts => inner.Parts;

    /// <inheritdoc/>
    internal override bool PreparesByRay => base.PreparesByRay || inner.PreparesByRay;

    /// <summary>The material that a part of a record describes: of any type but those that stand around all others, which are errors.</summary>
    /// <param name="builder">Builds it.</param>
    /// <param name="whole">The record.</param>
    /// <param name="property">The part's C# property.</param>
    /// <param name="part">The part.</param>
    public static Material Part(SceneBuilder builder, MaterialDescription whole, string property, MaterialDescription part)
    {
        string? outermost = part is LuminaireMaterialDescription ? "luminaire" : part is MatteMaterialDescription ? RecordType.Of(part.GetType()).Name : null;
        if (outermost is null)
        {
            return builder.Material(part);
        }

        builder.Error(whole, property, $"a {outermost} must not be inside another material: put that material inside the {outermost}");
        return new DiffuseMaterial(new SolidTexture(Rgb.Black));
    }

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => inner.Prepare(ref surface);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        inner.AmbientResponse(surface, out response);
        Dim(surface, ref response);
    }

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo)
    {
        inner.Albedo(surface, out albedo);
        Dim(surface, ref albedo);
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf)
    {
        inner.Brdf(surface, out brdf);
        Dim(surface, ref brdf);
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Unsafe.SkipInit(out SurfaceW room);
        inner.Bsdf(See(surface, ref room), direction, out bsdf);
        FloatW pdf = 0f;
        Dim(surface, direction, ref bsdf, ref pdf);
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Unsafe.SkipInit(out SurfaceW room);
        inner.DiffuseBsdf(See(surface, ref room), direction, out bsdf);
        FloatW pdf = 0f;
        Dim(surface, direction, ref bsdf, ref pdf);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Unsafe.SkipInit(out SurfaceW room);
        inner.Pdf(See(surface, ref room), direction, out pdf);
        RgbW bsdf = default;
        Dim(surface, direction, ref bsdf, ref pdf);
    }

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Unsafe.SkipInit(out SurfaceW room);
        inner.Evaluate(See(surface, ref room), direction, out bsdf, out pdf);
        Dim(surface, direction, ref bsdf, ref pdf);
    }

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency) => inner.Transparency(surface, out transparency);

    /// <inheritdoc/>
    public override void Straight(in SurfaceW surface, out RgbW share)
    {
        inner.Straight(surface, out share);
        Dim(surface, ref share);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        Unsafe.SkipInit(out SurfaceW room);
        inner.Scatter(See(surface, ref room), samples, out scatter);
    }

    /// <summary>The surface as the other material sees it where directions matter.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="room">Takes the surface where it is seen as another one.</param>
    protected virtual ref readonly SurfaceW See(in SurfaceW surface, ref SurfaceW room) => ref surface;

    /// <summary>Takes its part from an answer of the other material that is the same for all directions.</summary>
    protected virtual void Dim(in SurfaceW surface, ref RgbW response)
    {
    }

    /// <summary>Takes its part from the other material's BSDF and density in a direction.</summary>
    protected virtual void Dim(in SurfaceW surface, in Vec3W direction, ref RgbW bsdf, ref FloatW pdf)
    {
    }
}
