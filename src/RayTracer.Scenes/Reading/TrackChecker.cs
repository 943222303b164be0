using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Finds out whether the tracks of an animation lead to numbers, and whether each of their keys could stand there itself.</summary>
/// <param name="root">The scene.</param>
/// <param name="bag">Takes what is wrong.</param>
/// <param name="map">The places of the tracks in the file.</param>
/// <param name="read">Reads the value of a parameter.</param>
internal sealed class TrackChecker(JsonNode root, DiagnosticBag bag, SourceMap map, Func<RecordParameter, JsonNode, object?> read)
{
    private readonly NumberReader _numbers = new(bag);

    /// <summary>Reports what is wrong with tracks that could be read.</summary>
    public void Check(IEnumerable<TrackDescription> tracks)
    {
        foreach (TrackDescription track in tracks.Where(t => !map.IsIncomplete(t)))
        {
            PropertyPlace place = PropertyPlace.Find(root, PropertyPath.Read(track.Property));
            if ((place.Complaint ?? AnimationTrack.Complaint(place)) is { } complaint)
            {
                bag.Error(map.Find(track, nameof(TrackDescription.Property))!, complaint, place.Complaint is null ? null : DiagnosticRule.UnknownWord);
            }
            else
            {
                Check(track, place);
            }
        }
    }

    private void Check(TrackDescription track, PropertyPlace place)
    {
        if (track.Keys.Count == 0)
        {
            bag.Error(map.Find(track, nameof(TrackDescription.Keys))!, "a track needs at least one key");
        }

        float before = float.NegativeInfinity;
        foreach (KeyDescription key in track.Keys.Where(k => !map.IsIncomplete(k)))
        {
            if (key.Time <= before)
            {
                bag.Error(map.Find(key, nameof(KeyDescription.Time))!, $"keys must be in the order of their times, but {key.Time} follows {before}");
            }

            before = key.Time;
            Check(key, place, track.Keys[0].Value.Count);
        }
    }

    private void Check(KeyDescription key, PropertyPlace place, int count)
    {
        JsonNode value = map.Find(key, nameof(KeyDescription.Value))!;
        if (key.Value.Count != count)
        {
            bag.Error(value, $"the keys of a track must have the same number of values, but this one has {key.Value.Count} and the first has {count}");
            return;
        }

        JsonNode node = AnimationTrack.Node(place, [.. key.Value.Select(v => (double)v)], value);
        _ = place.IsElement ? _numbers.Number(place.Parameter!, node) : read(place.Parameter!, node);
    }
}
