namespace RayTracer.Textbook;

/// <summary>
/// A tree of boxes (report, section 3.5): a ray that misses a box misses all that is in it. The shapes are halved at the one in the middle, or where
/// that costs least by the surface area heuristic: a ray that meets a box meets one inside with the probability of the ratio of their areas
/// (Goldsmith &amp; Salmon 1987; MacDonald &amp; Booth 1990).
/// </summary>
public sealed class BoundingVolumes : IAccelerator
{
    // The cost of a visit, where that of a test is 1.
    private const double VisitCost = 1;
    private const int Bins = 16;
    private const int MostLevels = 60;
    private readonly IShape[] _shapes;
    private readonly int[] _order;
    private readonly Bounds[] _bounds;
    private readonly List<Node> _nodes = [];
    private readonly bool _isHalved;

    /// <summary>Builds the tree.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="isHalved">True to halve at the shape in the middle; false for the surface area heuristic.</param>
    public BoundingVolumes(IReadOnlyList<IShape> shapes, bool isHalved = false)
    {
        _isHalved = isHalved;
        _shapes = [.. shapes];
        _order = [.. Enumerable.Range(0, shapes.Count)];

        // A little larger, so that rounding makes no ray miss a box whose shape it meets.
        _bounds = [.. shapes.Select(s => s.Bounds).Select(b => b.Grown(1e-9 * (b.Size.Largest + b.Low.Largest)))];
        if (_shapes.Length > 0)
        {
            Build(0, _shapes.Length, 0);
        }
    }

    /// <summary>The number of nodes.</summary>
    public int NodeCount => _nodes.Count;

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        Span<int> waiting = stackalloc int[MostLevels + 2];
        int count = 0;
        bool isHit = false;
        if (_nodes.Count > 0)
        {
            waiting[count++] = 0;
        }

        while (count > 0)
        {
            Node node = _nodes[waiting[--count]];
            double begin = 0;
            double end = hit.Distance;
            hit.Visits++;
            hit.Watch?.Invoke(node.Bounds.Corners, hit.Tests);
            if (!node.Bounds.Cut(ray, ref begin, ref end))
            {
                continue;
            }

            if (node.Count > 0)
            {
                isHit |= TestLeaf(node, ray, ref hit);
            }
            else
            {
                // The nearer child is looked at first: what it holds may hide the other.
                bool isLeftNearer = ray.Direction[node.Axis] >= 0;
                waiting[count++] = isLeftNearer ? node.Right : node.Left;
                waiting[count++] = isLeftNearer ? node.Left : node.Right;
            }
        }

        return isHit;
    }

    private bool TestLeaf(in Node node, in Ray ray, ref Hit hit)
    {
        bool isHit = false;
        for (int i = node.First; i < node.First + node.Count; i++)
        {
            hit.Tests++;
            if (_shapes[_order[i]].Intersect(ray, ref hit))
            {
                hit.Index = _order[i];
                isHit = true;
            }
        }

        return isHit;
    }

    private int Build(int first, int count, int level)
    {
        Bounds bounds = Bounds.Empty;
        Bounds middles = Bounds.Empty;
        for (int i = first; i < first + count; i++)
        {
            Bounds own = _bounds[_order[i]];
            bounds = bounds.With(own);
            middles = middles.With(new Bounds(own.Middle, own.Middle));
        }

        int number = _nodes.Count;
        _nodes.Add(new(bounds, first, count, 0, 0, 0));
        int axis = middles.LongestAxis;
        int split = count < 2 || level >= MostLevels ? 0 : _isHalved ? Halve(first, count, axis) : Split(first, count, axis, bounds, middles);
        if (split > 0)
        {
            int left = Build(first, split, level + 1);
            int right = Build(first + split, count - split, level + 1);
            _nodes[number] = new(bounds, 0, 0, left, right, axis);
        }

        return number;
    }

    // Half of the shapes on either side, in the order of their middles.
    private int Halve(int first, int count, int axis)
    {
        if (count <= 4)
        {
            return 0;
        }

        Array.Sort(_order, first, count, Comparer<int>.Create((a, b) => _bounds[a].Middle[axis].CompareTo(_bounds[b].Middle[axis])));
        return count / 2;
    }

    // Where between bins of equal width the two sides together cost least; puts the shapes of the left one first, and returns how many they
    // are. 0 where it costs less to test them all.
    private int Split(int first, int count, int axis, in Bounds bounds, Bounds middles)
    {
        double width = middles.Size[axis];
        if (!(width > 0))
        {
            return count > 8 ? count / 2 : 0;
        }

        int BinOf(int shape) => (int)Math.Min(Bins - 1, (_bounds[shape].Middle[axis] - middles.Low[axis]) / width * Bins);
        Bounds[] boxes = new Bounds[Bins];
        int[] counts = new int[Bins];
        Array.Fill(boxes, Bounds.Empty);
        for (int i = first; i < first + count; i++)
        {
            int bin = BinOf(_order[i]);
            boxes[bin] = boxes[bin].With(_bounds[_order[i]]);
            counts[bin]++;
        }

        int best = 0;
        double least = count;
        for (int cut = 1; cut < Bins; cut++)
        {
            (Bounds left, Bounds right) = (Join(boxes.AsSpan(0, cut)), Join(boxes.AsSpan(cut)));
            int onLeft = counts[..cut].Sum();
            double cost = VisitCost + (((left.Area * onLeft) + (right.Area * (count - onLeft))) / bounds.Area);
            if (onLeft > 0 && onLeft < count && cost < least)
            {
                (best, least) = (cut, cost);
            }
        }

        if (best == 0)
        {
            return 0;
        }

        int[] lower = [.. _order[first..(first + count)].Where(s => BinOf(s) < best)];
        int[] upper = [.. _order[first..(first + count)].Where(s => BinOf(s) >= best)];
        lower.CopyTo(_order, first);
        upper.CopyTo(_order, first + lower.Length);
        return lower.Length;
    }

    private static Bounds Join(ReadOnlySpan<Bounds> boxes)
    {
        Bounds all = Bounds.Empty;
        foreach (Bounds box in boxes)
        {
            all = all.With(box);
        }

        return all;
    }

    // A leaf has shapes, from First on; another node has two children, which lie along an axis.
    private readonly record struct Node(Bounds Bounds, int First, int Count, int Left, int Right, int Axis);
}
