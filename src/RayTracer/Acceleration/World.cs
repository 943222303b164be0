using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>Everything that rays can meet: the shapes and triangles of the world itself, and the instances that stand in it.</summary>
internal sealed unsafe class World
{
    /// <summary>Packs what a builder has put together.</summary>
    /// <param name="contents">The world's contents.</param>
    /// <param name="shutter">When the shutter opens and closes, in seconds.</param>
    public World(SpaceContents contents, (double Open, double Close) shutter)
    {
        SpaceContents[] all = [contents, .. contents.Instances.Select(i => i.Contents).Distinct<SpaceContents>(ReferenceEqualityComparer.Instance)];
        Count = checked(all.Sum(s => s.Shapes.Count + s.Meshes.Sum(m => m.Data.TriangleCount)));
        Spaces = new Space[all.Length];
        int first = 0;
        for (int i = 0; i < all.Length; i++)
        {
            Spaces[i] = new(all[i], first, Count);
            first += Spaces[i].Count;
        }

        Itself = Spaces[0];
        Instances = contents.Instances.Count > 0 ? new(contents.Instances, Spaces[1..], shutter) : null;
    }

    /// <summary>Number of primitives, each counted once however many instances show it; as a primitive number, it means that nothing was hit.</summary>
    public int Count { get; }

    /// <summary>The world itself, and then the spaces of what instances show.</summary>
    public Space[] Spaces { get; }

    /// <summary>What stands in the world itself.</summary>
    public Space Itself { get; }

    /// <summary>The instances; null where there are none.</summary>
    public InstanceTable? Instances { get; }

    /// <summary>Whether there is nothing but shapes in the world itself.</summary>
    public bool IsPlain => Itself.Tree is null && Instances is null;

    /// <summary>Shortens rays, which have met the shapes of the world itself, to what else they meet.</summary>
    /// <param name="paths">The rays.</param>
    /// <param name="hits">Room for a number for each.</param>
    public void ClosestHit(PathStream paths, int* hits)
    {
        if (Itself.Tree is not null)
        {
            Itself.Tree.ClosestHit(paths.Rays(hits));
            uint first = (uint)Itself.Mesh!.FirstPrimitive;
            for (int i = 0; i < paths.Count; i++)
            {
                paths.Primitive[i] = hits[i] >= 0 ? first + (uint)hits[i] : paths.Primitive[i];
            }
        }

        if (Instances is not null)
        {
            for (int i = 0; i < paths.Count; i++)
            {
                InstanceHit hit = new(paths.Distance[i], (int)paths.Primitive[i], 0);
                Instances.ClosestHit(paths.Ray(i), Instances.Moves ? paths.Time[i] : 0, ref hit);
                (paths.Distance[i], paths.Primitive[i], paths.Instance[i]) = (hit.Distance, (uint)hit.Primitive, (uint)hit.Instance);
            }
        }
    }

    /// <summary>Clears those rays, which are free of the shapes of the world itself, that anything else stands in the way of.</summary>
    /// <param name="origin">Where the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">How far they must be free.</param>
    /// <param name="time">Their times in seconds; used only where something moves.</param>
    /// <param name="skippedInstance">An instance of which one primitive does not count; 0 for none.</param>
    /// <param name="skip">That primitive.</param>
    /// <param name="free">The rays to look at; cleared where they are not free.</param>
    public void Occlude(in Vec3W origin, in Vec3W direction, in FloatW distance, in FloatW time, int skippedInstance, int skip, ref MaskW free)
    {
        uint open = free.Bits;
        if (Itself.Tree is not null)
        {
            open &= ~Occluded(origin, direction, distance, open);
        }

        for (uint rest = Instances is null ? 0 : open; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            SpaceRay ray = new(new(origin.X[lane], origin.Y[lane], origin.Z[lane]), new(direction.X[lane], direction.Y[lane], direction.Z[lane]));
            bool met = Instances!.AnyHit(ray, Instances.Moves ? time[lane] : 0, distance[lane], skippedInstance, skip);
            open &= met ? ~(1u << lane) : ~0u;
        }

        free &= MaskW.FromBits(open);
    }

    // Of the chosen lanes, those in whose way a triangle of the world itself stands.
    private uint Occluded(in Vec3W origin, in Vec3W direction, in FloatW distance, uint lanes)
    {
        const int room = 32;
        float* numbers = stackalloc float[7 * room];
        int* hits = stackalloc int[room];
        origin.X.Compress(numbers, lanes);
        origin.Y.Compress(numbers + room, lanes);
        origin.Z.Compress(numbers + (2 * room), lanes);
        direction.X.Compress(numbers + (3 * room), lanes);
        direction.Y.Compress(numbers + (4 * room), lanes);
        direction.Z.Compress(numbers + (5 * room), lanes);
        distance.Compress(numbers + (6 * room), lanes);
        Itself.Tree!.AnyHit(new()
        {
            OriginX = numbers,
            OriginY = numbers + room,
            OriginZ = numbers + (2 * room),
            DirectionX = numbers + (3 * room),
            DirectionY = numbers + (4 * room),
            DirectionZ = numbers + (5 * room),
            Distance = numbers + (6 * room),
            Primitive = hits,
            Count = BitOperations.PopCount(lanes),
        });
        uint met = 0;
        for (int i = 0; lanes != 0; lanes &= lanes - 1, i++)
        {
            met |= hits[i] >= 0 ? 1u << BitOperations.TrailingZeroCount(lanes) : 0;
        }

        return met;
    }
}
