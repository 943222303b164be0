using System.Numerics;
using System.Text.Json;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Scenes;

/// <summary>Writes a scene in the native format: values that equal their defaults are left out, and named things are written as names.</summary>
public sealed class SceneWriter
{
    private readonly Dictionary<object, string> _names = new(ReferenceEqualityComparer.Instance);
    private readonly Func<string, string>? _file;

    private SceneWriter(Func<string, string>? file = null) => _file = file;

    /// <summary>The text of a scene file that reads back to an equal scene.</summary>
    /// <param name="scene">The scene; its numbers are finite.</param>
    /// <param name="file">The name to write for a file's name; null to write them as they are.</param>
    /// <returns>JSON, with \n at each line's end.</returns>
    /// <exception cref="ArgumentException">A number that is not finite: JSON has none.</exception>
    public static string Write(SceneDescription scene, Func<string, string>? file = null)
    {
        SceneWriter writer = new(file);
        foreach ((string name, object thing) in scene.Textures.Select(t => (t.Key, (object)t.Value)).Concat(scene.Materials.Select(m => (m.Key, (object)m.Value)))
            .Concat(scene.Objects.Select(o => (o.Key, (object)o.Value))))
        {
            writer._names.TryAdd(thing, name);
        }

        return JsonLayout.Print(writer.Record(scene, SceneTypes.Scene)) + "\n";
    }

    /// <summary>One value as a scene file would have it on one line, for pages and messages.</summary>
    /// <param name="value">A value of any kind of parameter.</param>
    public static string WriteValue(object value) => JsonLayout.OneLine(new SceneWriter().Value(value));

    private JsonObject Record(object record, RecordType type)
    {
        JsonObject json = [];
        if (type.Summary.Length > 0)
        {
            json["type"] = type.Name;
        }

        foreach (RecordParameter parameter in type.Parameters)
        {
            object? value = parameter.Get(record);
            if (value is not null && (parameter.Required || !IsDefault(value, parameter.Default)))
            {
                json[parameter.Key] = _file is not null && parameter.Kind == ParameterKind.File && value is string name ? _file(name) : Value(value);
            }
        }

        return json;
    }

    private bool IsDefault(object value, object? standard) => value switch
    {
        System.Collections.ICollection things => things.Count == 0,
        _ => value.Equals(standard) && !_names.ContainsKey(value),
    };

    private Json? Value(object value) => value switch
    {
        float number => Number(number),
        int number => number,
        long number => number,
        bool flag => flag,
        string text => text,
        Enum or NamedValue => NamedValues.NameOf(value),
        Vector2 v => new JsonArray(Number(v.X), Number(v.Y)),
        Vector3 v => new JsonArray(Number(v.X), Number(v.Y), Number(v.Z)),
        Rgb c => new JsonArray(Number(c.R), Number(c.G), Number(c.B)),
        IReadOnlyDictionary<string, TextureDescription> textures => Named(textures),
        IReadOnlyDictionary<string, MaterialDescription> materials => Named(materials),
        IReadOnlyDictionary<string, ShapeDescription> objects => Named(objects),
        IEnumerable<float> numbers => new JsonArray([.. numbers.Select(n => Number(n))]),
        IEnumerable<int> numbers => new JsonArray([.. numbers.Select(n => (Json?)n)]),
        IEnumerable<Vector2> vectors => new JsonArray([.. vectors.Select(v => Value(v))]),
        IEnumerable<Vector3> vectors => new JsonArray([.. vectors.Select(v => Value(v))]),
        IEnumerable<TriangleIndices> triangles => new JsonArray([.. triangles.Select(t => new JsonArray(t.A, t.B, t.C))]),
        IEnumerable<MaterialDescription> materials => new JsonArray([.. materials.Select(Value)]),
        IEnumerable<TransformDescription> steps => new JsonArray([.. steps.Select(s => Inline(s))]),
        IEnumerable<KeyframeDescription> frames => new JsonArray([.. frames.Select(f => Inline(f))]),
        IEnumerable<TrackDescription> tracks => new JsonArray([.. tracks.Select(t => Inline(t))]),
        IEnumerable<KeyDescription> keys => new JsonArray([.. keys.Select(k => Inline(k))]),
        IEnumerable<ShapeDescription> shapes => new JsonArray([.. shapes.Select(s => Inline(s))]),
        _ => _names.TryGetValue(value, out string? name) ? name : Inline(value),
    };

    // The first name of a thing is its definition; others refer to it.
    private JsonObject Named<T>(IReadOnlyDictionary<string, T> things)
        where T : class =>
        new(things.Select(t => KeyValuePair.Create(t.Key, _names[t.Value] == t.Key ? Inline(t.Value) : (Json?)_names[t.Value])));

    private Json Inline(object thing) =>
        thing is SolidTextureDescription solid ? Value(solid.Color)! : Record(thing, RecordType.Of(thing.GetType()));

    private static JsonValue Number(float number) =>
        float.IsFinite(number) ? JsonValue.Create(number) : throw new ArgumentException($"JSON has no number {number}.", nameof(number));
}
