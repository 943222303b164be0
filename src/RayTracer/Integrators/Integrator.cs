using RayTracer.Rendering;

namespace RayTracer.Description;

/// <summary>The features of an integrator, among all that scenes may ask for.</summary>
[Flags]
public enum IntegratorTraits
{
    /// <summary>Nothing but the surfaces counts: it is a view of them.</summary>
    None = 0,

    /// <summary>Light from light sources counts.</summary>
    Light = 1,

    /// <summary>The light can be split into layers.</summary>
    Layers = 1 << 1,

    /// <summary>Media inside shapes absorb and scatter light.</summary>
    Media = 1 << 2,

    /// <summary>Priorities of dielectrics decide which boundaries are real.</summary>
    Priorities = 1 << 3,

    /// <summary>Ambient light counts.</summary>
    AmbientLight = 1 << 4,

    /// <summary>Transparent things can weaken shadows.</summary>
    WeakenedShadows = 1 << 5,

    /// <summary>Shading normals can be taken literally.</summary>
    LiteralNormals = 1 << 6,

    /// <summary>The environment is sampled as one of the light sources, and where those are many, one is chosen at each point.</summary>
    SampledEnvironment = 1 << 7,

    /// <summary>Light sources are sampled at glossy surfaces too.</summary>
    LitGloss = 1 << 8,

    /// <summary>Diffuse and specular bounces have limits of their number.</summary>
    BounceLimits = 1 << 9,

    /// <summary>Paths have one limit, and may end at random before.</summary>
    PathLimit = 1 << 10,

    /// <summary>Occlusion has a distance.</summary>
    OcclusionDistance = 1 << 11,

    /// <summary>Pictures show light that is too bright for a display by the soft tone map, where scenes name none.</summary>
    SoftTone = 1 << 12,

    /// <summary>Paths start at the lights as well as at the camera: the film has a plane for what those bring.</summary>
    TracesLight = 1 << 13,

    /// <summary>Paths of a sample are merged: they have one time and one wavelength, and the picture is right in the limit only.</summary>
    MergesPaths = 1 << 14,

    /// <summary>Paths can learn where light comes from, and be guided there.</summary>
    Guides = 1 << 15,

    /// <summary>Samples may share their camera rays.</summary>
    Splits = 1 << 16,

    /// <summary>Media inside shapes may vary in space, and may shine.</summary>
    VaryingMedia = 1 << 17,

    /// <summary>What goes straight through surfaces may be no bounce.</summary>
    StraightThrough = 1 << 18,

    /// <summary>What shines can be hidden from the camera.</summary>
    HiddenLights = 1 << 19,
}

/// <summary>The algorithm that computes the light that arrives at a pixel.</summary>
/// <param name="name">The name in scene files, in camelCase.</param>
/// <param name="traits">Those of the things that scenes may ask for which it does; scenes are warned of the rest.</param>
public abstract class Integrator(string name, IntegratorTraits traits) : NamedValue(name)
{
    /// <summary>
    /// The report's: light sources are sampled at matt surfaces, and mirror-like lobes are followed; ambient light, and limits of diffuse
    /// and specular depth.
    /// </summary>
    public static Integrator Report { get; } = new ReportIntegrator();

    /// <summary>Path tracing: light sources and surfaces are both sampled and weighed against each other, without bias. Media inside shapes absorb and scatter light.</summary>
    public static Integrator Path { get; } = new PathIntegrator();

    /// <summary>As path, with light that comes straight from the sources only.</summary>
    public static Integrator Direct { get; } = new DirectIntegrator();

    /// <summary>As path; what goes straight through surfaces may be no bounce.</summary>
    public static Integrator VolPath { get; } = new VolPathIntegrator();

    /// <summary>Light tracing: paths from the lights, connected with the camera.</summary>
    public static Integrator Light { get; } = new LightIntegrator();

    /// <summary>Bidirectional path tracing: paths from the camera and from the lights, connected with each other.</summary>
    public static Integrator Bidirectional { get; } = new BidirectionalIntegrator();

    /// <summary>Progressive photon mapping.</summary>
    public static Integrator Photons { get; } = new PhotonsIntegrator();

    /// <summary>Vertex connection and merging: bidirectional path tracing with photons.</summary>
    public static Integrator Vcm { get; } = new VcmIntegrator();

    /// <summary>Ambient occlusion: how much of an even, white sky each surface sees.</summary>
    public static Integrator Ao { get; } = new AoIntegrator();

    /// <summary>The normals with which surfaces are shaded, as colours.</summary>
    public static Integrator Normals { get; } = new NormalsIntegrator();

    /// <summary>The surface coordinates, as red and green.</summary>
    public static Integrator Uv { get; } = new UvIntegrator();

    /// <summary>The fraction of the light that surfaces send on.</summary>
    public static Integrator Albedo { get; } = new AlbedoIntegrator();

    /// <summary>All integrators.</summary>
    public static Registry<Integrator> Known { get; } = new("integrator", i => [i.Name], Report, Path, Direct, VolPath, Light, Bidirectional, Photons, Vcm, Ao, Normals, Uv, Albedo);

    /// <summary>Returns whether it has all of some traits.</summary>
    public bool Has(IntegratorTraits wanted) => (traits & wanted) == wanted;

    /// <summary>Makes what shades for one thread.</summary>
    protected internal abstract SurfaceShader CreateShader(ShaderContext context);

    // "only the path, direct and volPath integrators support"
    internal static string Only(IntegratorTraits trait, string verb)
    {
        string[] names = [.. Known.All.Where(i => i.Has(trait)).Select(i => i.Name)];
        return names.Length == 1 ? $"only the {names[0]} integrator {verb}s"
            : $"only the {string.Join(", ", names[..^1])} and {names[^1]} integrators {verb}";
    }
}
