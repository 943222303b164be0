using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>
/// A material of two parts, one of which each path meets. Derived classes say which, how each part sees the surface, and how the answers of
/// both join.
/// </summary>
/// <param name="first">One part; what it emits is not seen.</param>
/// <param name="second">The other part.</param>
public abstract class TwoPartMaterial(Material first, Material second) : Material
{
    // Once: of parts of parts of parts, each would ask both of its parts.
    private readonly MaterialTraits _joined = (first.Traits | second.Traits) with { Emits = false };

    private delegate void Answer(Material part, in SurfaceW surface, in Vec3W direction, out RgbW color);

    /// <inheritdoc/>
    public override MaterialTraits Traits => _joined;

    /// <inheritdoc/>
    internal override int Parts { get; } = Math.Min(MostParts + 1, first.Parts + second.Parts);

    /// <inheritdoc/>
    internal override bool PreparesByRay => base.PreparesByRay || first.PreparesByRay || second.PreparesByRay;

    /// <summary>The one part.</summary>
    protected Material First => first;

    /// <summary>The other part.</summary>
    protected Material Second => second;

    /// <summary>The first part answers for both.</summary>
    protected virtual bool IsOne => false;

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response) =>
        AskBoth(static (part, in at, in _, out color) => part.AmbientResponse(at, out color), surface, default, out response);

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo) =>
        AskBoth(static (part, in at, in _, out color) => part.Albedo(at, out color), surface, default, out albedo);

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf) =>
        AskBoth(static (part, in at, in _, out color) => part.Brdf(at, out color), surface, default, out brdf);

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) =>
        AskBoth(static (part, in at, in d, out color) => part.Bsdf(at, d, out color), surface, direction, out bsdf);

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) =>
        AskBoth(static (part, in at, in d, out color) => part.DiffuseBsdf(at, d, out color), surface, direction, out bsdf);

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency) =>
        AskBoth(static (part, in at, in _, out color) => part.Transparency(at, out color), surface, default, out transparency);

    /// <inheritdoc/>
    public override void Straight(in SurfaceW surface, out RgbW share) =>
        AskBoth(static (part, in at, in _, out color) => part.Straight(at, out color), surface, default, out share);

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Unsafe.SkipInit(out SurfaceW room);
        first.Pdf(See(first, surface, ref room), direction, out pdf);
        if (!IsOne)
        {
            second.Pdf(See(second, surface, ref room), direction, out FloatW other);
            pdf = Join(surface, pdf, other);
        }
    }

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Unsafe.SkipInit(out SurfaceW room);
        first.Evaluate(See(first, surface, ref room), direction, out bsdf, out pdf);
        if (!IsOne)
        {
            second.Evaluate(See(second, surface, ref room), direction, out RgbW otherBsdf, out FloatW otherPdf);
            bsdf = Join(surface, bsdf, otherBsdf);
            pdf = Join(surface, pdf, otherPdf);
        }
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        Unsafe.SkipInit(out SurfaceW room);
        if (IsOne)
        {
            first.Scatter(See(first, surface, ref room), samples, out scatter);
            return;
        }

        MaskW isSecond = Choose(surface, samples, out FloatW rest);
        samples.Leave(rest);
        first.Scatter(See(first, surface, ref room), samples, out scatter);
        if (!isSecond.Any)
        {
            return;
        }

        samples.Leave(rest);
        second.Scatter(See(second, surface, ref room), samples, out ScatterW other);
        scatter.Direction = isSecond.Select(other.Direction, scatter.Direction);
        scatter.Weight = isSecond.Select(other.Weight, scatter.Weight);
        scatter.Specular = isSecond.Select(other.Specular, scatter.Specular);
        scatter.Delta = isSecond.Select(other.Delta, scatter.Delta);
        scatter.Absorbed = isSecond.Select(other.Absorbed, scatter.Absorbed);
    }

    /// <summary>Chooses the part that each path meets.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="samples">The random numbers of the vertex.</param>
    /// <param name="rest">The number that is left for the parts' own choices.</param>
    protected abstract MaskW Choose(in SurfaceW surface, VertexSamples samples, out FloatW rest);

    /// <summary>The surface as a part sees it.</summary>
    /// <param name="part">The part.</param>
    /// <param name="surface">The surface.</param>
    /// <param name="room">Takes the surface where the part sees it as another one.</param>
    protected abstract ref readonly SurfaceW See(Material part, in SurfaceW surface, ref SurfaceW room);

    /// <summary>Joins what the two parts scatter.</summary>
    protected abstract RgbW Join(in SurfaceW surface, in RgbW one, in RgbW other);

    /// <summary>Joins the two parts' densities.</summary>
    protected abstract FloatW Join(in SurfaceW surface, FloatW one, FloatW other);

    private void AskBoth(Answer answer, in SurfaceW surface, in Vec3W direction, out RgbW color)
    {
        Unsafe.SkipInit(out SurfaceW room);
        answer(first, See(first, surface, ref room), direction, out color);
        if (!IsOne)
        {
            answer(second, See(second, surface, ref room), direction, out RgbW other);
            color = Join(surface, color, other);
        }
    }
}
