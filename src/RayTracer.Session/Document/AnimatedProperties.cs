using System.Globalization;
using System.Text.Json.Nodes;
using RayTracer.Scenes;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>Keeps the tracks of an animation with the things that they animate, when these are renamed, copied or deleted.</summary>
internal static class AnimatedProperties
{
    /// <summary>Removes a thing, and the tracks that animate it.</summary>
    public static JsonText Remove(JsonText text, string pointer)
    {
        JsonText left = text.Remove(pointer);
        string[] gone = JsonPointer.Parse(pointer);
        bool isElement = text.At(JsonPointer.Parent(pointer)!).Kind == JsonKind.Array;
        return Follow(text, left, steps => StartsWith(steps, gone, gone.Length) ? null : isElement ? Shifted(steps, gone, -1) : steps);
    }

    /// <summary>Lets the tracks follow a thing that has another name.</summary>
    /// <param name="before">The text before.</param>
    /// <param name="after">The text with the other name.</param>
    /// <param name="pointer">The thing before.</param>
    /// <param name="renamed">The thing now.</param>
    public static JsonText Renamed(JsonText before, JsonText after, string pointer, string renamed)
    {
        string[] old = JsonPointer.Parse(pointer);
        string[] now = JsonPointer.Parse(renamed);
        return Follow(before, after, steps => StartsWith(steps, old, old.Length) ? [.. now, .. steps.Skip(old.Length)] : steps);
    }

    /// <summary>Lets the tracks follow what has moved on in a list by a copy.</summary>
    /// <param name="before">The text before.</param>
    /// <param name="after">The text with the copy.</param>
    /// <param name="copy">The copy.</param>
    public static JsonText Inserted(JsonText before, JsonText after, string copy)
    {
        string[] made = JsonPointer.Parse(copy);
        return after.At(JsonPointer.Parent(copy)!).Kind == JsonKind.Array ? Follow(before, after, steps => Shifted(steps, made, 1)) : after;
    }

    private static JsonText Follow(JsonText before, JsonText after, Func<IReadOnlyList<string>, IReadOnlyList<string>?> moved)
    {
        IReadOnlyList<JsonNode> tracks = before.Root.Find("animation") is { Kind: JsonKind.Array } list ? list.Items : [];
        for (int i = tracks.Count - 1; i >= 0; i--)
        {
            if (tracks[i].Find("property") is not { Kind: JsonKind.String } property || PropertyAddress.Find(before.Root, property.Text) is not { } address)
            {
                continue;
            }

            string track = JsonPointer.Append("/animation", i);
            if (moved(address.Steps) is not { } steps)
            {
                after = after.Remove(track);
            }
            else if ((address with { Steps = steps }).Path(after.Root) is var path && path != address.Path(before.Root))
            {
                after = after.Set(JsonPointer.Append(track, "property"), JsonValue.Create(path));
            }
        }

        return after;
    }

    private static bool StartsWith(IReadOnlyList<string> steps, string[] prefix, int count) =>
        steps.Count >= count && steps.Take(count).SequenceEqual(prefix.Take(count), StringComparer.Ordinal);

    // Elements of the same list, from that of the pointer on, have other numbers.
    internal static IReadOnlyList<string> Shifted(IReadOnlyList<string> steps, string[] pointer, int by)
    {
        int at = pointer.Length - 1;
        return steps.Count > at && StartsWith(steps, pointer, at) && JsonPointer.Index(steps[at]) >= JsonPointer.Index(pointer[at])
            ? [.. steps.Take(at), (JsonPointer.Index(steps[at]) + by).ToString(CultureInfo.InvariantCulture), .. steps.Skip(at + 1)]
            : steps;
    }
}
