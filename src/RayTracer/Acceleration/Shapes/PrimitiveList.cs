using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>
/// Meets rays with all shapes of a space (report: Intersect and ShadowHit): kind by kind in a plain loop where they are few, and through a
/// tree where they are many, but for those without end. Hits are the same to the bit.
/// </summary>
internal sealed unsafe class PrimitiveList
{
    private readonly int _nothing;
    private readonly Loop[] _loops;
    private readonly ShapeTree? _tree;

    /// <summary>Takes the shapes of a space.</summary>
    /// <param name="shapes">The shapes in the order of their primitive numbers.</param>
    /// <param name="batches">The same, packed by kind.</param>
    /// <param name="nothing">The number that stands for no primitive.</param>
    /// <param name="largestLoop">The most shapes without a tree.</param>
    internal PrimitiveList(Shape[] shapes, ShapeBatch[] batches, int nothing, int largestLoop)
    {
        Count = shapes.Length;
        _nothing = nothing;
        if (Count > largestLoop)
        {
            _tree = new(shapes, batches);
            _loops = [.. LoopsAround(_tree.Members, batches)];
        }
        else
        {
            _loops = [.. batches.Select(b => new Loop(b, 0, b.Count))];
        }
    }

    /// <summary>Number of primitives.</summary>
    public int Count { get; }

    /// <summary>True where the shapes are in a tree, but for those without end.</summary>
    public bool HasTree => _tree is not null;

    /// <summary>Memory of the tree; 0 without one.</summary>
    public long TreeBytes => _tree?.MemoryBytes ?? 0;

    /// <summary>Finds the nearest hit of each ray.</summary>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">Distance to the nearest hit; infinite where there is none.</param>
    /// <param name="primitive">The primitive hit; the number that stands for nothing where there is none.</param>
    /// <param name="lanes">The number of lanes that count; the results in the others are undefined.</param>
    public void ClosestHit(in Vec3W origin, in Vec3W direction, out FloatW distance, out UIntW primitive, int lanes = int.MaxValue)
    {
        distance = float.PositiveInfinity;
        primitive = (uint)_nothing;
        Shorten(origin, direction, ref distance, ref primitive, lanes);
    }

    /// <summary>Shortens rays to their nearest hits.</summary>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">Distance to the nearest hit so far.</param>
    /// <param name="primitive">The primitive hit so far.</param>
    /// <param name="lanes">The number of lanes that count; the results in the others are undefined.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Shorten(in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive, int lanes = int.MaxValue)
    {
        FloatW limit = distance;
        foreach (ref readonly Loop loop in _loops.AsSpan())
        {
            loop.Batch.ClosestHit(loop.First, loop.End, origin, direction, ref distance, ref primitive);
        }

        if (_tree is not null)
        {
            ShortenInTree(origin, direction, limit, ref distance, ref primitive, Math.Min(lanes, FloatW.Count));
        }
    }

    /// <summary>Clears those rays that something stands in the way of.</summary>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">The distance over which the rays must be free.</param>
    /// <param name="skip">A primitive that does not count; −1 for none.</param>
    /// <param name="free">The rays to look at; cleared where they are not free.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Occlude(in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free)
    {
        foreach (ref readonly Loop loop in _loops.AsSpan())
        {
            loop.Batch.Occlude(loop.First, loop.End, origin, direction, distance, skip, ref free);
            if (!free.Any)
            {
                return;
            }
        }

        if (_tree is not null)
        {
            OccludeInTree(origin, direction, distance, skip, ref free);
        }
    }

    /// <summary>
    /// As <see cref="Occlude"/>, with a primitive for each lane that does not count; only where there is a tree, which all primitives are in that have an end.
    /// </summary>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">The distance over which the rays must be free.</param>
    /// <param name="skips">The primitives, which have ends; −1 for none.</param>
    /// <param name="free">The rays to look at; cleared where they are not free.</param>
    public void OccludeEach(in Vec3W origin, in Vec3W direction, in FloatW distance, int* skips, ref MaskW free)
    {
        foreach (ref readonly Loop loop in _loops.AsSpan())
        {
            loop.Batch.Occlude(loop.First, loop.End, origin, direction, distance, -1, ref free);
        }

        OccludeInTree(origin, direction, distance, skips, ref free);
    }

    // The runs of shapes that the tree leaves out.
    private static IEnumerable<Loop> LoopsAround(ReadOnlySpan<int> members, ShapeBatch[] batches)
    {
        List<Loop> loops = [];
        HashSet<int> inTree = [.. members];
        int before = 0;
        foreach (ShapeBatch batch in batches)
        {
            for (int i = 0; i < batch.Count; i++)
            {
                if (inTree.Contains(before + i))
                {
                    continue;
                }

                int first = i;
                while (i + 1 < batch.Count && !inTree.Contains(before + i + 1))
                {
                    i++;
                }

                loops.Add(new(batch, first, i + 1));
            }

            before += batch.Count;
        }

        return loops;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void ShortenInTree(in Vec3W origin, in Vec3W direction, in FloatW limit, ref FloatW distance, ref UIntW primitive, int lanes)
    {
        float* distances = stackalloc float[FloatW.Count];
        uint* primitives = stackalloc uint[FloatW.Count];
        distance.Store(distances);
        primitive.Store(primitives);
        for (int lane = 0; lane < lanes; lane++)
        {
            _tree!.ClosestHit(SpaceRay.Of(origin, direction, lane), limit[lane], ref distances[lane], ref primitives[lane]);
        }

        distance = FloatW.Load(distances);
        primitive = UIntW.Load(primitives);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void OccludeInTree(in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free)
    {
        int* skips = stackalloc int[FloatW.Count];
        new Span<int>(skips, FloatW.Count).Fill(skip);
        OccludeInTree(origin, direction, distance, skips, ref free);
    }

    private void OccludeInTree(in Vec3W origin, in Vec3W direction, in FloatW distance, int* skips, ref MaskW free)
    {
        int* blocked = stackalloc int[FloatW.Count];
        MaskW.None.V.Store(blocked);
        for (uint left = free.Bits; left != 0; left &= left - 1)
        {
            int lane = BitOperations.TrailingZeroCount(left);
            blocked[lane] = _tree!.AnyHit(SpaceRay.Of(origin, direction, lane), distance[lane], skips[lane]) ? -1 : 0;
        }

        free = free.Except(new(Vector.Load(blocked)));
    }

    // Consecutive shapes of a batch.
    private readonly record struct Loop(ShapeBatch Batch, int First, int End);
}
