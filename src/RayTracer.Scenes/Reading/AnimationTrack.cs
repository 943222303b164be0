using System.Globalization;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Puts the values that tracks of an animation have at a time into a scene's text.</summary>
internal static class AnimationTrack
{
    /// <summary>The reason why a property cannot be animated; null where it can.</summary>
    public static string? Complaint(PropertyPlace place) =>
        place.Parameter is { } parameter && ParameterForm.Of(parameter).IsNumeric(place.Node) ? null
        : place.Parameter is { IsRecord: true } || place.Node is { Kind: JsonKind.Object } ? Whole(place)
        : $"{Quotation.Of(place.Path)} cannot be animated: only numbers, vectors and colours can";

    /// <summary>A scene as it is at a time.</summary>
    /// <param name="root">The scene, whose tracks were found to be without fault.</param>
    /// <param name="tracks">Its tracks.</param>
    /// <param name="map">The places of the tracks in the file.</param>
    /// <param name="time">The time in seconds.</param>
    public static JsonNode Apply(JsonNode root, IEnumerable<TrackDescription> tracks, SourceMap map, double time)
    {
        foreach (TrackDescription track in tracks)
        {
            PropertyPlace place = PropertyPlace.Find(root, PropertyPath.Read(track.Property));
            (double[] numbers, KeyDescription key) = At(track.Keys, time);
            root = place.With(Node(place, numbers, map.Find(key, nameof(KeyDescription.Value))!), map.Find(track, nameof(TrackDescription.Property))!.Start + 1);
        }

        return root;
    }

    /// <summary>Numbers as they would be written for a property. What is wrong with them is said of a place in the file.</summary>
    public static JsonNode Node(PropertyPlace property, double[] numbers, JsonNode place)
    {
        RecordParameter parameter = property.Parameter!;
        JsonNode[] items = [.. numbers.Select(n =>
            new JsonNode(JsonKind.Number, place.Start, place.End, (parameter.IsInteger ? double.Round(n) : n).ToString("R", CultureInfo.InvariantCulture)))];
        bool isSingle = property.IsElement || parameter.ValueType.IsPrimitive || (parameter is { Family: not null, IsNumber: true } && numbers.Length == 1);
        return isSingle && items.Length == 1 ? items[0] : new(JsonKind.Array, place.Start, place.End) { Items = items };
    }

    private static string Whole(PropertyPlace place) => $"{Quotation.Of(place.Path)} is not a single value: name one of its numbers, vectors or colours";

    // The numbers at a time, and the key at or before it.
    private static (double[] Numbers, KeyDescription Key) At(IReadOnlyList<KeyDescription> keys, double time)
    {
        // A key is reached at the frame whose time it has, in the numbers that keys are kept in.
        int next = 0;
        while (next < keys.Count && keys[next].Time <= (float)time)
        {
            next++;
        }

        KeyDescription from = keys[Math.Max(0, next - 1)];
        KeyDescription to = keys[Math.Min(next, keys.Count - 1)];
        double t = from == to || from.Time == (float)time ? 0 : Eased(from.Ease, (time - from.Time) / ((double)to.Time - from.Time));
        return ([.. from.Value.Zip(to.Value, (a, b) => a + (t * ((double)b - a)))], from);
    }

    private static double Eased(Ease ease, double t) => ease switch
    {
        Ease.Linear => t,
        Ease.Smooth => t * t * (3 - (2 * t)),
        _ => 0,
    };
}
