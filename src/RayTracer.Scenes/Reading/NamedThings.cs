using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>
/// The things that a scene file defines under names. Each is read when it is first referred to, so that definitions may
/// stand in any order.
/// </summary>
/// <param name="noun">The kind of the things: texture or material.</param>
/// <param name="bag">Takes what is wrong.</param>
/// <param name="definitions">The object whose members are the definitions; null where there is none.</param>
/// <param name="read">Reads the definition of a name.</param>
internal sealed class NamedThings<T>(string noun, DiagnosticBag bag, JsonNode? definitions, Func<JsonMember, T?> read)
    where T : class
{
    private readonly Dictionary<string, JsonMember> _definitions = (definitions?.Members ?? [])
        .DistinctBy(m => m.Key, StringComparer.Ordinal)
        .ToDictionary(m => m.Key, StringComparer.Ordinal);

    private readonly Dictionary<string, T?> _things = new(StringComparer.Ordinal);
    private readonly List<string> _open = [];

    public string Noun => noun;

    public IEnumerable<string> Names => _definitions.Keys;

    public bool Defines(string name) => _definitions.ContainsKey(name);

    /// <summary>The thing of a name that is defined; null after an error in its definition.</summary>
    /// <param name="name">The name.</param>
    /// <param name="reference">The node that refers to it.</param>
    public T? Find(string name, JsonNode reference)
    {
        if (_things.TryGetValue(name, out T? thing))
        {
            return thing;
        }

        int first = _open.IndexOf(name);
        if (first >= 0)
        {
            string circle = string.Join(" → ", _open.Skip(first).Append(name).Select(Quotation.Of));
            return bag.Fail<T>(reference, $"the {noun} {Quotation.Of(name)} contains itself: {circle}");
        }

        if (_open.Count == RecordReader.MaximumNesting)
        {
            return bag.Fail<T>(reference, $"{noun}s are nested more than {RecordReader.MaximumNesting} deep");
        }

        _open.Add(name);
        thing = read(_definitions[name]);
        _open.RemoveAt(_open.Count - 1);
        _things[name] = thing;
        return thing;
    }

    /// <summary>All that could be read, in the order of their definitions.</summary>
    public Dictionary<string, T> All()
    {
        Dictionary<string, T> all = new(StringComparer.Ordinal);
        foreach (JsonMember definition in _definitions.Values)
        {
            if (Find(definition.Key, definition.Value) is { } thing)
            {
                all.Add(definition.Key, thing);
            }
        }

        return all;
    }
}
