using System.Text.Json.Nodes;
using RayTracer.Scenes;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>
/// Edits of the keys of a track, or of a motion, in a scene's text: they stay in the order of their times, and of two at one time the one that came last stays.
/// </summary>
internal static class KeyList
{
    private const float SameTime = 1e-6f;

    /// <summary>Writes a value at a frame: into the key that is there, or a new one.</summary>
    /// <param name="text">The text.</param>
    /// <param name="keys">The pointer of the list.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="value">The value.</param>
    public static JsonText Set(JsonText text, string keys, int frame, System.Text.Json.Nodes.JsonNode? value)
    {
        IReadOnlyList<JsonNode> list = text.At(keys).Items;
        double rate = FrameTimes.Rate(text.Root);
        int at = list.ToList().FindIndex(k => FrameTimes.IsAt(TimeOf(k), frame, rate));
        if (at >= 0)
        {
            return text.SetText(JsonPointer.Append(JsonPointer.Append(keys, at), "value"), JsonLayout.OneLine(value));
        }

        float time = FrameTimes.TimeOf(frame, rate);
        JsonNode? before = list.LastOrDefault(k => TimeOf(k) < time);
        JsonObject key = new() { ["time"] = time, ["value"] = value?.DeepClone() };
        if (before?.Find("ease") is { Kind: JsonKind.String } ease && ease.Text != "linear")
        {
            key["ease"] = ease.Text;
        }

        return Write(text, keys, [.. list.Select(k => (TimeOf(k), Raw(text, k))), (time, JsonLayout.OneLine(key))]);
    }

    /// <summary>Makes sure that a thing that moves has a keyframe at a frame: where it is there. What has no motion stays without.</summary>
    /// <param name="text">The text.</param>
    /// <param name="thing">The thing.</param>
    /// <param name="frame">The frame.</param>
    public static JsonText WithKeyframe(JsonText text, string thing, int frame)
    {
        double rate = FrameTimes.Rate(text.Root);
        if (SceneValue.At(text.Root, thing) is not { Node: not null } value || value.Child("motion") is not { Node.Items.Count: > 0 } motion
            || motion.Node.Items.Any(k => FrameTimes.IsAt(TimeOf(k), frame, rate)))
        {
            return text;
        }

        float time = FrameTimes.TimeOf(frame, rate);
        JsonObject key = new() { ["time"] = time, ["transform"] = TransformEdit.Step(Movement.Of(ShapePlacement.MotionAt(value, time))) };
        return Write(text, motion.Pointer, [.. motion.Node.Items.Select(k => (TimeOf(k), Raw(text, k))), (time, JsonLayout.OneLine(key))]);
    }

    /// <summary>Moves keys in time, or puts copies of them at other times.</summary>
    /// <param name="text">The text.</param>
    /// <param name="keys">The pointer of the list.</param>
    /// <param name="moved">The numbers of the keys.</param>
    /// <param name="frames">By how many frames.</param>
    /// <param name="copies">True if they stay where they are, too.</param>
    /// <exception cref="SessionException">There are no such keys.</exception>
    public static JsonText Move(JsonText text, string keys, IReadOnlySet<int> moved, double frames, bool copies)
    {
        double rate = FrameTimes.Rate(text.Root);
        IReadOnlyList<JsonNode> list = Checked(text, keys, moved);
        List<(float, string)> all = [.. list.Where((_, i) => copies || !moved.Contains(i)).Select(k => (TimeOf(k), Raw(text, k)))];
        foreach (JsonNode key in list.Where((_, i) => moved.Contains(i)))
        {
            double place = Math.Max(0, (TimeOf(key) * rate) + frames);

            // Keys that are moved from frames come to frames, in the numbers that frames have.
            place = Math.Abs(place - Math.Round(place)) < 0.01 ? Math.Round(place) : place;
            float time = FrameTimes.TimeOf(place, rate);
            JsonNode written = key.Find("time")!;
            string raw = Raw(text, key);
            all.Add((time, raw[..(written.Start - key.Start)] + JsonLayout.OneLine(JsonValue.Create(time)) + raw[(written.End - key.Start)..]));
        }

        return Write(text, keys, all);
    }

    /// <summary>Removes keys; a list that has none any more is removed, and the track that it is of.</summary>
    /// <exception cref="SessionException">There are no such keys.</exception>
    public static JsonText Remove(JsonText text, string keys, IReadOnlySet<int> gone)
    {
        if (Checked(text, keys, gone).Count == gone.Count)
        {
            string list = JsonPointer.Last(keys) == "keys" ? JsonPointer.Parent(keys)! : keys;
            return JsonPointer.Parent(list) == "/animation" && text.At("/animation").Items.Count == 1 ? text.Remove("/animation") : text.Remove(list);
        }

        return gone.OrderDescending().Aggregate(text, (t, i) => t.Remove(JsonPointer.Append(keys, i)));
    }

    /// <summary>Lets values change in another way from some keys to the next.</summary>
    /// <exception cref="SessionException">There are no such keys.</exception>
    public static JsonText Ease(JsonText text, string keys, IReadOnlySet<int> eased, string ease)
    {
        Checked(text, keys, eased);
        return eased.Aggregate(text, (t, i) =>
        {
            string pointer = JsonPointer.Append(JsonPointer.Append(keys, i), "ease");
            return ease != "linear" ? t.Set(pointer, JsonValue.Create(ease)) : JsonPointer.Find(t.Root, pointer) is null ? t : t.Remove(pointer);
        });
    }

    /// <summary>The time of a key, in seconds.</summary>
    public static float TimeOf(JsonNode key) =>
        key.Find("time") is { Kind: JsonKind.Number } time && float.TryParse(time.Text, System.Globalization.CultureInfo.InvariantCulture, out float seconds) ? seconds : 0;

    private static string Raw(JsonText text, JsonNode node) => text.Text[node.Start..node.End];

    private static IReadOnlyList<JsonNode> Checked(JsonText text, string keys, IReadOnlySet<int> numbers)
    {
        string[] steps = JsonPointer.Parse(keys);
        bool isList = (steps is ["animation", _, "keys"] || steps.LastOrDefault() == "motion") && text.At(keys).Kind == JsonKind.Array;
        IReadOnlyList<JsonNode> list = isList ? text.At(keys).Items : throw new SessionException($"there are no keys at {JsonLayout.Quote(keys)}");
        return numbers.Count > 0 && numbers.All(i => i >= 0 && i < list.Count && list[i].Find("time") is not null)
            ? list : throw new SessionException("there are no such keys");
    }

    // In the order of their times, each in the place of one that was there, so that lines and comments between them stay.
    private static JsonText Write(JsonText text, string keys, IReadOnlyList<(float Time, string Raw)> all)
    {
        List<string> raws = [];
        float last = float.NegativeInfinity;
        foreach ((float time, string raw) in all.OrderBy(k => k.Time))
        {
            if (time - last < SameTime)
            {
                raws.RemoveAt(raws.Count - 1);
            }

            raws.Add(raw);
            last = time;
        }

        int count = text.At(keys).Items.Count;
        for (; count < raws.Count; count++)
        {
            text = text.Duplicate(JsonPointer.Append(keys, count - 1)).Text;
        }

        for (; count > raws.Count; count--)
        {
            text = text.Remove(JsonPointer.Append(keys, count - 1));
        }

        return text.With(text.At(keys).Items.Select((k, i) => new TextEdit(k.Start, k.End, raws[i])).Where(e => text.Text[e.From..e.To] != e.Insert));
    }
}
