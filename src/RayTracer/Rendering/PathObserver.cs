using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Sees what happens to paths, stage by stage. A thread has one only where paths are inspected or their light is split into layers; elsewhere
/// it is null. Each method does nothing unless it is overridden.
/// </summary>
internal abstract unsafe class PathObserver
{
    /// <summary>False if it is not to see what light sources send, nor the rays to them, which takes longer.</summary>
    public virtual bool SeesLights => true;

    /// <summary>The observer of light sources: null where nobody is, or it is not to see them.</summary>
    public static PathObserver? OfLights(PathObserver? observer) => observer is { SeesLights: true } ? observer : null;

    /// <summary>Prepares for some samples of a tile.</summary>
    public virtual void Begin(in Tile tile, SampleRange samples)
    {
    }

    /// <summary>Paths meet surfaces, before anything else happens to them there.</summary>
    /// <param name="group">The surfaces.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="lanes">The lanes in use.</param>
    public virtual void Met(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes)
    {
    }

    /// <summary>Paths meet surfaces, or are scattered by a medium.</summary>
    public virtual void BeginPacket(PathStream stream, uint* index, in MaskW lanes)
    {
    }

    /// <summary>Surfaces send their own light.</summary>
    /// <param name="group">The surfaces that paths have met.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="lanes">The lanes in use.</param>
    /// <param name="light">The light that is added.</param>
    /// <param name="radiance">All that the paths have gathered.</param>
    public virtual void Emitted(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance)
    {
    }

    /// <summary>A medium sends its own light along a ray.</summary>
    /// <param name="path">The path's number in the tile.</param>
    /// <param name="light">The light that is added.</param>
    public virtual void Shone(uint path, Rgb light)
    {
    }

    /// <summary>Ambient light is added.</summary>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="lanes">The lanes in use.</param>
    /// <param name="light">The light that is added.</param>
    /// <param name="radiance">All that the paths have gathered.</param>
    public virtual void Brightened(PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance)
    {
    }

    /// <summary>Light sources are to be asked for the packet.</summary>
    /// <param name="weight">
    /// The factor on the light that they send, all of it scattered by matt surfaces unless <see cref="Split"/> says otherwise.
    /// </param>
    public virtual void BeginLights(in RgbW weight)
    {
    }

    /// <summary>A light source has been asked.</summary>
    /// <param name="surface">The lit points.</param>
    /// <param name="material">Their material.</param>
    /// <param name="direction">Unit directions to the light.</param>
    /// <param name="bsdf">The BSDF in those directions.</param>
    public virtual void Split(in SurfaceW surface, Material material, in Vec3W direction, in RgbW bsdf)
    {
    }

    /// <summary>Light of a source arrives at surfaces.</summary>
    /// <param name="light">The source.</param>
    /// <param name="lanes">The lanes that it reaches.</param>
    /// <param name="radiance">The light that arrives, before the weight.</param>
    /// <param name="isWaiting">The rays to the source are still to be traced.</param>
    public virtual void Lit(int light, in MaskW lanes, in RgbW radiance, bool isWaiting)
    {
    }

    /// <summary>Light of a source is scattered by a medium.</summary>
    /// <param name="light">The source.</param>
    /// <param name="lanes">The lanes that it reaches.</param>
    /// <param name="radiance">The light that is added.</param>
    public virtual void LitInMedium(int light, in MaskW lanes, in RgbW radiance)
    {
    }

    /// <summary>Waiting rays to sources have been traced.</summary>
    /// <param name="hits">The things that they have met, in the order of <see cref="Lit"/>; negative for nothing.</param>
    public virtual void Settle(int* hits)
    {
    }

    /// <summary>Paths leave surfaces, or end there.</summary>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="active">The lanes in use.</param>
    /// <param name="alive">Those that have a next ray.</param>
    /// <param name="material">The surfaces' material.</param>
    /// <param name="surface">The surfaces.</param>
    /// <param name="scatter">The next rays.</param>
    /// <param name="isByLobe">
    /// Light is not looked for where the matt part was chosen, so that what is found otherwise is not that part's (report).
    /// </param>
    public virtual void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter,
        bool isByLobe)
    {
    }

    /// <summary>A medium scatters paths, or they end there.</summary>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="active">The lanes in use.</param>
    /// <param name="alive">Those that have a next ray.</param>
    /// <param name="point">The points.</param>
    /// <param name="pdf">Densities of the next rays' directions.</param>
    public virtual void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf)
    {
    }

    /// <summary>Paths go straight through a boundary.</summary>
    public virtual void Crossed(PathStream stream, uint* index, in MaskW active, in SurfaceW surface)
    {
    }

    /// <summary>Paths meet nothing.</summary>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="lanes">The lanes in use.</param>
    /// <param name="arriving">The light of what is behind everything.</param>
    public virtual void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
    }

    /// <summary>All paths of a step are shaded.</summary>
    /// <param name="finished">Those that have ended; the observer may take them from the film.</param>
    /// <param name="next">Those that have a next ray.</param>
    public virtual void EndStep(FinishedPaths finished, PathStream next)
    {
    }

    /// <summary>The film takes a path that has ended.</summary>
    /// <param name="path">The path's number in the tile.</param>
    /// <param name="pixel">The pixel's number in the tile.</param>
    /// <param name="radiance">All that the path has gathered.</param>
    /// <param name="sample">The film's share of it: times the filter's weight.</param>
    public virtual void Finish(uint path, int pixel, Rgb radiance, Rgb sample)
    {
    }
}
