using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Media;

/// <summary>
/// A point in a medium in the place of a surface's, for paths that are connected: scattering has a BSDF there as well, the phase function, but no cosines
/// (Pauly, Kollig &amp; Keller 2000, who extend the paths of Veach 1997, chapter 8, to media).
/// </summary>
/// <param name="media">The scene's media.</param>
internal sealed class MediumMaterial(MediumTable media) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new() { IsLit = true, Transmits = true, KeepsEnergy = true };

    /// <summary>Describes where media have scattered paths.</summary>
    /// <param name="media">The scene's media.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="surface">The points, with what the others of these functions ask for.</param>
    public static unsafe void Describe(MediumTable media, PathStream stream, uint* index, out SurfaceW surface)
    {
        UIntW stack = UIntW.Pick(stream.Media, index);
        surface = default;
        surface.Incoming = stream.PickDirection(index);
        surface.Point = Vec3W.MultiplyAdd(surface.Incoming, FloatW.Pick(stream.Distance, index), stream.PickOrigin(index));
        surface.Normal = surface.Facing = -surface.Incoming;
        surface.Rules = NormalRules.InMedium;
        surface.DiffuseColor = media.Albedo(stack);
        (surface.U, surface.V) = (MediumStack.Innermost(stack).ToFloat(), media.MeanExtinction(stack));
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Pdf(surface, direction, out FloatW phase);
        bsdf = new(phase, phase, phase);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf) =>
        pdf = media.Phase(surface.U.ToInt(), surface.Point, surface.Incoming, direction);

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Pdf(surface, direction, out pdf);
        bsdf = new(pdf, pdf, pdf);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        scatter = default;
        scatter.Direction = media.Scatter(surface.U.ToInt(), surface.Point, surface.Incoming, samples, out _);
        scatter.Weight = Rgb.White;
    }
}
