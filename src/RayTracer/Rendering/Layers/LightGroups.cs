using RayTracer.Description;

namespace RayTracer.Rendering;

/// <summary>The layers of light that a scene's sources make, a number for each.</summary>
internal sealed class LightGroups
{
    private const string Unnamed = "unnamed";
    private readonly List<string> _names = [];
    private readonly int[] _groupOfLight;

    /// <summary>Finds them.</summary>
    public LightGroups(Scene scene)
    {
        _groupOfLight = [.. scene.Lights.Select(l => Number(l.Label?.Text ?? Unnamed))];
        if (_names.Count == 0 && Array.Exists(scene.Groups, g => g.Traits.Emits))
        {
            Number(Unnamed);
        }

        if (scene.Environment is not null || !scene.Background.IsBlack)
        {
            Sky = Number(scene.Environment?.Label?.Text ?? "background");
        }

        if (!scene.Ambient.IsBlack && scene.Render.Integrator.Has(IntegratorTraits.AmbientLight))
        {
            Ambient = Number("ambient");
        }

        if (scene.HasMedia && scene.Media.Shine)
        {
            Media = Number("media");
        }
    }

    /// <summary>Their names, each once, in the order of the lights.</summary>
    public IReadOnlyList<string> Names => _names;

    /// <summary>That of what is behind everything; −1 where that is black.</summary>
    public int Sky { get; } = -1;

    /// <summary>That of ambient light; −1 where there is none.</summary>
    public int Ambient { get; } = -1;

    /// <summary>That of media that send light; −1 where there is none.</summary>
    public int Media { get; } = -1;

    /// <summary>
    /// That of a light, by its number among those that are sampled: the environment comes last. What shines but is too large to be sampled
    /// counts as the first.
    /// </summary>
    public int Of(int light) => light < 0 ? 0 : light < _groupOfLight.Length ? _groupOfLight[light] : Sky;

    private int Number(string name)
    {
        int known = _names.IndexOf(name);
        if (known < 0)
        {
            known = _names.Count;
            _names.Add(name);
        }

        return known;
    }
}
