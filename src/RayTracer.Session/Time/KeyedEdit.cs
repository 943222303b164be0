using System.Globalization;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;
using JsonArray = System.Text.Json.Nodes.JsonArray;

namespace RayTracer.Session;

/// <summary>
/// Edits of what is seen at a frame: they are made on the scene as it is there, and what they change of an animated value becomes a key; all else is changed as it
/// is written.
/// </summary>
internal static class KeyedEdit
{
    /// <summary>Makes an edit.</summary>
    /// <param name="text">The text.</param>
    /// <param name="frame">The frame that is shown; null for the scene as it is written.</param>
    /// <param name="change">The edit.</param>
    public static JsonText Apply(JsonText text, int? frame, Func<JsonText, JsonText> change)
    {
        if (frame is not { } number || SceneReader.ReadText(text.Text, "") is not { Description.Animation.Count: > 0 } read)
        {
            return change(text);
        }

        IReadOnlyList<Animated> animated = At(text, read, number);
        JsonText edited = change(Baked(text, animated));
        List<(Animated Track, Json Value)> changed = IsSameTracks(text, edited)
            ? [.. animated.Select(a => (a, Value: ValueAt(edited.Root, a.Address))).Where(c => c.Value is not null && !IsSame(c.Value, c.a.Value)).Select(c => (c.a, c.Value!))] : [];
        if (changed.Count == 0)
        {
            return change(text);
        }

        JsonText restored = animated.Aggregate(edited, (t, a) => a.Written is { } raw ? t.SetText(a.Pointer, raw) : t.Remove(a.Pointer));
        return changed.Aggregate(restored, (t, c) => KeyList.Set(t, $"/animation/{c.Track.Number}/keys", number, c.Value));
    }

    /// <summary>A text with the values of its tracks at a frame.</summary>
    /// <param name="text">The text.</param>
    /// <param name="frame">The frame.</param>
    public static JsonText At(JsonText text, int frame) =>
        SceneReader.ReadText(text.Text, "") is { Description.Animation.Count: > 0 } read ? Baked(text, At(text, read, frame)) : text;

    /// <summary>The places of what the tracks animate, in their order; null for a track that leads nowhere.</summary>
    public static IEnumerable<PropertyAddress?> Tracks(JsonNode root) => (root.Find("animation") is { Kind: JsonKind.Array } list ? list.Items : [])
        .Select(track => track.Find("property") is { Kind: JsonKind.String } property ? PropertyAddress.Find(root, property.Text) : null);

    /// <summary>The value that is written at a place, in the numbers that the renderer calculates with; null where none is.</summary>
    public static Json? ValueAt(JsonNode root, PropertyAddress address) => ValueAt(root, JsonPointer.Of(address.Steps));

    /// <inheritdoc cref="ValueAt(JsonNode, PropertyAddress)"/>
    public static Json? ValueAt(JsonNode root, string pointer) => JsonPointer.Find(root, pointer) is { } node ? Short(JsonValues.Of(node)) : null;

    private static IReadOnlyList<Animated> At(JsonText text, SceneReadResult read, int frame)
    {
        JsonNode then = FrameTimes.Read(read, frame).Root!;
        return [.. Tracks(text.Root).Select((address, i) => Animated.Of(text, then, address, i)).OfType<Animated>()];
    }

    private static JsonText Baked(JsonText text, IReadOnlyList<Animated> animated) => animated.Aggregate(text, (t, a) => t.Set(a.Pointer, a.Whole));

    private static Json? Short(Json? value) => value switch
    {
        JsonArray list => new JsonArray([.. list.Select(Short)]),
        _ when value?.GetValueKind() == System.Text.Json.JsonValueKind.Number => Json.Parse(((float)value.GetValue<double>()).ToString("R", CultureInfo.InvariantCulture)),
        _ => value?.DeepClone(),
    };

    // An edit that changes the tracks themselves, or where they lead, is one of the text.
    private static bool IsSameTracks(JsonText before, JsonText after) =>
        before.Root.Find("animation") is { } old && after.Root.Find("animation") is { } now && before.Text[old.Start..old.End] == after.Text[now.Start..now.End]
        && Tracks(before.Root).Select(Pointer).SequenceEqual(Tracks(after.Root).Select(Pointer));

    private static string? Pointer(PropertyAddress? address) => address is null ? null : JsonPointer.Of(address.Steps);

    // By the numbers that the renderer calculates with.
    private static bool IsSame(Json a, Json b) => (a, b) switch
    {
        (JsonArray x, JsonArray y) => x.Count == y.Count && x.Zip(y).All(p => p.First is { } first && p.Second is { } second && IsSame(first, second)),
        _ => a.GetValueKind() == b.GetValueKind() && (a.GetValueKind() == System.Text.Json.JsonValueKind.Number ? (float)a.GetValue<double>() == (float)b.GetValue<double>() : Json.DeepEquals(a, b)),
    };

    // A track's value at the frame, and what the text has to have in its place for the edit: an element of a vector that is not written is put in with all of it.
    private sealed record Animated(int Number, PropertyAddress Address, Json Value, string Pointer, Json Whole, string? Written)
    {
        public static Animated? Of(JsonText text, JsonNode then, PropertyAddress? address, int number)
        {
            if (address is null || ValueAt(then, address) is not { } value)
            {
                return null;
            }

            string pointer = JsonPointer.Of(address.Steps);
            bool isElement = JsonPointer.Index(address.Steps[^1]) >= 0 && JsonPointer.Find(text.Root, pointer) is null;
            pointer = isElement ? JsonPointer.Parent(pointer)! : pointer;
            Json whole = isElement ? JsonValues.Of(JsonPointer.Find(then, pointer)!)! : value;
            return new(number, address, value, pointer, whole, JsonPointer.Find(text.Root, pointer) is { } node ? text.Text[node.Start..node.End] : null);
        }
    }
}
