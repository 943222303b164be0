using System.Collections;
using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>The contents of a scene's description, counted by kind; a thing that is used twice counts once.</summary>
internal sealed class SceneContent
{
    private readonly HashSet<object> _seen = new(ReferenceEqualityComparer.Instance);
    private readonly SortedDictionary<string, int> _shapes = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, int> _materials = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, int> _textures = new(StringComparer.Ordinal);
    private readonly List<ImageTextureDescription> _images = [];

    private SceneContent()
    {
    }

    /// <summary>The number of shapes of each kind.</summary>
    public IReadOnlyDictionary<string, int> Shapes => _shapes;

    /// <summary>The number of materials of each kind, those within others included.</summary>
    public IReadOnlyDictionary<string, int> Materials => _materials;

    /// <summary>The number of textures of each kind.</summary>
    public IReadOnlyDictionary<string, int> Textures => _textures;

    /// <summary>The textures that are pictures.</summary>
    public IReadOnlyList<ImageTextureDescription> Images => _images;

    /// <summary>Counts.</summary>
    public static SceneContent Of(SceneDescription scene)
    {
        SceneContent content = new();
        content.Visit(scene);
        return content;
    }

    private void Visit(object? value)
    {
        switch (value)
        {
            case SceneDescription or ShapeDescription or MaterialDescription or TextureDescription or EnvironmentDescription when _seen.Add(value):
                VisitRecord(value);
                break;
            case IDictionary named:
                Visit(named.Values);
                break;
            case IEnumerable things and not string:
                foreach (object thing in things)
                {
                    Visit(thing);
                }

                break;
        }
    }

    private void VisitRecord(object record)
    {
        RecordType type = RecordType.Of(record.GetType());
        SortedDictionary<string, int>? counts = record switch
        {
            ShapeDescription => _shapes,
            MaterialDescription => _materials,
            TextureDescription => _textures,
            _ => null,
        };
        if (counts is not null)
        {
            counts[type.Name] = counts.GetValueOrDefault(type.Name) + 1;
        }

        if (record is ImageTextureDescription image)
        {
            _images.Add(image);
        }

        foreach (RecordParameter parameter in type.Parameters)
        {
            Visit(parameter.Get(record));
        }
    }
}
