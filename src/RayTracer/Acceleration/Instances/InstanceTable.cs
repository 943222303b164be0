using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>
/// The spaces that stand in the world, each at its place: 24 floats and two numbers an instance, and a share of the tree over them. The first
/// instance has number 1; 0 is the world itself.
/// </summary>
internal sealed unsafe class InstanceTable
{
    /// <summary>Floats an instance: the map into the world, and the one back, each row by row.</summary>
    public const int Stride = 24;

    /// <summary>The place in an entry at which the map back begins.</summary>
    public const int Back = 12;

    // How far boxes are made wider, as a fraction of the largest coordinate: rays and boxes are rounded in the world, hits in the space.
    private const float BoxSlack = 1f / (1 << 20);
    private readonly PinnedBuffer<float> _maps;
    private readonly ushort[]? _smallSpaces;
    private readonly int[]? _spaces;
    private readonly Motion?[] _motions;
    private readonly ShapeDescription?[] _sources;
    private readonly LightGroupLabel?[] _labels;
    private readonly Space[] _all;
    private readonly InstanceTree _tree;

    /// <summary>Makes the table.</summary>
    /// <param name="instances">The instances; at least one.</param>
    /// <param name="spaces">The spaces that they show.</param>
    /// <param name="shutter">When the shutter opens and closes, in seconds.</param>
    public InstanceTable(IReadOnlyList<PlacedSpace> instances, Space[] spaces, (double Open, double Close) shutter)
    {
        _all = spaces;
        Dictionary<SpaceContents, int> index = new(ReferenceEqualityComparer.Instance);
        for (int i = 0; i < spaces.Length; i++)
        {
            index.Add(spaces[i].Contents, i);
        }

        Count = instances.Count;
        _maps = new((long)Stride * Count);
        int[] shown = [.. instances.Select(i => index[i.Contents])];
        (_smallSpaces, _spaces) = spaces.Length <= ushort.MaxValue ? ([.. shown.Select(s => (ushort)s)], null) : (default(ushort[]), shown);
        _motions = instances.Any(i => !i.Motion.IsStill) ? [.. instances.Select(i => i.Motion.IsStill ? null : i.Motion)] : [];
        _sources = instances[0].Source is null ? [] : [.. instances.Select(i => i.Source)];
        _labels = instances.Any(i => i.Label is not null) ? [.. instances.Select(i => i.Label)] : [];
        float[] boxes = new float[6L * Count];
        for (int i = 0; i < Count; i++)
        {
            WriteMaps(instances[i].Motion.At(shutter.Open), _maps.Pointer + ((long)Stride * i));
            Bounds box = instances[i].Motion.Bound(spaces[shown[i]].Bounds, shutter.Open, shutter.Close);
            Write(box, boxes.AsSpan(6 * i));
        }

        _tree = new(this, boxes);
    }

    /// <summary>Number of instances.</summary>
    public int Count { get; }

    /// <summary>True where any instance moves while the shutter is open.</summary>
    public bool Moves => _motions.Length > 0;

    /// <summary>Memory of the tree over the instances.</summary>
    public long TreeBytes => _tree.MemoryBytes;

    /// <summary>Memory of the instances, without that of what they show.</summary>
    public long MemoryBytes => ((long)Stride * sizeof(float) * Count) + (_smallSpaces?.Length * 2L ?? _spaces!.Length * 4L) + (8L * _motions.Length) + _tree.MemoryBytes;

    /// <summary>The size and shape of the tree over the instances.</summary>
    public BvhStatistics TreeStatistics => _tree.Statistics;

    /// <summary>Builds a tree again as it is where the shutter opens, to measure how long that takes; the table keeps its own.</summary>
    public void BuildTree()
    {
        float[] boxes = new float[6L * Count];
        for (int i = 0; i < Count; i++)
        {
            Write(SpaceOf(i + 1).Bounds.Transformed(PlaceOf(i + 1)), boxes.AsSpan(6 * i));
        }

        _ = new InstanceTree(this, boxes);
    }

    /// <summary>What distinguishes the light of an instance from that of others, where its contents do not.</summary>
    public LightGroupLabel? LabelOf(int instance) => _labels.Length > 0 ? _labels[instance - 1] : null;

    /// <summary>Returns the space that an instance shows.</summary>
    /// <param name="instance">Its number, from 1.</param>
    public Space SpaceOf(int instance) => _all[_smallSpaces is null ? _spaces![instance - 1] : _smallSpaces[instance - 1]];

    /// <summary>Returns the description that an instance was made from; null where that is not kept.</summary>
    /// <param name="instance">Its number, from 1.</param>
    public ShapeDescription? SourceOf(int instance) => _sources.Length > 0 ? _sources[instance - 1] : null;

    /// <summary>Returns the place of an instance when the shutter opens.</summary>
    /// <param name="instance">Its number, from 1.</param>
    public Transform PlaceOf(int instance) => Transform.Read(_maps.Pointer + ((long)Stride * (instance - 1)));

    /// <summary>A box of the world around a box in an instance's space, while the shutter is open.</summary>
    /// <param name="instance">Its number, from 1.</param>
    /// <param name="box">The box in the space.</param>
    /// <param name="shutter">When the shutter opens and closes, in seconds.</param>
    public Bounds BoundsOf(int instance, in Bounds box, (double Open, double Close) shutter) =>
        Moves && _motions[instance - 1] is { } motion ? motion.Bound(box, shutter.Open, shutter.Close) : box.Transformed(PlaceOf(instance));

    /// <summary>The maps of an instance at a time.</summary>
    /// <param name="instance">Its number, from 1.</param>
    /// <param name="time">The time in seconds.</param>
    /// <param name="scratch">Room for an entry, which is used where the instance moves.</param>
    /// <returns>An entry: the map into the world and the one back.</returns>
    public float* MapsAt(int instance, float time, float* scratch)
    {
        if (_motions.Length == 0 || _motions[instance - 1] is not { } motion)
        {
            return _maps.Pointer + ((long)Stride * (instance - 1));
        }

        WriteMaps(motion.At(time), scratch);
        return scratch;
    }

    /// <summary>Shortens a ray to the nearest hit of all instances. Of equal distances the lower instance wins.</summary>
    /// <param name="ray">The ray, in the world.</param>
    /// <param name="time">Its time in seconds.</param>
    /// <param name="hit">The nearest hit so far.</param>
    public void ClosestHit(in SpaceRay ray, float time, ref InstanceHit hit) => _tree.ClosestHit(ray, time, ref hit);

    /// <summary>Returns whether any instance stands in the way of a ray.</summary>
    /// <param name="ray">The ray, in the world.</param>
    /// <param name="time">Its time in seconds.</param>
    /// <param name="distance">The distance over which the ray must be free.</param>
    /// <param name="skipped">An instance of which one primitive does not count; 0 for none.</param>
    /// <param name="skip">That primitive.</param>
    public bool AnyHit(in SpaceRay ray, float time, float distance, int skipped, int skip) => _tree.AnyHit(ray, time, distance, skipped, skip);

    /// <summary>Returns the cost of finding a ray's nearest hit of all instances: nodes visited plus triangles tested.</summary>
    /// <param name="ray">The ray, in the world.</param>
    /// <param name="time">Its time in seconds.</param>
    /// <param name="hit">The nearest hit so far.</param>
    public long Cost(in SpaceRay ray, float time, in InstanceHit hit) => _tree.Cost(ray, time, hit);

    /// <summary>Returns the cost of finding the nearest hit of one instance.</summary>
    internal long CostOf(int instance, in SpaceRay ray, float time, float distance)
    {
        float* scratch = stackalloc float[Stride];
        return SpaceOf(instance).Cost(Inside(instance, ray, MapsAt(instance, time, scratch) + Back), distance);
    }

    /// <summary>The nearest hit of one instance.</summary>
    internal void Meet(int instance, in SpaceRay ray, float time, ref InstanceHit hit)
    {
        float distance = hit.Distance;
        float* scratch = stackalloc float[Stride];
        int primitive = SpaceOf(instance).ClosestHit(Inside(instance, ray, MapsAt(instance, time, scratch) + Back), ref distance);
        if (primitive >= 0 && (distance < hit.Distance || (distance == hit.Distance && instance < hit.Instance)))
        {
            hit = new(distance, primitive, instance);
        }
    }

    /// <summary>Returns whether one instance stands in the way.</summary>
    internal bool IsMet(int instance, in SpaceRay ray, float time, float distance, int skip)
    {
        float* scratch = stackalloc float[Stride];
        return SpaceOf(instance).AnyHit(Inside(instance, ray, MapsAt(instance, time, scratch) + Back), distance, skip);
    }

    private static void Write(in Bounds box, Span<float> to)
    {
        Vector3 slack = box.IsFinite ? new(BoxSlack * Vector3.Max(Vector3.Abs(box.Minimum), Vector3.Abs(box.Maximum)).Largest()) : default;
        (box.Minimum - slack).CopyTo(to);
        (box.Maximum + slack).CopyTo(to[3..]);
    }

    /// <summary>Writes a map and its inverse.</summary>
    internal static void WriteMaps(in Transform place, float* to)
    {
        place.Write(to);
        place.Inverse().Write(to + Back);
    }

    private static SpaceRay Inside(int instance, in SpaceRay ray, float* m)
    {
        (Vector3 o, Vector3 d) = (ray.Origin, ray.Direction);
        return new(
            instance == ray.StartInstance ? ray.InnerStart : new(Row(m, o), Row(m + 4, o), Row(m + 8, o)),
            new(new Vector3(m[0], m[1], m[2]).Dot(d), new Vector3(m[4], m[5], m[6]).Dot(d), new Vector3(m[8], m[9], m[10]).Dot(d)));
    }

    private static float Row(float* m, Vector3 p) =>
        float.FusedMultiplyAdd(p.X, m[0], float.FusedMultiplyAdd(p.Y, m[1], float.FusedMultiplyAdd(p.Z, m[2], m[3])));
}

/// <summary>The hit of a ray.</summary>
/// <param name="Distance">The distance along the ray.</param>
/// <param name="Primitive">The primitive, by its number among the scene's.</param>
/// <param name="Instance">The instance that showed it; 0 for the world itself.</param>
internal readonly record struct InstanceHit(float Distance, int Primitive, int Instance);
