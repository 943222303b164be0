using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>The contents of a scene's description, counted by kind; a thing that is used twice counts once.</summary>
internal sealed class SceneContent(SceneDescription scene)
{
    private readonly object[] _records = [.. RecordType.WithParts(scene).Select(p => p.Record)];

    /// <summary>The number of shapes of each kind.</summary>
    public IReadOnlyDictionary<string, int> Shapes => Counts<ShapeDescription>();

    /// <summary>The number of materials of each kind, those within others included.</summary>
    public IReadOnlyDictionary<string, int> Materials => Counts<MaterialDescription>();

    /// <summary>The number of textures of each kind.</summary>
    public IReadOnlyDictionary<string, int> Textures => Counts<TextureDescription>();

    /// <summary>The textures that are pictures.</summary>
    public IEnumerable<ImageTextureDescription> Images => _records.OfType<ImageTextureDescription>();

    private SortedDictionary<string, int> Counts<T>()
        where T : class => new(_records.OfType<T>().CountBy(r => RecordType.Of(r.GetType()).Name).ToDictionary(), StringComparer.Ordinal);
}
