using RayTracer.Numerics;

namespace RayTracer.Description;

/// <summary>
/// Describes a whole scene in plain records: what a scene file says, with every name resolved. Turn it into a
/// renderable <see cref="Rendering.Scene"/> with <see cref="SceneBuilder"/>.
/// </summary>
public sealed record SceneDescription
{
    /// <summary>The camera.</summary>
    [Parameter("The point from which the picture is taken.")]
    public CameraDescription Camera { get; init; } = new();

    /// <summary>Size, samples and depths.</summary>
    [Parameter("Size of the picture, samples, and depth limits.")]
    public RenderDescription Render { get; init; } = new();

    /// <summary>Radiance of every direction in which nothing is hit.</summary>
    [Parameter("The colour seen where a ray hits nothing; it also lights the scene.", Minimum = 0)]
    public Rgb Background { get; init; }

    /// <summary>The surroundings of the scene, instead of <see cref="Background"/>; null where that is used.</summary>
    [Parameter("Light from all around, infinitely far away: a picture, or a sky. It replaces the background.")]
    public EnvironmentDescription? Environment { get; init; }

    /// <summary>Ambient radiance (report, section 4.2): every surface that answers it adds this times its colour.</summary>
    [Parameter("Ambient light: at every hit, this times the surface's colour is added, except on clear glass (a crude stand-in for light "
        + "that is not simulated).", Minimum = 0)]
    public Rgb Ambient { get; init; }

    /// <summary>Named textures.</summary>
    [Parameter("Textures, by the names under which materials refer to them.")]
    public IReadOnlyDictionary<string, TextureDescription> Textures { get; init; } = new Dictionary<string, TextureDescription>();

    /// <summary>Named materials.</summary>
    [Parameter("Materials, by the names under which shapes refer to them.")]
    public IReadOnlyDictionary<string, MaterialDescription> Materials { get; init; } = new Dictionary<string, MaterialDescription>();

    /// <summary>Named shapes that are seen only through their instances.</summary>
    [Parameter("Shapes, by the names under which instances show them; they are not visible by themselves.")]
    public IReadOnlyDictionary<string, ShapeDescription> Objects { get; init; } = new Dictionary<string, ShapeDescription>();

    /// <summary>The shapes; those with a luminaire material shine and are sampled as lights.</summary>
    [Parameter("The objects in the scene. Those whose material is a luminaire shine.")]
    public IReadOnlyList<ShapeDescription> Shapes { get; init; } = [];

    /// <summary>Shapes that must shine: the report's list of lights. They are part of the scene like all shapes.</summary>
    [Parameter("Shapes that shine: as under shapes, but each must have a luminaire material.")]
    public IReadOnlyList<ShapeDescription> Lights { get; init; } = [];

    /// <summary>
    /// The tracks of values that change from frame to frame; a scene that was read at a frame already has its values there.
    /// </summary>
    [Parameter("What changes from frame to frame in an animation (--frames), besides shapes with a motion: numbers, vectors and colours "
        + "anywhere in the scene.")]
    public IReadOnlyList<TrackDescription> Animation { get; init; } = [];
}
