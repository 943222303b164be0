using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>The place in a scene file of each description record.</summary>
public sealed class SourceMap
{
    private readonly Dictionary<object, JsonNode> _nodes = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<object, SourcePlace> _places = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<object, HashSet<string>> _replaced = new(ReferenceEqualityComparer.Instance);
    private readonly HashSet<object> _incomplete = new(ReferenceEqualityComparer.Instance);

    /// <summary>The value in the file that a record, or one of its properties, was read from.</summary>
    /// <param name="record">The record: the object itself, not an equal one.</param>
    /// <param name="property">The name of its C# property; null for the record as a whole.</param>
    /// <returns>
    /// The value; for a property that the file leaves out, the record's; null where the record, or the property's value,
    /// is not from the file.
    /// </returns>
    public JsonNode? Find(object record, string? property = null)
    {
        if (!_nodes.TryGetValue(record, out JsonNode? node) || property is null)
        {
            return node;
        }

        if (_replaced.TryGetValue(record, out HashSet<string>? replaced) && replaced.Contains(property))
        {
            return null;
        }

        string? key = RecordType.Of(record.GetType()).Parameters.FirstOrDefault(p => p.PropertyName == property)?.Key;
        return key is not null && node.Find(key) is { } value ? value : node;
    }

    internal void Add(object record, JsonNode node) => _nodes[record] = node;

    // For files that are no JSON.
    internal void Add(object record, SourcePlace place) => _places[record] = place;

    internal SourcePlace? PlaceOf(object record) => _places.TryGetValue(record, out SourcePlace place) ? place : null;

    // A record some of whose values could not be read: what else is said about it may be a consequence.
    internal void MarkIncomplete(object record) => _incomplete.Add(record);

    internal bool IsIncomplete(object record) => _incomplete.Contains(record);

    // Gives a changed copy of a record the positions of all values that are still those of the file.
    internal void Follow(object original, object copy)
    {
        if (PlaceOf(original) is { } place)
        {
            _places[copy] = place;
        }

        if (ReferenceEquals(original, copy) || !_nodes.TryGetValue(original, out JsonNode? node))
        {
            return;
        }

        _nodes[copy] = node;
        _replaced[copy] = [.. RecordType.Of(copy.GetType()).Parameters
            .Where(p => !Equals(p.Get(original), p.Get(copy)))
            .Select(p => p.PropertyName)];
        if (IsIncomplete(original))
        {
            MarkIncomplete(copy);
        }
    }
}

/// <summary>A place in a file, as messages name it.</summary>
/// <param name="File">The file, as its user named it.</param>
/// <param name="Line">The line, from 1; 0 where it is the file as a whole.</param>
/// <param name="Column">The column, from 1, in UTF-16 units; 0 where there is no line.</param>
public readonly record struct SourcePlace(string File, int Line, int Column)
{
    /// <summary>Says something about the place.</summary>
    public Diagnostic At(Severity severity, string message) => new(File, Line, Column, severity, message);
}
