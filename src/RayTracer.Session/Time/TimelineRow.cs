using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>Something that changes with time.</summary>
/// <param name="Keys">The pointer of the list of its keys.</param>
/// <param name="Label">Its name.</param>
/// <param name="Pointer">The pointer of the value that changes, or of the thing that moves.</param>
/// <param name="Thing">The pointer of the thing that this is of.</param>
/// <param name="IsMotion">True for keyframes of a motion, which have no ease.</param>
/// <param name="Items">Its keys, in the order of their times.</param>
public sealed record TimelineRow(string Keys, string Label, string Pointer, string Thing, bool IsMotion, IReadOnlyList<TimelineKey> Items)
{
    private const int ThingSteps = 2;

    /// <summary>All that changes in a scene: tracks in their order, then motions and the animations of models.</summary>
    /// <param name="root">The scene.</param>
    /// <param name="played">The seconds of models' animations, by file and name.</param>
    internal static IReadOnlyList<TimelineRow> Of(JsonNode root, IReadOnlyDictionary<(string File, string Animation), double> played)
    {
        double rate = FrameTimes.Rate(root);
        List<TimelineRow> rows = [];
        IReadOnlyList<JsonNode> tracks = root.Find("animation") is { Kind: JsonKind.Array } list ? list.Items : [];
        foreach ((PropertyAddress? address, int i) in KeyedEdit.Tracks(root).Select((a, i) => (a, i)))
        {
            if (address is not null && tracks[i].Find("keys") is { Kind: JsonKind.Array } keys)
            {
                string thing = address.Steps[0] is "camera" or "render" or "environment" ? JsonPointer.Of(address.Steps[0]) : JsonPointer.Of(address.Steps.Take(ThingSteps));
                rows.Add(new($"/animation/{i}/keys", tracks[i].Find("property")!.Text, JsonPointer.Of(address.Steps), thing, false, Of(keys, rate)));
            }
        }

        AddMotions(rows, root, "", "", rate, (pointer, name) => Playing(SceneValue.At(root, pointer), name, rate, played));
        return rows;
    }

    // From where it begins to where it is over for the first time; none where it is held.
    private static TimelineRow? Playing(SceneValue? model, string name, double rate, IReadOnlyDictionary<(string File, string Animation), double> played)
    {
        if (model?.Child("playback") is not { } written || written.Record() is not PlaybackDescription { Speed: not 0 } playback
            || model.Node!.Find("file") is not { Kind: JsonKind.String } file || !played.TryGetValue((file.Text, playback.Animation), out double seconds))
        {
            return null;
        }

        IEnumerable<double> ends = ((double[])[0, seconds]).Select(time => double.Max(0, (time - playback.Start) / playback.Speed) * rate).Order();
        return new(written.Pointer, $"{name}.playback", model.Pointer, model.Pointer, true, [.. ends.Select(frame => new TimelineKey(frame, "linear", null))]);
    }

    private static void AddMotions(List<TimelineRow> rows, JsonNode node, string pointer, string name, double rate, Func<string, string, TimelineRow?> playback)
    {
        if (FrameTimes.IsModel(node) && playback(pointer, name) is { } playing)
        {
            rows.Add(playing);
        }

        if (node.Find("motion") is { Kind: JsonKind.Array, Items.Count: > 0 } motion)
        {
            rows.Add(new(JsonPointer.Append(pointer, "motion"), $"{name}.motion", pointer, pointer, true, Of(motion, rate)));
        }

        for (int i = 0; i < node.Items.Count; i++)
        {
            AddMotions(rows, node.Items[i], JsonPointer.Append(pointer, i), node.Items[i].Find("name") is { Kind: JsonKind.String } own ? own.Text : $"{name}[{i}]", rate, playback);
        }

        foreach (JsonMember member in node.Members.Where(m => m.Key is not ("animation" or "motion")))
        {
            AddMotions(rows, member.Value, JsonPointer.Append(pointer, member.Key), member.Value.Find("name") is { Kind: JsonKind.String } own ? own.Text : member.Key, rate, playback);
        }
    }

    private static TimelineKey[] Of(JsonNode keys, double rate) => [.. keys.Items.Select(k =>
        new TimelineKey(KeyList.TimeOf(k) * rate, k.Find("ease") is { Kind: JsonKind.String } ease ? ease.Text : "linear", k.Find("value") is { } value ? JsonValues.Of(value) : null))];
}

/// <summary>A key.</summary>
/// <param name="Frame">Its time, in frames.</param>
/// <param name="Ease">How the value changes until the next key.</param>
/// <param name="Value">Its value; null for a keyframe of a motion.</param>
public sealed record TimelineKey(double Frame, string Ease, System.Text.Json.Nodes.JsonNode? Value);

/// <summary>Keys of one row.</summary>
/// <param name="Keys">The pointer of the list.</param>
/// <param name="Numbers">The numbers of the keys in it.</param>
public sealed record KeyChoice(string Keys, IReadOnlyList<int> Numbers);

/// <summary>The animation at a frame.</summary>
/// <param name="Frame">The frame that is shown; null for the scene as it is written.</param>
/// <param name="Shown">The frame that the view shows by now; null for the scene as it is written.</param>
/// <param name="Frames">The number of frames that the keys take; 0 where nothing is animated.</param>
/// <param name="FramesPerSecond">The frames a second.</param>
/// <param name="IsPlaying">True while it plays.</param>
/// <param name="HasVideo">True if frames can be made into videos here.</param>
/// <param name="IsRecording">True while what hands change in the picture becomes keys.</param>
/// <param name="Complaint">Why the last such change is no key; null where it is.</param>
/// <param name="Values">What tracks animate.</param>
public sealed record TimeState(int? Frame, int? Shown, int Frames, double FramesPerSecond, bool IsPlaying, bool HasVideo, bool IsRecording, string? Complaint, IReadOnlyList<AnimatedValue> Values);

/// <summary>An animated value.</summary>
/// <param name="Pointer">Its place.</param>
/// <param name="Value">The value at the frame that is shown.</param>
/// <param name="HasKey">True if there is a key at that frame.</param>
public sealed record AnimatedValue(string Pointer, System.Text.Json.Nodes.JsonNode? Value, bool HasKey);
