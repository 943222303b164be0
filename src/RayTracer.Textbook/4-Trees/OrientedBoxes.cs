namespace RayTracer.Textbook;

/// <summary>
/// As <see cref="BoundingVolumes"/>, of boxes that stand askew (report, section 3.5; Gottschalk, Lin &amp; Manocha 1996): each is turned so that it is small.
/// They fit long things that run across the axes; but each test turns the ray first.
/// </summary>
public sealed class OrientedBoxes : IAccelerator
{
    private const int SmallLeaf = 4;
    private readonly IReadOnlyList<IShape> _shapes;
    private readonly Node? _root;

    /// <summary>Builds the tree, halving at the shape in the middle.</summary>
    /// <param name="shapes">The shapes.</param>
    public OrientedBoxes(IReadOnlyList<IShape> shapes)
    {
        _shapes = shapes;
        _root = shapes.Count > 0 ? Build([.. Enumerable.Range(0, shapes.Count)]) : null;
    }

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit) => _root is not null && Visit(_root, ray, ref hit);

    private bool Visit(Node node, in Ray ray, ref Hit hit)
    {
        double begin = 0;
        double end = hit.Distance;
        hit.Visits++;
        hit.Watch?.Invoke(Array.ConvertAll(node.Box.Corners, node.Frame.ToWorld), hit.Tests);
        Ray turned = new(node.Frame.ToLocal(ray.Origin), node.Frame.ToLocal(ray.Direction));
        if (!node.Box.Cut(turned, ref begin, ref end))
        {
            return false;
        }

        bool isHit = false;
        foreach (int shape in node.Shapes)
        {
            hit.Tests++;
            if (_shapes[shape].Intersect(ray, ref hit))
            {
                hit.Index = shape;
                isHit = true;
            }
        }

        // The child whose middle the ray passes first is looked at first.
        if (node.Low is { } low && node.High is { } high)
        {
            bool isLowFirst = Vector.Dot(high.Middle - low.Middle, ray.Direction) >= 0;
            isHit |= Visit(isLowFirst ? low : high, ray, ref hit);
            isHit |= Visit(isLowFirst ? high : low, ray, ref hit);
        }

        return isHit;
    }

    private Node Build(int[] shapes)
    {
        // Of a few frames, the one in which the box around all has the least area.
        (Frame Frame, Bounds Box) best = Frames.Select(f => (f, Around(shapes, f))).MinBy(b => b.Item2.Area);
        Vector middle = best.Frame.ToWorld(best.Box.Middle);
        double slack = 1e-9 * (best.Box.Size.Largest + best.Box.Low.Largest + best.Box.High.Largest);
        Bounds box = best.Box.Grown(slack);
        if (shapes.Length <= SmallLeaf)
        {
            return new(best.Frame, box, middle, null, null, shapes);
        }

        // Along the axis of the frame on which their middles are spread most.
        Bounds middles = Bounds.Around([.. shapes.Select(s => best.Frame.ToLocal(_shapes[s].Bounds.Middle))]);
        int axis = middles.LongestAxis;
        int[] sorted = [.. shapes.OrderBy(s => best.Frame.ToLocal(_shapes[s].Bounds.Middle)[axis])];
        return new(best.Frame, box, middle, Build(sorted[..(sorted.Length / 2)]), Build(sorted[(sorted.Length / 2)..]), []);
    }

    private static IReadOnlyList<Frame> Frames { get; } = [.. BspTree.Directions.Select(d => new Frame(d))];

    private Bounds Around(int[] shapes, Frame frame)
    {
        (Vector x, Vector y, Vector z) = (frame.ToWorld(new(1, 0, 0)), frame.ToWorld(new(0, 1, 0)), frame.ToWorld(new(0, 0, 1)));
        Bounds all = Bounds.Empty;
        foreach (int shape in shapes)
        {
            ((double lowX, double highX), (double lowY, double highY), (double lowZ, double highZ)) = (_shapes[shape].Along(x), _shapes[shape].Along(y), _shapes[shape].Along(z));
            all = all.With(new(new(lowX, lowY, lowZ), new(highX, highY, highZ)));
        }

        return all;
    }

    private sealed record Node(Frame Frame, Bounds Box, Vector Middle, Node? Low, Node? High, int[] Shapes);
}
