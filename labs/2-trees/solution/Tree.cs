namespace Lab2;

/// <summary>A tree of boxes: a ray that misses a box misses all that is in it.</summary>
public sealed class Tree : IAccelerator
{
    private const int MostInLeaf = 2;
    private readonly IReadOnlyList<IShape> _shapes;
    private readonly bool _isBySurfaceArea;
    private readonly Node _root;

    /// <summary>Builds the tree.</summary>
    /// <param name="shapes">The shapes, at least one.</param>
    /// <param name="isBySurfaceArea">True to divide them where that costs least; false to halve them.</param>
    public Tree(IReadOnlyList<IShape> shapes, bool isBySurfaceArea)
    {
        (_shapes, _isBySurfaceArea) = (shapes, isBySurfaceArea);
        _root = Build([.. Enumerable.Range(0, shapes.Count)]);
    }

    /// <summary>
    /// Where to divide boxes in two, so that a ray costs least: one that meets the box around all of them meets either part with a probability in proportion
    /// to its area, and then asks all that is in it (MacDonald and Booth 1990).
    /// </summary>
    /// <param name="boxes">At least two boxes, in the order of their middles.</param>
    /// <returns>How many of them belong to the first part: from 1 to all but one.</returns>
    public static int BestSplit(IReadOnlyList<Bounds> boxes)
    {
        //? Tree.BestSplit: try every number, and take that with the smallest sum of area · number of both parts.
        int best = 1;
        double least = double.PositiveInfinity;
        for (int n = 1; n < boxes.Count; n++)
        {
            double cost = (n * Around(boxes.Take(n)).Area) + ((boxes.Count - n) * Around(boxes.Skip(n)).Area);
            if (cost < least)
            {
                (best, least) = (n, cost);
            }
        }

        return best;
        //!
    }

    /// <summary>The box around boxes.</summary>
    public static Bounds Around(IEnumerable<Bounds> boxes) => boxes.Aggregate(Bounds.Empty, (all, box) => all.With(box));

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit) => Intersect(_root, ray, ref hit);

    private Node Build(int[] numbers)
    {
        //? Tree.Build: a leaf for few shapes; otherwise sort them by their middles along the longest axis of those, and build a node of both parts.
        Bounds bounds = Around(numbers.Select(n => _shapes[n].Bounds));
        if (numbers.Length <= MostInLeaf)
        {
            return new(bounds, numbers, null, null);
        }

        Bounds middles = Around(numbers.Select(n => new Bounds(_shapes[n].Bounds.Middle, _shapes[n].Bounds.Middle)));
        int axis = middles.LongestAxis;
        int[] sorted = [.. numbers.OrderBy(n => _shapes[n].Bounds.Middle[axis])];
        int first = _isBySurfaceArea ? BestSplit([.. sorted.Select(n => _shapes[n].Bounds)]) : sorted.Length / 2;
        return new(bounds, [], Build(sorted[..first]), Build(sorted[first..]));
        //!
    }

    private bool Intersect(Node node, in Ray ray, ref Hit hit)
    {
        //? Tree.Intersect: nothing where the ray misses the node's box before hit.Distance; a leaf asks its shapes, another node its children, the nearer one first.
        hit.Visits++;
        if (Box.Enter(node.Bounds, ray, hit.Distance) is null)
        {
            return false;
        }

        bool isHit = false;
        foreach (int n in node.Shapes)
        {
            if (_shapes[n].Intersect(ray, ref hit))
            {
                hit.Index = n;
                isHit = true;
            }
        }

        if (node is { First: { } first, Second: { } second })
        {
            double toFirst = Box.Enter(first.Bounds, ray, hit.Distance) ?? double.PositiveInfinity;
            double toSecond = Box.Enter(second.Bounds, ray, hit.Distance) ?? double.PositiveInfinity;
            (Node near, Node far) = toFirst <= toSecond ? (first, second) : (second, first);
            isHit |= Intersect(near, ray, ref hit);
            isHit |= Intersect(far, ray, ref hit);
        }

        return isHit;
        //!
    }

    // A leaf has the numbers of shapes; another node has two children.
    private sealed record Node(Bounds Bounds, int[] Shapes, Node? First, Node? Second);
}
