using RayTracer.Description;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>The values that a property panel shows of a place in a scene.</summary>
/// <param name="Pointer">The place.</param>
/// <param name="Type">The record's name in scene files; null where it is none.</param>
/// <param name="Family">shape, material or texture; null where it is none.</param>
/// <param name="Value">The value written there; null where there is none.</param>
/// <param name="Effective">Each of the record's parameters, with the default where nothing is written.</param>
/// <param name="From">Offset of what is written; −1 where nothing is.</param>
/// <param name="To">Offset behind it.</param>
public sealed record PropertyValues(string Pointer, string? Type, string? Family, Json? Value, IReadOnlyDictionary<string, Json?> Effective, int From, int To)
{
    /// <summary>Returns the values at a place, written or not.</summary>
    /// <exception cref="SessionException">A scene has no such place.</exception>
    public static PropertyValues At(JsonNode root, string pointer)
    {
        SceneValue? place = SceneValue.At(root, pointer);
        if (place is null && JsonPointer.Find(root, pointer) is null)
        {
            throw new SessionException($"there is nothing at {JsonLayout.Quote(pointer)}");
        }

        JsonNode? node = place is null ? JsonPointer.Find(root, pointer) : place.Node;
        Dictionary<string, Json?> effective = new(StringComparer.Ordinal);
        foreach (RecordParameter parameter in place?.Type?.Parameters ?? [])
        {
            effective[parameter.Key] = node?.Find(parameter.Key) is { } written ? JsonValues.Of(written) : JsonValues.Of(parameter, parameter.Default);
        }

        return new(pointer, place?.Type?.Name, place?.Family?.Noun, node is null ? null : JsonValues.Of(node), effective, node?.Start ?? -1, node?.End ?? -1);
    }
}
