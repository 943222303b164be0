using System.Text.Json.Nodes;
using RayTracer.Description;
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
    /// <param name="parameter">The parameter.</param>
    /// <param name="value">A value of it.</param>
    public static string WriteValue(RecordParameter parameter, object value) => JsonLayout.OneLine(ParameterForm.Of(parameter).Write(new SceneWriter(), value));

    /// <summary>Returns a number as JSON.</summary>
    /// <exception cref="ArgumentException">It is not finite.</exception>
    public static Json Number(float number) =>
        float.IsFinite(number) ? JsonValue.Create(number) : throw new ArgumentException($"JSON has no number {number}.", nameof(number));

    internal string FileName(string name) => _file?.Invoke(name) ?? name;

    // A named thing is written as its name.
    internal Json? Thing(object thing) => _names.TryGetValue(thing, out string? name) ? name : Inline(thing);

    internal Json? Inline(object thing) => thing is SolidTextureDescription solid ? ParameterForm.Of(SceneTypes.SolidColor).Write(this, solid.Color)
        : Record(thing, RecordType.Of(thing.GetType()));

    // The first name of a thing is its definition; others refer to it.
    internal JsonObject Named<T>(IReadOnlyDictionary<string, T> things)
        where T : class =>
        new(things.Select(t => KeyValuePair.Create(t.Key, _names[t.Value] == t.Key ? Inline(t.Value) : _names[t.Value])));

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
                json[parameter.Key] = ParameterForm.Of(parameter).Write(this, value);
            }
        }

        return json;
    }

    private bool IsDefault(object value, object? standard) => value switch
    {
        System.Collections.ICollection things => things.Count == 0,
        _ => value.Equals(standard) && !_names.ContainsKey(value),
    };
}
