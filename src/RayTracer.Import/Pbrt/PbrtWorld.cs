namespace RayTracer.Import;

/// <summary>The things of a scene, with what held where each of them stands.</summary>
internal sealed class PbrtWorld
{
    /// <summary>The one thing of a kind of which a scene has one: camera, film, sampler, filter and integrator.</summary>
    public Dictionary<string, PbrtThing> Only { get; } = new(StringComparer.Ordinal);

    /// <summary>Shapes that are seen, and instances, in their order.</summary>
    public List<PbrtThing> Shapes { get; } = [];

    /// <summary>Lights that are no surfaces.</summary>
    public List<PbrtThing> Lights { get; } = [];

    /// <summary>Materials, by their names.</summary>
    public Dictionary<string, PbrtThing> Materials { get; } = new(StringComparer.Ordinal);

    /// <summary>Textures, by what they are of (float or spectrum) and their names.</summary>
    public Dictionary<(string Of, string Name), PbrtThing> Textures { get; } = [];

    /// <summary>Media, by their names.</summary>
    public Dictionary<string, PbrtThing> Media { get; } = new(StringComparer.Ordinal);

    /// <summary>Objects that instances show, by their names.</summary>
    public Dictionary<string, List<PbrtThing>> Objects { get; } = new(StringComparer.Ordinal);
}
