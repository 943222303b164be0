using System.Runtime.CompilerServices;

namespace RayTracer.Acceleration;

/// <summary>
/// Builds eight-wide trees from the top (Wald, Benthin &amp; Boulos 2008): a node's children are found by cutting the child of the largest surface
/// until there are eight. Large ranges are cut by all threads together, piece by piece, until what is left is small
/// enough for one thread; pieces and ranges depend on the number of primitives only, and so does the tree.
/// </summary>
internal sealed unsafe class BvhBuilder : IDisposable
{
    // Below this depth halves are taken: the depth is then bounded, whatever the primitives.
    private const int MaxSahDepth = 32;
    private const int SmallestTask = 4096;
    private const int Pieces = 64;
    private readonly int _leafSize;
    private readonly int _threads;
    private readonly int _taskSize;
    private readonly NativeMemoryBlock _references;
    private readonly NativeMemoryBlock _otherReferences;
    private readonly SahBins[] _pieceBins = new SahBins[Pieces];
    private readonly List<Task> _tasks = [];
    private readonly int* _order;

    private BvhBuilder(int capacity, int leafSize, int threads, int* order)
    {
        _leafSize = leafSize;
        _threads = threads;
        _order = order;
        _references = new((long)capacity * sizeof(PrimitiveReference));
        _taskSize = Math.Max(SmallestTask, capacity / Pieces);
        _otherReferences = new(capacity > _taskSize ? _references.Bytes : 0);
        for (int piece = 0; piece < Pieces; piece++)
        {
            _pieceBins[piece] = new();
        }
    }

    /// <summary>Builds a tree.</summary>
    /// <param name="primitives">The primitives that the tree is built over.</param>
    /// <param name="leafSize">Most primitives a leaf, 1 to 8.</param>
    /// <param name="threads">Number of threads.</param>
    public static WideBvh Build<TPrimitives>(TPrimitives primitives, int leafSize, int threads)
        where TPrimitives : IPrimitiveBounds
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThan(primitives.Count, BvhNode.MaxPrimitives, nameof(primitives));
        NativeMemoryBlock order = new((long)primitives.Count * sizeof(int));
        using BvhBuilder builder = new(primitives.Count, leafSize, threads, (int*)order.Pointer);
        BvhRange all = builder.Collect(primitives);
        NativeMemoryBlock nodes = builder.Build(all);
        return new(nodes, order, all.Bounds, all.Count);
    }

    public void Dispose()
    {
        _references.Dispose();
        _otherReferences.Dispose();
        foreach (SahBins bins in _pieceBins)
        {
            bins.Dispose();
        }
    }

    private static int PieceStart(int count, int piece) => (int)((long)count * piece / Pieces);

    private BvhRange Collect<TPrimitives>(TPrimitives primitives)
        where TPrimitives : IPrimitiveBounds
    {
        PrimitiveReference* references = (PrimitiveReference*)_references.Pointer;
        BvhRange[] parts = new BvhRange[Pieces];
        ParallelLoop.Run(_threads, Pieces, piece =>
        {
            int first = PieceStart(primitives.Count, piece);
            int last = PieceStart(primitives.Count, piece + 1);
            Box4 bounds = Box4.Empty;
            Box4 middles = Box4.Empty;
            int count = 0;
            for (int i = first; i < last; i++)
            {
                if (primitives.TryGetBounds(i, out Box4 box))
                {
                    PrimitiveReference reference = PrimitiveReference.Of(box, i);
                    references[first + count++] = reference;
                    bounds.Grow(box);
                    middles.Grow(reference.Middle, reference.Middle);
                }
            }

            parts[piece] = BvhPartition.Range(references + first, count, 0, bounds, middles);
        });
        return Join(parts, 0);
    }

    /// <summary>Moves the parts of a range together that lie in order in one array.</summary>
    private static BvhRange Join(ReadOnlySpan<BvhRange> parts, int start)
    {
        Box4 bounds = Box4.Empty;
        Box4 middles = Box4.Empty;
        int count = 0;
        foreach (ref readonly BvhRange part in parts)
        {
            PrimitiveReference* place = parts[0].First + count;
            if (part.First != place)
            {
                new Span<PrimitiveReference>(part.First, part.Count).CopyTo(new(place, part.Count));
            }

            bounds.Grow(part.Bounds);
            middles.Grow(part.Middles);
            count += part.Count;
        }

        return BvhPartition.Range(parts[0].First, count, start, bounds, middles);
    }

    private NativeMemoryBlock Build(in BvhRange all)
    {
        using BvhNodeList top = new(256);
        top.Add();
        if (all.Count > 0)
        {
            BuildTop(top, 0, all, 0);
        }
        else
        {
            BvhNode.Encode(top[0], [], 0);
        }

        ParallelLoop.Run(_threads, _tasks.Count, i => _tasks[i].Nodes = BuildTask(_tasks[i].Range, _tasks[i].Depth));
        int count = top.Count;
        foreach (Task task in _tasks)
        {
            task.First = count;
            top[task.Parent]->Child[task.Slot] = (uint)count;
            count += task.Nodes!.Count;
        }

        NativeMemoryBlock nodes = new((long)count * BvhNode.Bytes);
        BvhNode* target = (BvhNode*)nodes.Pointer;
        top.MoveTo(target, 0);
        ParallelLoop.Run(_threads, _tasks.Count, i =>
        {
            _tasks[i].Nodes!.MoveTo(target + _tasks[i].First, _tasks[i].First);
            _tasks[i].Nodes!.Dispose();
        });
        return nodes;
    }

    /// <summary>Nodes above the tasks, all threads together.</summary>
    private void BuildTop(BvhNodeList top, int node, in BvhRange range, int depth)
    {
        Children children = default;
        int count = Open(range, ref children, _pieceBins[0], depth);
        BvhNode* parent = Emit(top, node, children, count);
        for (int i = 0; i < count; i++)
        {
            if (children[i].Count > _leafSize && children[i].Count <= _taskSize)
            {
                _tasks.Add(new(children[i], node, i, depth + 1));
            }
        }

        for (int i = 0; i < count; i++)
        {
            if (children[i].Count > _taskSize)
            {
                int child = top.Add();
                top[node]->Child[i] = (uint)child;
                BuildTop(top, child, children[i], depth + 1);
            }
        }
    }

    private BvhNodeList BuildTask(in BvhRange range, int depth)
    {
        using SahBins bins = new();
        BvhNodeList nodes = new(8 + (range.Count / (2 * _leafSize)));
        BuildNode(nodes, nodes.Add(), range, bins, depth);
        return nodes;
    }

    private void BuildNode(BvhNodeList nodes, int node, in BvhRange range, SahBins bins, int depth)
    {
        Children children = default;
        int count = Open(range, ref children, bins, depth);
        Emit(nodes, node, children, count);
        int first = nodes.Count;
        for (int i = 0; i < count; i++)
        {
            if (children[i].Count > _leafSize)
            {
                int child = nodes.Add();
                nodes[node]->Child[i] = (uint)child;
            }
        }

        for (int i = 0; i < count; i++)
        {
            if (children[i].Count > _leafSize)
            {
                BuildNode(nodes, first++, children[i], bins, depth + 1);
            }
        }
    }

    /// <summary>Cuts a range into children.</summary>
    /// <returns>The number of children.</returns>
    private int Open(in BvhRange range, ref Children children, SahBins bins, int depth)
    {
        children[0] = range;
        int count = 1;
        while (count < 8)
        {
            int largest = -1;
            for (int i = 0; i < count; i++)
            {
                if (children[i].Count > _leafSize && (largest < 0 || children[i].Area > children[largest].Area))
                {
                    largest = i;
                }
            }

            if (largest < 0)
            {
                break;
            }

            Cut(children[largest], bins, depth, out BvhRange lower, out BvhRange upper);
            children[largest] = lower;
            children[count++] = upper;
        }

        return count;
    }

    private void Cut(in BvhRange range, SahBins bins, int depth, out BvhRange lower, out BvhRange upper)
    {
        SahSplit split = SahSplit.Over(range);
        bool together = range.Count > _taskSize;
        if (depth < MaxSahDepth)
        {
            if (together)
            {
                FillTogether(range, split);
            }
            else
            {
                bins.Fill(range.First, range.Count, split);
            }

            split.Choose(bins, _leafSize);
        }

        if (split.Axis < 0)
        {
            BvhPartition.Halve(range, out lower, out upper);
        }
        else if (together)
        {
            PartitionTogether(range, split, out lower, out upper);
        }
        else
        {
            BvhPartition.InPlace(range, split, out lower, out upper);
        }
    }

    /// <summary>Fills the bins of each piece, and adds them up in those of the first piece, whose own contents move to the last.</summary>
    private void FillTogether(in BvhRange range, SahSplit split)
    {
        PrimitiveReference* first = range.First;
        int count = range.Count;
        ParallelLoop.Run(_threads, Pieces, piece =>
        {
            int start = PieceStart(count, piece);
            _pieceBins[piece].Fill(first + start, PieceStart(count, piece + 1) - start, split);
        });
        for (int piece = 1; piece < Pieces; piece++)
        {
            _pieceBins[0].Add(_pieceBins[piece], split.Bins);
        }
    }

    private void PartitionTogether(in BvhRange range, SahSplit split, out BvhRange lower, out BvhRange upper)
    {
        PrimitiveReference* from = range.First;
        PrimitiveReference* to = Other(from);
        int count = range.Count;
        BvhRange[] lowers = new BvhRange[Pieces];
        BvhRange[] uppers = new BvhRange[Pieces];

        // The first bins hold the sum of all.
        int below = _pieceBins[0].CountBelow(split.Axis, split.Position);
        int lowerBefore = below;
        for (int piece = Pieces - 1; piece >= 0; piece--)
        {
            lowerBefore -= piece > 0 ? _pieceBins[piece].CountBelow(split.Axis, split.Position) : lowerBefore;
            lowers[piece].First = to + lowerBefore;
            uppers[piece].First = to + below + PieceStart(count, piece) - lowerBefore;
        }

        ParallelLoop.Run(_threads, Pieces, piece =>
        {
            int start = PieceStart(count, piece);
            BvhPartition.Scatter(from + start, PieceStart(count, piece + 1) - start, split, ref lowers[piece], ref uppers[piece]);
        });
        lower = Join(lowers, range.Start);
        upper = Join(uppers, range.Start + below);
    }

    private PrimitiveReference* Other(PrimitiveReference* reference)
    {
        PrimitiveReference* one = (PrimitiveReference*)_references.Pointer;
        PrimitiveReference* two = (PrimitiveReference*)_otherReferences.Pointer;
        long size = _references.Bytes / sizeof(PrimitiveReference);
        return reference >= one && reference < one + size ? two + (reference - one) : one + (reference - two);
    }

    /// <summary>Writes a node whose children are leaves, or nodes whose indices follow.</summary>
    private BvhNode* Emit(BvhNodeList nodes, int node, in Children children, int count)
    {
        Span<Box4> boxes = stackalloc Box4[8];
        for (int i = 0; i < count; i++)
        {
            boxes[i] = children[i].Bounds;
        }

        BvhNode.Encode(nodes[node], boxes, count);
        for (int i = 0; i < count; i++)
        {
            if (children[i].Count <= _leafSize)
            {
                nodes[node]->Child[i] = Leaf(children[i]);
            }
        }

        return nodes[node];
    }

    private uint Leaf(in BvhRange range)
    {
        for (int i = 0; i < range.Count; i++)
        {
            _order[range.Start + i] = range.First[i].Number;
        }

        return BvhNode.LeafReference(range.Start, range.Count);
    }

    [InlineArray(8)]
    private struct Children
    {
        private BvhRange _first;
    }

    /// <summary>A subtree that one thread builds.</summary>
    private sealed class Task(BvhRange range, int parent, int slot, int depth)
    {
        public BvhRange Range => range;

        public int Parent => parent;

        public int Slot => slot;

        public int Depth => depth;

        public BvhNodeList? Nodes { get; set; }

        public int First { get; set; }
    }
}

/// <summary>The primitives that a tree is built over. Asked from several threads at once.</summary>
internal interface IPrimitiveBounds
{
    /// <summary>Number of primitives.</summary>
    int Count { get; }

    /// <summary>The box of a primitive.</summary>
    /// <returns>False where the primitive can never be hit and stays out of the tree.</returns>
    bool TryGetBounds(int primitive, out Box4 box);
}
