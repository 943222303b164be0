using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>The animation of a document: the frame that the view shows, and the keys, which are edits of the scene's text.</summary>
/// <param name="document">The document.</param>
/// <param name="view">Shows it.</param>
public sealed class Timeline(SceneDocument document, PictureView view) : IDisposable
{
    private readonly Lock _lock = new();
    private Playback? _playback;
    private (int Revision, int Built, IReadOnlyList<TimelineRow> Rows, double Rate) _known = (-1, -1, [], 1);

    /// <summary>Raised when it begins or ends to play.</summary>
    public event Action? Changed;

    /// <summary>All that changes with time.</summary>
    public IReadOnlyList<TimelineRow> Rows => Known().Rows;

    /// <summary>The animation as it is now.</summary>
    public TimeState State
    {
        get
        {
            (_, _, IReadOnlyList<TimelineRow> rows, double rate) = Known();
            int? frame = document.Frame;
            return new(frame, view.Shown?.Good.Frame, FramesOf(rows), rate, _lock.Read(() => _playback) is { IsOver: false }, VideoFile.Program is not null, document.IsRecording, document.RecordingComplaint, [.. rows.Where(r => !r.IsMotion).Select(r => ValueOf(r, frame, rate))]);
        }
    }

    /// <summary>Shows a frame, and ends playing.</summary>
    /// <param name="frame">The frame; null for the scene as it is written.</param>
    /// <exception cref="SessionException">There is no such frame.</exception>
    public void Show(int? frame)
    {
        Stop();
        document.ShowFrame(frame);
    }

    /// <summary>Plays the frames over and over, in their own time: as many of them as the view can show.</summary>
    /// <exception cref="SessionException">Nothing is animated.</exception>
    public void Play()
    {
        (int frames, double rate) = (FramesOf(Known().Rows), Known().Rate);
        if (frames < 1)
        {
            throw new SessionException("Nothing is animated: give a value two keys at different frames first.");
        }

        Stop();
        lock (_lock)
        {
            _playback = new(document, view, frames, rate, () => Changed?.Invoke());
        }

        Changed?.Invoke();
    }

    /// <summary>Ends playing, where it is.</summary>
    public void Stop()
    {
        Playback? playing;
        lock (_lock)
        {
            (playing, _playback) = (_playback, null);
        }

        playing?.Dispose();
        Changed?.Invoke();
    }

    /// <summary>Records from now on what hands change in the picture, as keys at the frame that is shown; or no longer.</summary>
    public void Record(bool isOn)
    {
        if (isOn && document.Frame is null)
        {
            Show(0);
        }

        document.IsRecording = isOn;
        Changed?.Invoke();
    }

    /// <summary>Writes a key of a value at the frame that is shown, or removes the one that is there.</summary>
    /// <param name="pointer">The value.</param>
    /// <returns>The text's revision then, as with all edits.</returns>
    /// <exception cref="SessionException">It cannot be animated; so with all edits.</exception>
    public int ToggleKey(string pointer)
    {
        int frame = document.Frame ?? 0;
        if (document.Frame is null)
        {
            document.ShowFrame(frame);
        }

        return document.Change("key", null, text => Toggled(text, pointer, frame));
    }

    /// <summary>Moves keys, or puts copies of them at other frames.</summary>
    /// <param name="keys">The keys.</param>
    /// <param name="frames">By how many frames.</param>
    /// <param name="copies">True if they stay where they are, too.</param>
    /// <param name="gesture">Of which gesture it is a part.</param>
    public int MoveKeys(IReadOnlyList<KeyChoice> keys, double frames, bool copies, string? gesture = null) => double.IsFinite(frames) && Math.Abs(frames) <= FrameTimes.Last
        ? document.Change(copies ? "copy keys" : "move keys", gesture, text => keys.Aggregate(text, (t, k) => KeyList.Move(t, k.Keys, k.Numbers.ToHashSet(), frames, copies)))
        : throw new SessionException("keys are moved by a number of frames");

    /// <summary>Removes keys.</summary>
    public int RemoveKeys(IReadOnlyList<KeyChoice> keys) => document.Change("delete keys", null, text =>
        keys.OrderByDescending(k => k.Keys.Length).ThenByDescending(k => k.Keys, StringComparer.Ordinal).Aggregate(text, (t, k) => KeyList.Remove(t, k.Keys, k.Numbers.ToHashSet())));

    /// <summary>Lets values change in another way from some keys on.</summary>
    public int EaseKeys(IReadOnlyList<KeyChoice> keys, Ease ease) => document.Change("ease", null, text =>
        keys.Where(k => k.Keys.EndsWith("/keys", StringComparison.Ordinal)).Aggregate(text, (t, k) => KeyList.Ease(t, k.Keys, k.Numbers.ToHashSet(), ease.ToString().ToLowerInvariant())));

    /// <summary>All that changes with time, as soon as models are read whose animations it depends on.</summary>
    /// <param name="cancellation">Ends the wait.</param>
    public async Task<IReadOnlyList<TimelineRow>> WholeRows(CancellationToken cancellation = default)
    {
        if (document.Read.Root is { } root && FrameTimes.HasModel(root))
        {
            await document.WhenBuilt(cancellation).ConfigureAwait(false);
        }

        return Rows;
    }

    /// <summary>The ways of the camera and of a thing in the picture that is shown.</summary>
    /// <param name="thing">The thing; null for none.</param>
    public MotionPaths Paths(string? thing) => Known() is var (_, _, rows, rate) && view.Shown is { Camera.Projection.IsStraight: true } shown
        ? MotionPaths.Of(document.Read, CameraFrame.Of(shown), thing, FramesOf(rows), rate) : new([], [], 1);

    /// <inheritdoc/>
    public void Dispose() => Stop();

    private static JsonText Toggled(JsonText text, string pointer, int frame)
    {
        double rate = FrameTimes.Rate(text.Root);
        int track = KeyedEdit.Tracks(text.Root).ToList().FindIndex(a => a is not null && JsonPointer.Of(a.Steps) == pointer);
        string keys = $"/animation/{track}/keys";
        if (track >= 0)
        {
            int there = text.At(keys).Items.ToList().FindIndex(k => FrameTimes.IsAt(KeyList.TimeOf(k), frame, rate));
            return there >= 0 ? KeyList.Remove(text, keys, new HashSet<int> { there }) : KeyList.Set(text, keys, frame, KeyedEdit.ValueAt(At(text, frame), KeyedEdit.Tracks(text.Root).ElementAt(track)!));
        }

        return Begin(text, pointer, frame, null);
    }

    /// <summary>Begins to animate a value: with a key at a frame.</summary>
    /// <param name="text">The text.</param>
    /// <param name="pointer">The value, which has no keys.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="value">The value there; null for what it is.</param>
    /// <exception cref="SessionException">It cannot be animated.</exception>
    internal static JsonText Begin(JsonText text, string pointer, int frame, System.Text.Json.Nodes.JsonNode? value)
    {
        string path = new PropertyAddress(JsonPointer.Parse(pointer), [.. JsonPointer.Parse(pointer).Select(_ => true)]).Path(text.Root);
        PropertyPlace place = PropertyPlace.Find(text.Root, PropertyPath.Read(path));
        if ((place.Complaint ?? AnimationTrack.Complaint(place)) is { } complaint)
        {
            throw new SessionException(complaint);
        }

        value = value is not null ? value.DeepClone() : place.Node is { } written ? JsonValues.Of(written) : JsonValues.Of(place.Parameter!, place.Parameter!.Default);
        System.Text.Json.Nodes.JsonObject key = new() { ["time"] = FrameTimes.TimeOf(frame, FrameTimes.Rate(text.Root)), ["value"] = value };
        string track = JsonLayout.OneLine(new System.Text.Json.Nodes.JsonObject { ["property"] = path, ["keys"] = new System.Text.Json.Nodes.JsonArray(key) });
        string indent = JsonTrivia.IndentUnit(text);

        // Each track has a line, as in scenes that people write.
        return text.Root.Find("animation") is null or { Kind: JsonKind.Array, Items.Count: 0 }
            ? text.SetText("/animation", $"[\n{indent}{indent}{track}\n{indent}]") : text.SetText("/animation/-", track);
    }

    private static JsonNode At(JsonText text, int frame) => FrameTimes.Read(SceneReader.ReadText(text.Text, ""), frame).Root!;

    // The last key is the end, not a frame: the next round begins there.
    private static int FramesOf(IReadOnlyList<TimelineRow> rows) =>
        rows.Count == 0 ? 0 : Math.Max(1, (int)Math.Ceiling(Math.Min(rows.Max(r => r.Items.Count == 0 ? 0 : r.Items.Max(k => k.Frame)), FrameTimes.Last) - 0.01));

    private AnimatedValue ValueOf(TimelineRow row, int? frame, double rate)
    {
        System.Text.Json.Nodes.JsonNode? value = frame is { } number && row.Items.All(k => k.Value is not null)
            && document.Content.LastGood is { Read.Root: { } root } ? KeyedEdit.ValueAt(root, row.Pointer) : null;
        return new(row.Pointer, value, frame is { } shown && row.Items.Any(k => FrameTimes.IsAt(k.Frame / rate, shown, rate)));
    }

    private (int Revision, int Built, IReadOnlyList<TimelineRow> Rows, double Rate) Known()
    {
        try
        {
            (int revision, JsonNode root) = document.Readable;
            DocumentContent built = document.Content;
            lock (_lock)
            {
                return _known = (_known.Revision, _known.Built) == (revision, built.Revision) ? _known
                    : (revision, built.Revision, TimelineRow.Of(root, built.Load.Played), FrameTimes.Rate(root));
            }
        }
        catch (SessionException)
        {
            // There is no text to be read yet.
            return (-1, -1, [], new RenderDescription().FramesPerSecond);
        }
    }
}
