using System.Numerics;

namespace RayTracer.Description;

/// <summary>The sampling of light sources that are spheres.</summary>
public enum SphereLightSampling
{
    /// <summary>Uniformly in the cone of directions in which the sphere is seen.</summary>
    Cone,

    /// <summary>Uniformly over the whole surface, as in the report: half of the points are hidden, which is noisier.</summary>
    Surface,
}

/// <summary>The treatment of shading normals that disagree with the surface itself.</summary>
public enum ShadingNormals
{
    /// <summary>
    /// Normals that turn away from the ray are mirrored into view, and light that would pass through a surface is dropped.
    /// </summary>
    Mended,

    /// <summary>Normals alone decide from which side a surface is seen, and which light it scatters where.</summary>
    Literal,
}

/// <summary>Describes how a scene is rendered: everything that changes the picture, and nothing that does not.</summary>
public sealed record RenderDescription
{
    /// <summary>Width of the picture.</summary>
    [Parameter("Width of the picture.", Unit = "pixels", Minimum = 1, Maximum = 65536)]
    public int Width { get; init; } = 600;

    /// <summary>Height of the picture.</summary>
    [Parameter("Height of the picture.", Unit = "pixels", Minimum = 1, Maximum = 65536)]
    public int Height { get; init; } = 600;

    /// <summary>Number of samples in each pixel.</summary>
    [Parameter("Samples in each pixel. The jittered and regular samplers need a square (1, 4, 9, 16 …).", Minimum = 1, Maximum = 16777216)]
    public int SamplesPerPixel { get; init; } = 16;

    /// <summary>The most edges of a path without a limit.</summary>
    public const int LongestPath = 30000;

    /// <summary>The algorithm that computes the light that arrives at a pixel.</summary>
    [Parameter("How the light is computed: by unbiased path tracing; with paths from the lights too, where light comes through glass or small openings "
        + "(vcm is the one to try first); as in the report; direct light only; ambient occlusion; or a view of the surfaces alone.")]
    public Integrator Integrator { get; init; } = Integrator.Path;

    /// <summary>The maximum number of edges of a path after the camera, with the path integrator; −1 for no limit.</summary>
    [Parameter("With integrators that follow whole paths: how many edges a path may have. 1 shows lamps only, 2 adds direct light, and each further edge "
        + "one more bounce; -1 sets no limit.", Minimum = -1, Maximum = LongestPath)]
    public int MaxDepth { get; init; } = -1;

    /// <summary>After how many edges paths may end at random, with the path integrator.</summary>
    [Parameter("With integrators that follow whole paths: the number of edges after which paths that carry little light may end at random. It changes the "
        + "noise, not the picture.", Minimum = 1, Maximum = LongestPath)]
    public int RouletteDepth { get; init; } = 5;

    /// <summary>True where light that goes straight through a surface is not bounced there, with the volPath integrator.</summary>
    [Parameter("With the volPath integrator: whether panes (thinDielectric), holes of masks and invisible surfaces, which light passes straight through, are no bounce. "
        + "Then they do not count towards maxDepth, and lights are sampled through them, weakened: also those without extent, which otherwise cast a black "
        + "shadow behind a pane.")]
    public bool StraightThrough { get; init; }

    /// <summary>True where the camera does not see what shines, with the path, direct and volPath integrators.</summary>
    [Parameter("With the path, direct and volPath integrators: whether the camera sees neither lamps, but what is behind them, nor the background or environment; "
        + "only what they light, and their reflections.")]
    public bool HideLights { get; init; }

    /// <summary>How many samples of a pixel share a camera ray, with the path and report integrators.</summary>
    [Parameter("With the path and report integrators: how many samples of a pixel, after the first 16, share a camera ray and the light that comes straight from lamps "
        + "to what it meets; from there on each goes its own way. It saves time, and changes the noise, not the picture. 1 gives each sample a ray of its own, "
        + "as each has anyway with the independent sampler, where the camera has a lens, something moves, light crosses media or disperses, and in scenes with "
        + "meshes, instances, more than 8 lights, a sky or a picture as environment.", Minimum = 1, Maximum = 64)]
    public int Splitting { get; init; } = 4;

    /// <summary>How near to one another paths are merged in the first sample, with the photons and vcm integrators; 0 for a few pixels.</summary>
    [Parameter("With the photons and vcm integrators: how near light paths must come to be counted, in the first sample; the circle shrinks from "
        + "sample to sample. 0 takes a pixel where it meets the scene.", Unit = "scene units", Minimum = 0)]
    public float MergeRadius { get; init; }

    /// <summary>Beyond which distance nothing occludes, with the ambient occlusion integrator; 0 for no limit.</summary>
    [Parameter("With the ao integrator: surfaces farther away than this do not darken; 0 sets no limit.",
        Unit = "scene units", Minimum = 0)]
    public float OcclusionDistance { get; init; }

    /// <summary>The maximum number of diffuse bounces of a path.</summary>
    [Parameter("With the report integrator: how many diffuse bounces a path may have; 0 leaves direct light only.",
        Minimum = 0, Maximum = 255)]
    public int MaxDiffuseDepth { get; init; } = 4;

    /// <summary>The maximum number of specular bounces (mirror, metal, glass) of a path.</summary>
    [Parameter("With the report integrator: how many specular bounces (mirror, metal, glass) a path may have.", Minimum = 0, Maximum = 255)]
    public int MaxSpecularDepth { get; init; } = 4;

    /// <summary>True where transparent shapes weaken the light of sources behind them, with the report integrator.</summary>
    [Parameter("With the report integrator: whether glass, panes and masks between a surface and a light weaken the light, instead of "
        + "casting a dark shadow with bright spots of refracted light (the report's section 4.3.1). That light is not bent: less noise, "
        + "but not what real glass does.")]
    public bool WeakenedShadows { get; init; }

    /// <summary>The treatment of interpolated normals that disagree with the surface itself.</summary>
    [Parameter("With the path, direct and volPath integrators: what happens near the outlines of meshes, where interpolated normals turn "
        + "away from the ray. \"mended\" mirrors them into view and drops light that would pass through the surface; \"literal\" shows the "
        + "surface from behind there, as other renderers do.")]
    public ShadingNormals ShadingNormals { get; init; } = ShadingNormals.Mended;

    /// <summary>The placement of the samples of a pixel.</summary>
    [Parameter("How the samples of a pixel are placed.")]
    public SamplerKind Sampler { get; init; } = SamplerKind.Sobol;

    /// <summary>The weight of the surroundings of a pixel's middle in its colour.</summary>
    [Parameter("How much the surroundings of a pixel's middle contribute to its colour. Without it, a pixel is the mean over its square.")]
    public FilterDescription Filter { get; init; } = new();

    /// <summary>The sampling of sphere lights.</summary>
    [Parameter("How spheres that shine are sampled: within the cone that they fill as seen from the surface, or over the whole surface as "
        + "in the report (noisier).")]
    public SphereLightSampling SphereLightSampling { get; init; } = SphereLightSampling.Cone;

    /// <summary>The times at which the shutter opens and closes, in seconds.</summary>
    [Parameter("The times at which the shutter opens and closes: what moves in between is blurred. Equal times give a sharp picture of "
        + "that instant.", Unit = "seconds")]
    public Vector2 Shutter { get; init; }

    /// <summary>Pictures a second of an animation.</summary>
    [Parameter("Pictures per second of an animation. A single picture does not depend on it.",
        Unit = "1/second", Minimum = 0, MinimumIsExclusive = true)]
    public float FramesPerSecond { get; init; } = 24;

    /// <summary>The curve by which pictures for a display show bright light; null for that of the integrator.</summary>
    [Parameter("How PNG and JPEG files show light that is brighter than a display. Without it, \"soft\", except with the report, ao, normals, "
        + "uv and albedo integrators, whose pictures are as they were computed: \"clamp\". The film does not depend on it.")]
    public ToneMap? ToneMap { get; init; }

    /// <summary>The exposure of pictures for a display.</summary>
    [Parameter("By how many stops PNG and JPEG files are brighter than the light that was computed (each doubles it); \"auto\" makes the middle "
        + "brightness of the picture a middle grey; \"limited\" is 0, but darkens a picture of which more than a quarter would be brighter than a "
        + "display (with \"clamp\" it is 0). The film does not depend on it.", Unit = "stops", Minimum = -100, Maximum = 100)]
    public Exposure Exposure { get; init; } = Exposure.Limited;

    /// <summary>The exposure under the scene's tone map.</summary>
    public Exposure ShownExposure => ExposureUnder(ShownToneMap);

    /// <summary>The curve, or without one the integrator's.</summary>
    public ToneMap ShownToneMap =>
        ToneMap ?? (Integrator.Has(IntegratorTraits.SoftTone) ? Description.ToneMap.Soft : Description.ToneMap.Clamp);

    /// <summary>The exposure under some tone map: of light that is shown as it is, no limited one.</summary>
    public Exposure ExposureUnder(ToneMap map) => (Exposure.Rule, map) == (ExposureRule.Limited, Description.ToneMap.Clamp) ? 0 : Exposure;

    /// <summary>Selects the random numbers.</summary>
    [Parameter("Selects the random numbers: another seed gives the same picture with different noise.", Minimum = 0, Maximum = 4294967295)]
    public long Seed { get; init; }
}
