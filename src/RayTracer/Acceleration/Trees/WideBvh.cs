using System.Runtime.Intrinsics;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>
/// A bounding volume hierarchy with up to eight children a node, over primitives of which it knows nothing but their boxes. The same
/// boxes give the same tree, whatever the number of threads.
/// </summary>
internal sealed unsafe class WideBvh
{
    private readonly NativeMemoryBlock _nodes;
    private NativeMemoryBlock? _order;
    private BvhStatistics? _statistics;

    internal WideBvh(NativeMemoryBlock nodes, NativeMemoryBlock order, Box4 bounds, int count)
    {
        _nodes = nodes;
        _order = order;
        Bounds = bounds;
        Count = count;
    }

    /// <summary>Number of primitives in the tree, without those that were left out.</summary>
    public int Count { get; }

    /// <summary>The primitives' numbers in the order of the leaves, which are ranges of it.</summary>
    public ReadOnlySpan<int> Order => _order is null ? [] : new(_order.Pointer, Count);

    /// <summary>The size and shape of the tree, counted when it is first asked for.</summary>
    public BvhStatistics Statistics => _statistics ??= BvhInspection.Count(this);

    /// <summary>The box of everything.</summary>
    internal Box4 Bounds { get; }

    /// <summary>The root, and behind it all other nodes.</summary>
    internal BvhNode* Nodes => (BvhNode*)_nodes.Pointer;

    /// <summary>Number of nodes.</summary>
    internal int NodeCount => (int)(_nodes.Bytes / BvhNode.Bytes);

    /// <summary>Memory of nodes and order.</summary>
    internal long MemoryBytes => _nodes.Bytes + (_order?.Bytes ?? 0);

    /// <summary>Builds a tree.</summary>
    /// <param name="bounds">
    /// Six numbers a primitive: lower x, y, z, upper x, y, z. Primitives whose numbers are not finite, beyond ±10¹⁸ or the wrong way round
    /// stay out of the tree.
    /// </param>
    /// <param name="leafSize">Most primitives a leaf, 1 to 8.</param>
    /// <param name="threads">Number of threads.</param>
    /// <exception cref="ArgumentException">Not six numbers a primitive, or a size out of range.</exception>
    public static WideBvh Build(ReadOnlySpan<float> bounds, int leafSize, int threads)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(leafSize, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(leafSize, 8);
        ArgumentOutOfRangeException.ThrowIfLessThan(threads, 1);
        if (bounds.Length % 6 != 0)
        {
            throw new ArgumentException("Bounds need six numbers a primitive.", nameof(bounds));
        }

        fixed (float* pointer = bounds)
        {
            return BvhBuilder.Build(new BoxArray(pointer, bounds.Length / 6), leafSize, threads);
        }
    }

    /// <summary>Frees the order, for who keeps the primitives in it.</summary>
    internal void ReleaseOrder()
    {
        _order?.Dispose();
        _order = null;
    }

    private readonly struct BoxArray(float* bounds, int count) : IPrimitiveBounds
    {
        public int Count => count;

        public bool TryGetBounds(int primitive, out Box4 box)
        {
            float* b = bounds + (6L * primitive);
            box = new() { Lower = Vector128.Create(b[0], b[1], b[2], 0f), Upper = Vector128.Create(b[3], b[4], b[5], 0f) };
            return box.IsBounded && Vector128.LessThanOrEqualAll(box.Lower, box.Upper);
        }
    }
}

/// <summary>The size and shape of a tree.</summary>
/// <param name="Primitives">Primitives in its leaves.</param>
/// <param name="Nodes">Inner nodes.</param>
/// <param name="Leaves">Leaves.</param>
/// <param name="Depth">Nodes on the longest way from the root to a leaf.</param>
/// <param name="SahCost">
/// Nodes, plus leaves, that a random line through the root's box is expected to visit (MacDonald &amp; Booth 1990), by the ratio of surface
/// areas.
/// </param>
/// <param name="MemoryBytes">Memory of the nodes and of what the leaves hold.</param>
public readonly record struct BvhStatistics(int Primitives, int Nodes, int Leaves, int Depth, double SahCost, long MemoryBytes);
