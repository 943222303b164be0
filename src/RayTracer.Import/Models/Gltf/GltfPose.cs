using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>The nodes of a glTF file while the shutter is open.</summary>
internal sealed class GltfPose
{
    // Between them, a motion is a turn at constant speed and a straight way.
    private const int Intervals = 8;
    private readonly double[] _times;
    private readonly Transform[][] _worlds;
    private readonly GltfClip? _clip;
    private readonly double _middle;

    /// <summary>Places the nodes.</summary>
    /// <param name="nodes">The nodes.</param>
    /// <param name="clip">The animation that is played; null for none.</param>
    /// <param name="moment">The time.</param>
    public GltfPose(GltfNodes nodes, GltfClip? clip, ModelMoment moment)
    {
        (_clip, double length) = (clip, moment.Close - moment.Open);
        _middle = moment.TimeAt(moment.Open + (length / 2));
        _times = clip is not null && length > 0 ? [.. Enumerable.Range(0, Intervals + 1).Select(i => moment.Open + (length * i / Intervals))] : [];
        _worlds = [.. _times.Select(t => nodes.Worlds(clip, moment.TimeAt(t)))];
        Middle = nodes.Worlds(clip, _middle);
    }

    /// <summary>Where the nodes are in the middle of that time, by their numbers.</summary>
    public Transform[] Middle { get; }

    /// <summary>The weights that an animation gives the morph targets of a node's mesh; null where it gives none.</summary>
    public IReadOnlyList<float>? Weights(int node) =>
        _clip?.Channels.GetValueOrDefault((node, GltfProperty.Weights))?.At(_middle) is { } weights ? [.. weights.Select(w => (float)w)] : null;

    /// <summary>Puts a shape at a node.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="node">The node.</param>
    /// <param name="within">Where the shape is in the space of the node.</param>
    /// <returns>The shape; null where it is scaled to nothing, or too far away.</returns>
    public ShapeDescription? Put(ShapeDescription shape, int node, in Transform within)
    {
        Transform place = Middle[node] * within;
        if (Keyframes(node) is { } keyframes)
        {
            return shape with { Transform = Steps(within), Motion = keyframes };
        }

        return IsGood(place) ? shape with { Transform = Steps(place) } : null;
    }

    /// <summary>The keyframes of a node; null where it stands still, or cannot be followed: where it is turned inside out, or vanishes.</summary>
    public KeyframeDescription[]? Keyframes(int node)
    {
        Transform[] places = [.. _worlds.Select(w => w[node])];
        if (places.All(p => p == places[0]) || !Array.TrueForAll(places, IsGood) || places.Any(p => p.Determinant < 0 != places[0].Determinant < 0))
        {
            return null;
        }

        KeyframeDescription[] keyframes = [.. places.Zip(_times, (p, t) => new KeyframeDescription { Time = (float)t, Transform = Steps(p) })];
        return keyframes.Zip(keyframes.Skip(1)).All(k => k.First.Time < k.Second.Time) ? keyframes : null;
    }

    /// <summary>Returns whether a map can be computed with.</summary>
    public static bool IsGood(Transform map) => map.IsInvertible && Rows(map).All(float.IsFinite);

    /// <summary>A map as the transform of a shape.</summary>
    public static TransformDescription[] Steps(in Transform map) => map.IsIdentity ? [] : [new() { Matrix = Rows(map) }];

    private static float[] Rows(in Transform map) =>
        [.. ((TransformRow[])[map.X, map.Y, map.Z]).SelectMany(r => (float[])[(float)r.A, (float)r.B, (float)r.C, (float)r.D])];
}
