using System.Text.Json.Serialization;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>One of the things that the view can show of the picture: its light, or an auxiliary image.</summary>
/// <param name="Name">The name; an auxiliary image's is its own.</param>
public sealed record ViewMap(string Name)
{
    private static readonly Rgb[] s_light = [new(0.1f, 0.08f, 0.06f), new(0.54f, 0.35f, 0.2f), new(0.95f, 0.81f, 0.6f), Rgb.White];

    /// <summary>The light.</summary>
    public static ViewMap Light { get; } = new("light");

    /// <summary>The light without most of its noise.</summary>
    public static ViewMap Denoised { get; } = new("denoised");

    /// <summary>All of them.</summary>
    public static IReadOnlyList<ViewMap> All => [Light, Denoised, .. AuxiliaryImage.Known.All.Select(i => new ViewMap(i.Name))];

    /// <summary>The auxiliary image; null for light.</summary>
    [JsonIgnore]
    public AuxiliaryImage? Image => AuxiliaryImage.Known.Find(Name);

    /// <summary>Returns whether it is light, to which exposure and tone map apply.</summary>
    public bool IsLight => Image is null;

    /// <summary>The name that people read.</summary>
    public string Title => Image?.Title ?? SessionTexts.Of($"maps.{Name}.0");

    /// <summary>The description.</summary>
    public string Why => Image?.Description ?? SessionTexts.Of($"maps.{Name}.1");

    /// <summary>The colours of its legend, display values from the left to the right.</summary>
    public IReadOnlyList<Rgb> Scale => Image?.Scale ?? s_light;

    /// <summary>Returns the one of a name.</summary>
    /// <exception cref="SessionException">There is none.</exception>
    public static ViewMap Named(string name) =>
        All.FirstOrDefault(map => map.Name == name) ?? throw new SessionException($"There is no map \"{name}\".");
}
