
namespace RayTracer.Numerics;

/// <summary>
/// Where a thing is at any time while the shutter is open: a product of maps, each at rest or between keyframes. A single map at
/// rest is a motion too. Never changed once made.
/// </summary>
public sealed class Motion
{
    private readonly MotionTrack[] _tracks;

    private Motion(params MotionTrack[] tracks) => _tracks = tracks;

    /// <summary>Nothing is moved.</summary>
    public static Motion None { get; } = new();

    /// <summary>True where nothing moves.</summary>
    public bool IsStill => !_tracks.Any(t => t.Segments.Length > 0);

    /// <summary>A thing at rest.</summary>
    /// <param name="place">Its place.</param>
    public static Motion Still(in Transform place) => place.IsIdentity ? None : new(new MotionTrack(place, []));

    /// <summary>A thing that moves from place to place; before the first and after the last it rests.</summary>
    /// <param name="keyframes">Times in seconds, growing, and the places then; at least one.</param>
    public static Motion Between(IReadOnlyList<(double Time, Transform Place)> keyframes)
    {
        bool rests = keyframes.All(k => k.Place == keyframes[0].Place);
        MotionSegment[] segments = rests ? [] : [.. keyframes.Zip(keyframes.Skip(1), (a, b) => new MotionSegment(a.Time, a.Place, b.Time, b.Place))];
        return rests ? Still(keyframes[0].Place) : new(new MotionTrack(keyframes[0].Place, segments));
    }

    /// <summary>
    /// The motion of a thing that moves by <paramref name="inner"/> within something that moves by <paramref name="outer"/>.
    /// </summary>
    public static Motion operator *(Motion outer, Motion inner)
    {
        List<MotionTrack> tracks = [.. outer._tracks];
        foreach (MotionTrack track in inner._tracks)
        {
            if (track.Segments.Length == 0 && tracks is [.., { Segments.Length: 0 } last])
            {
                tracks[^1] = new(last.Place * track.Place, []);
            }
            else
            {
                tracks.Add(track);
            }
        }

        return new([.. tracks]);
    }

    /// <summary>The place at a time in seconds.</summary>
    public Transform At(double time)
    {
        Transform place = _tracks.Length == 0 ? Transform.Identity : _tracks[0].At(time);
        for (int i = 1; i < _tracks.Length; i++)
        {
            place *= _tracks[i].At(time);
        }

        return place;
    }

    /// <summary>A box around all places of a box between two times.</summary>
    internal Bounds Bound(Bounds box, double from, double to)
    {
        foreach (MotionTrack track in _tracks.Reverse())
        {
            box = track.Bound(box, from, to);
        }

        return box;
    }

    /// <summary>True where the motion is invertible at sampled times between two, ends included.</summary>
    internal bool IsInvertible(double from, double to) =>
        Enumerable.Range(0, 17).All(i => At(from + ((to - from) * i / 16)).IsInvertible);
}

/// <summary>One map of a <see cref="Motion"/>.</summary>
/// <param name="Place">The place of a thing at rest, or that of the first keyframe.</param>
/// <param name="Segments">The ways between keyframes; none for a thing at rest.</param>
internal sealed record MotionTrack(Transform Place, MotionSegment[] Segments)
{
    public Transform At(double time)
    {
        if (Segments.Length == 0)
        {
            return Place;
        }

        int i = 0;
        while (i < Segments.Length - 1 && time > Segments[i].End)
        {
            i++;
        }

        return Segments[i].At(time);
    }

    public Bounds Bound(Bounds box, double from, double to)
    {
        Bounds all = box.Transformed(At(from)).Union(box.Transformed(At(to)));
        foreach (MotionSegment segment in Segments.Where(s => s.Start < to && s.End > from))
        {
            all = all.Union(segment.Bound(box, from, to));
        }

        return all;
    }
}
