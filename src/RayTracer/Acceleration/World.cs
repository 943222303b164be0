using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>Everything that rays can meet: the shapes and triangles of the world itself, and the instances that stand in it.</summary>
internal sealed unsafe class World
{
    // Measured: decision 015.
    private const int LargestLoop = 320;
    private const int LargestLoopOfInstances = 40;
    private readonly (double Open, double Close) _shutter;

    /// <summary>Packs what a builder has put together.</summary>
    /// <param name="contents">The world's contents.</param>
    /// <param name="shutter">When the shutter opens and closes, in seconds.</param>
    /// <param name="largestLoop">The most shapes of a space that rays are tested against one after the other; null for what is
    /// fastest.</param>
    public World(SpaceContents contents, (double Open, double Close) shutter, int? largestLoop)
    {
        _shutter = shutter;
        SpaceContents[] all = [contents, .. contents.Instances.Select(i => i.Contents).Distinct<SpaceContents>(ReferenceEqualityComparer.Instance)];
        Count = checked(all.Sum(s => s.Shapes.Count + s.Meshes.Sum(m => m.Data.TriangleCount)));
        Spaces = new Space[all.Length];
        int first = 0;
        for (int i = 0; i < all.Length; i++)
        {
            // Instances are met by single rays, which gain less by a loop.
            Spaces[i] = new(all[i], first, Count, largestLoop ?? (i == 0 ? LargestLoop : LargestLoopOfInstances));
            first += Spaces[i].Count;
        }

        Itself = Spaces[0];
        Instances = contents.Instances.Count > 0 ? new(contents.Instances, Spaces[1..], shutter) : null;

        // The table has them all now, in less memory.
        foreach (SpaceContents space in all)
        {
            space.Instances.Clear();
            space.Instances.TrimExcess();
        }
    }

    /// <summary>
    /// Number of primitives, each counted once however many instances show it; as a primitive number, it means that nothing was hit.
    /// </summary>
    public int Count { get; }

    /// <summary>The world itself, and then the spaces of what instances show.</summary>
    public Space[] Spaces { get; }

    /// <summary>The space of the world itself.</summary>
    public Space Itself { get; }

    /// <summary>The instances; null where there are none.</summary>
    public InstanceTable? Instances { get; }

    /// <summary>True where anything moves while the shutter is open.</summary>
    public bool Moves => Instances is { Moves: true } || Itself.Contents.Lights.Exists(l => !l.Motion.IsStill);

    /// <summary>True where everything has an end.</summary>
    public bool IsFinite => Array.TrueForAll(Spaces, s => s.Bounds.IsFinite || s.Count == 0);

    /// <summary>The ball around all that has an end, while the shutter is open.</summary>
    public SceneBall Ball => field ??= new(FiniteBounds());

    /// <summary>True where there is nothing but shapes in the world itself.</summary>
    public bool IsPlain => Itself.Tree is null && Instances is null;

    /// <summary>The room for numbers that a search for the nearest hits of streams needs.</summary>
    /// <param name="rays">The largest number of rays.</param>
    public int RoomForHits(int rays) => IsPlain ? 1 : rays + 16;

    /// <summary>
    /// Returns the cost of finding the nearest hit of a ray by itself: nodes visited plus triangles tested, in all trees together.
    /// </summary>
    /// <param name="ray">The ray.</param>
    /// <param name="time">Its time in seconds.</param>
    public long Cost(in SpaceRay ray, float time)
    {
        float distance = float.PositiveInfinity;
        long cost = Itself.Cost(ray, distance);
        if (Instances is not null)
        {
            int primitive = Itself.ClosestHit(ray, ref distance);
            cost += Instances.Cost(ray, time, new(distance, primitive < 0 ? Count : primitive, 0));
        }

        return cost;
    }

    private Bounds FiniteBounds()
    {
        Bounds all = Itself.FiniteBounds;
        for (int instance = 1; instance <= (Instances?.Count ?? 0); instance++)
        {
            Bounds inside = Instances!.SpaceOf(instance).FiniteBounds;
            all = inside.IsFinite ? all.Union(Instances.BoundsOf(instance, inside, _shutter)) : all;
        }

        return all;
    }
}
