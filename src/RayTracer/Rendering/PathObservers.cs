using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Two observers of the same paths.</summary>
/// <param name="first">Observes everything first.</param>
/// <param name="second">Observes it next.</param>
internal sealed unsafe class PathObservers(PathObserver first, PathObserver second) : PathObserver
{
    /// <summary>Returns an observer for two that may be missing; null where both are.</summary>
    public static PathObserver? Of(PathObserver? first, PathObserver? second) =>
        first is null ? second : second is null ? first : new PathObservers(first, second);

    /// <inheritdoc/>
    public override bool SeesLights => first.SeesLights || second.SeesLights;

    /// <inheritdoc/>
    public override void Begin(in Tile tile, SampleRange samples)
    {
        first.Begin(tile, samples);
        second.Begin(tile, samples);
    }

    /// <inheritdoc/>
    public override void Met(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes)
    {
        first.Met(group, stream, index, lanes);
        second.Met(group, stream, index, lanes);
    }

    /// <inheritdoc/>
    public override void BeginPacket(PathStream stream, uint* index, in MaskW lanes)
    {
        first.BeginPacket(stream, index, lanes);
        second.BeginPacket(stream, index, lanes);
    }

    /// <inheritdoc/>
    public override void Emitted(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance)
    {
        first.Emitted(group, stream, index, lanes, light, radiance);
        second.Emitted(group, stream, index, lanes, light, radiance);
    }

    /// <inheritdoc/>
    public override void Shone(uint path, Rgb light)
    {
        first.Shone(path, light);
        second.Shone(path, light);
    }

    /// <inheritdoc/>
    public override void Brightened(PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance)
    {
        first.Brightened(stream, index, lanes, light, radiance);
        second.Brightened(stream, index, lanes, light, radiance);
    }

    /// <inheritdoc/>
    public override void BeginLights(in RgbW weight)
    {
        first.BeginLights(weight);
        second.BeginLights(weight);
    }

    /// <inheritdoc/>
    public override void Split(in SurfaceW surface, Material material, in Vec3W direction, in RgbW bsdf)
    {
        first.Split(surface, material, direction, bsdf);
        second.Split(surface, material, direction, bsdf);
    }

    /// <inheritdoc/>
    public override void Lit(int light, in MaskW lanes, in RgbW radiance, bool isWaiting)
    {
        first.Lit(light, lanes, radiance, isWaiting);
        second.Lit(light, lanes, radiance, isWaiting);
    }

    /// <inheritdoc/>
    public override void LitInMedium(int light, in MaskW lanes, in RgbW radiance)
    {
        first.LitInMedium(light, lanes, radiance);
        second.LitInMedium(light, lanes, radiance);
    }

    /// <inheritdoc/>
    public override void Settle(int* hits)
    {
        first.Settle(hits);
        second.Settle(hits);
    }

    /// <inheritdoc/>
    public override void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter, bool isByLobe)
    {
        first.Scattered(stream, index, active, alive, material, surface, scatter, isByLobe);
        second.Scattered(stream, index, active, alive, material, surface, scatter, isByLobe);
    }

    /// <inheritdoc/>
    public override void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf)
    {
        first.ScatteredInMedium(stream, index, active, alive, point, pdf);
        second.ScatteredInMedium(stream, index, active, alive, point, pdf);
    }

    /// <inheritdoc/>
    public override void Crossed(PathStream stream, uint* index, in MaskW active, in SurfaceW surface)
    {
        first.Crossed(stream, index, active, surface);
        second.Crossed(stream, index, active, surface);
    }

    /// <inheritdoc/>
    public override void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
        first.Missed(stream, index, lanes, arriving);
        second.Missed(stream, index, lanes, arriving);
    }

    /// <inheritdoc/>
    public override void EndStep(FinishedPaths finished, PathStream next)
    {
        first.EndStep(finished, next);
        second.EndStep(finished, next);
    }

    /// <inheritdoc/>
    public override void Finish(uint path, int pixel, Rgb radiance, Rgb sample)
    {
        first.Finish(path, pixel, radiance, sample);
        second.Finish(path, pixel, radiance, sample);
    }
}
