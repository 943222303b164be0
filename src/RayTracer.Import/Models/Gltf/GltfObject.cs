using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>An object of a glTF file's JSON: its properties by their types. What is missing or wrong throws, with its place.</summary>
internal sealed class GltfObject(GltfSource source, JsonNode node, string path)
{
    /// <summary>The value in the file.</summary>
    public JsonNode Node => node;

    /// <summary>The name of the object in messages, such as <c>meshes[2].primitives[0]</c>; empty for the whole file.</summary>
    public string Path => path;

    /// <summary>True where there is such a property.</summary>
    public bool Has(string key) => node.Find(key) is not null;

    /// <summary>An error about the object.</summary>
    public ModelException Error(string message) => source.Error(node, path.Length > 0 ? $"{path}: {message}" : message);

    /// <summary>An error about a property, or about the object where it has none of that name.</summary>
    public ModelException Error(string key, string message) =>
        source.Error(node.Find(key) ?? node, $"{PathOf(key)}: {message}");

    /// <summary>A whole number; null where there is none.</summary>
    public int? Integer(string key, int minimum = 0, int maximum = int.MaxValue) =>
        node.Find(key) is { } value ? Integer(key, value, minimum, maximum) : null;

    /// <summary>A whole number that must be there.</summary>
    public int RequiredInteger(string key, int minimum = 0, int maximum = int.MaxValue) =>
        Integer(key, minimum, maximum) ?? throw Missing(key);

    /// <summary>A list of whole numbers; empty where there is none.</summary>
    public IReadOnlyList<int> Integers(string key) =>
        [.. Elements(key).Select((item, i) => Integer($"{key}[{i}]", item, 0, int.MaxValue))];

    /// <summary>A number.</summary>
    public float Number(string key, float fallback, float minimum = float.MinValue, float maximum = float.MaxValue) =>
        node.Find(key) is { } value ? Number(key, value, minimum, maximum) : fallback;

    /// <summary>A number that must be there.</summary>
    public float RequiredNumber(string key, float minimum = float.MinValue, float maximum = float.MaxValue) =>
        node.Find(key) is { } value ? Number(key, value, minimum, maximum) : throw Missing(key);

    /// <summary>A list of so many numbers; null where there is none.</summary>
    public float[]? Numbers(string key, int count)
    {
        float[]? numbers = Numbers(key);
        return numbers is null || numbers.Length == count ? numbers : throw Error(key, $"expected {count} numbers, but found {numbers.Length}");
    }

    /// <summary>A list of numbers; null where there is none.</summary>
    public float[]? Numbers(string key) =>
        Has(key) ? [.. Elements(key).Select((item, i) => Number($"{key}[{i}]", item, float.MinValue, float.MaxValue))] : null;

    /// <summary>A fraction; beyond 0 and 1 it is cut off.</summary>
    public float Fraction(string key, float fallback) => float.Clamp(Number(key, fallback), 0, 1);

    /// <summary>A colour, linear, whose channels are cut off at 0 and a largest value.</summary>
    /// <param name="key">The property.</param>
    /// <param name="fallback">The colour where there is none.</param>
    /// <param name="count">The number of numbers of the property; a fourth one is left out.</param>
    /// <param name="largest">The largest value of a channel.</param>
    public Rgb Color(string key, Rgb fallback, int count = 3, float largest = 1) => Numbers(key, count) is { } c
        ? new(float.Clamp(c[0], 0, largest), float.Clamp(c[1], 0, largest), float.Clamp(c[2], 0, largest))
        : fallback;

    /// <summary>A text; null where there is none.</summary>
    public string? Text(string key) => Typed(key, JsonKind.String, "a string")?.Text;

    /// <summary>Texts; empty where there is none.</summary>
    public IReadOnlyList<string> Texts(string key) => [.. Elements(key).Select((item, i) =>
        item.Kind == JsonKind.String ? item.Text : throw source.Error(item, $"{PathOf(key)}[{i}]: expected a string"))];

    /// <summary>True or false.</summary>
    public bool Flag(string key) => Typed(key, JsonKind.Boolean, "true or false") is { Text: "true" };

    /// <summary>An object within; null where there is none.</summary>
    public GltfObject? Child(string key) =>
        Typed(key, JsonKind.Object, "an object") is { } value ? new(source, value, PathOf(key)) : null;

    /// <summary>An object within that must be there.</summary>
    public GltfObject RequiredChild(string key) => Child(key) ?? throw Missing(key);

    /// <summary>A list of objects; empty where there is none.</summary>
    public IReadOnlyList<GltfObject> Children(string key) => [.. Elements(key).Select((item, i) => item.Kind == JsonKind.Object
        ? new GltfObject(source, item, $"{PathOf(key)}[{i}]")
        : throw source.Error(item, $"{PathOf(key)}[{i}]: expected an object"))];

    /// <summary>An extension's object; null where the object does not have it.</summary>
    public GltfObject? Extension(string name) => Child("extensions")?.Child(name);

    /// <summary>That a property is missing.</summary>
    public ModelException Missing(string key) => Error($"{Quotation.Of(key)} is missing");

    private IReadOnlyList<JsonNode> Elements(string key) => Typed(key, JsonKind.Array, "an array")?.Items ?? [];

    private JsonNode? Typed(string key, JsonKind kind, string expected) =>
        node.Find(key) is not { } value || value.Kind == kind ? node.Find(key) : throw Error(key, $"expected {expected}");

    private int Integer(string key, JsonNode value, int minimum, int maximum)
    {
        double number = value.Kind == JsonKind.Number ? double.Parse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture) : double.NaN;
        if (number != Math.Floor(number))
        {
            throw source.Error(value, $"{PathOf(key)}: expected a whole number");
        }

        return number >= minimum && number <= maximum
            ? (int)number
            : throw source.Error(value, $"{PathOf(key)}: {Quotation.Short(value.Text)} is {(number < minimum ? $"less than {minimum}" : $"more than {maximum}")}");
    }

    private float Number(string key, JsonNode value, float minimum, float maximum)
    {
        if (value.Kind != JsonKind.Number)
        {
            throw source.Error(value, $"{PathOf(key)}: expected a number");
        }

        float number = float.Parse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture);
        return number >= minimum && number <= maximum
            ? number
            : throw source.Error(value, $"{PathOf(key)}: {Quotation.Short(value.Text)} is {(number < minimum ? $"less than {minimum}" : $"more than {maximum}")}");
    }

    private string PathOf(string key) => path.Length > 0 ? $"{path}.{key}" : key;
}
