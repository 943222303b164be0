using System.Text.Json.Nodes;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>
/// Edits by a hand while keys are recorded: they are made on the scene as it is at a frame, and each value that they change gets a key there. What was written
/// stays as it is.
/// </summary>
internal static class RecordedEdit
{
    /// <summary>Makes an edit.</summary>
    /// <param name="text">The text.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="change">The edit.</param>
    /// <returns>The text then, and why something was changed as it is written instead; null where all changes are keys.</returns>
    public static (JsonText Text, string? Complaint) Apply(JsonText text, int frame, Func<JsonText, JsonText> change)
    {
        JsonText before = KeyedEdit.At(text, frame);
        JsonText after = change(before);
        string? complaint = null;
        foreach (Change changed in Changes(before, after, before.Root, after.Root, ""))
        {
            string[] steps = JsonPointer.Parse(changed.Pointer);
            try
            {
                text = steps[^1] == "motion" ? text.SetText(changed.Pointer, after.Text[changed.After!.Start..changed.After.End])
                    : steps is [.., "transform", var number] && JsonPointer.Index(number) >= 0 && changed.Before is null ? WithStep(text, changed, frame)
                    : changed.Before is null && JsonPointer.Find(text.Root, JsonPointer.Parent(changed.Pointer)!) is { Kind: JsonKind.Array } ? throw new SessionException("what is added to a list has no keys")
                    : changed.After is null ? text.Remove(changed.Pointer)
                    : Keyed(text, changed.Pointer, frame, changed.Before, JsonValues.Of(changed.After)!);
            }
            catch (SessionException e)
            {
                complaint = $"{changed.Pointer[1..].Replace('/', '.')} was changed as it is written: {e.Message}";
                text = text.Set(changed.Pointer, JsonValues.Of(changed.After!));
            }
        }

        return (text, complaint);
    }

    // A step of a transform is put in as one that does nothing, whose values get keys.
    private static JsonText WithStep(JsonText text, Change added, int frame)
    {
        JsonObject step = JsonValues.Of(added.After!)!.AsObject();
        JsonObject neutral = [];
        foreach ((string key, Json? value) in step)
        {
            neutral[key] = key switch
            {
                "translate" => new JsonArray(0, 0, 0),
                "scale" => new JsonArray(1, 1, 1),
                "rotate" => 0,
                "axis" => value!.DeepClone(),
                _ => throw new SessionException("a matrix has no keys"),
            };
        }

        text = text.Set(added.Pointer, neutral);
        return step.Where(v => v.Key != "axis").Aggregate(text, (now, v) => Keyed(now, JsonPointer.Append(added.Pointer, v.Key), frame, now.At(JsonPointer.Append(added.Pointer, v.Key)), v.Value!));
    }

    private static JsonText Keyed(JsonText text, string pointer, int frame, JsonNode? before, Json value)
    {
        string?[] tracks = [.. KeyedEdit.Tracks(text.Root).Select(a => a is null ? null : JsonPointer.Of(a.Steps))];
        int own = Array.IndexOf(tracks, pointer);
        if (own >= 0)
        {
            return KeyList.Set(text, $"/animation/{own}/keys", frame, value);
        }

        if (value is not JsonArray elements || !tracks.Any(t => Picking.IsWithin(t, pointer)))
        {
            return Timeline.Begin(text, pointer, frame, value);
        }

        // Where elements have keys of their own, so have the others.
        for (int i = 0; i < elements.Count; i++)
        {
            text = before?.Items.ElementAtOrDefault(i)?.Number is { } was && was == (float)elements[i]!.GetValue<double>() ? text : Keyed(text, JsonPointer.Append(pointer, i), frame, null, elements[i]!.DeepClone());
        }

        return text;
    }

    private static IEnumerable<Change> Changes(JsonText before, JsonText after, JsonNode a, JsonNode b, string pointer)
    {
        if (before.Text.AsSpan(a.Start, a.End - a.Start).SequenceEqual(after.Text.AsSpan(b.Start, b.End - b.Start)))
        {
            return [];
        }

        if (a.Kind == JsonKind.Object && b.Kind == JsonKind.Object)
        {
            return a.Members.Concat(b.Members).Select(m => m.Key).Distinct(StringComparer.Ordinal)
                .SelectMany(key => Parts(before, after, a.Find(key), b.Find(key), JsonPointer.Append(pointer, key)));
        }

        bool isList = a.Kind == JsonKind.Array && b.Kind == JsonKind.Array && !(a.Items.Concat(b.Items).All(i => i.Number is not null));
        return isList ? Enumerable.Range(0, Math.Max(a.Items.Count, b.Items.Count))
                .SelectMany(i => Parts(before, after, a.Items.ElementAtOrDefault(i), b.Items.ElementAtOrDefault(i), JsonPointer.Append(pointer, i)))
            : [new(pointer, a, b)];
    }

    // A list that is new may hold one step.
    private static IEnumerable<Change> Parts(JsonText before, JsonText after, JsonNode? a, JsonNode? b, string pointer) => (a, b) switch
    {
        // Its keyframes are keys of its own.
        ({ } was, { } now) when JsonPointer.Last(pointer) == "motion" => before.Text[was.Start..was.End] == after.Text[now.Start..now.End] ? [] : [new(pointer, was, now)],
        ({ } was, { } now) => Changes(before, after, was, now, pointer),
        (null, { Kind: JsonKind.Array } list) when list.Items.Any(i => i.Kind == JsonKind.Object) => list.Items.Select((item, i) => new Change(JsonPointer.Append(pointer, i), null, item)),
        _ => [new(pointer, a, b)],
    };

    private readonly record struct Change(string Pointer, JsonNode? Before, JsonNode? After);
}
