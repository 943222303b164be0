namespace RayTracer.Textbook;

/// <summary>
/// Space is cut in two by planes in any direction (report, section 3.5; Fuchs, Kedem &amp; Naylor, On visible surface generation by a priori tree
/// structures, 1980). From any point, all that is on its side of a plane comes before all that is beyond: rays go through the tree from front to back.
/// </summary>
public sealed class BspTree : IAccelerator
{
    private const int SmallLeaf = 3;
    private readonly IReadOnlyList<IShape> _shapes;
    private readonly Bounds _bounds;
    private readonly double _slack;
    private readonly Node _root;

    /// <summary>Builds the tree.</summary>
    /// <param name="shapes">The shapes.</param>
    public BspTree(IReadOnlyList<IShape> shapes)
    {
        _shapes = shapes;
        _bounds = shapes.Select(s => s.Bounds).Aggregate(Bounds.Empty, (all, own) => all.With(own));
        _slack = shapes.Count == 0 ? 0 : 1e-9 * (_bounds.Size.Largest + _bounds.Low.Largest + _bounds.High.Largest);
        _root = Build([.. Enumerable.Range(0, shapes.Count)], 8 + (int)(1.3 * Math.Log2(shapes.Count + 1)));
    }

    /// <summary>The directions that planes may face: along the axes, and along the diagonals of a cube's faces and of the cube.</summary>
    internal static IReadOnlyList<Vector> Directions { get; } =
    [
        .. from x in new[] { -1, 0, 1 }
           from y in new[] { -1, 0, 1 }
           from z in new[] { -1, 0, 1 }
           where (9 * x) + (3 * y) + z > 0
           select new Vector(x, y, z).Unit,
    ];

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        double begin = 0;
        double end = hit.Distance;
        return _shapes.Count > 0 && _bounds.Grown(_slack).Cut(ray, ref begin, ref end) && Visit(_root, ray, begin, end, ref hit);
    }

    // Where a node's plane cuts the box around all, corner after corner; nothing for a leaf.
    private Vector[] Polygon(Node node)
    {
        if (node.Behind is null)
        {
            return [];
        }

        Vector[] corners = _bounds.Corners;
        double[] heights = Array.ConvertAll(corners, c => Vector.Dot(c, node.Normal) - node.At);
        Frame plane = new(node.Normal);
        Vector[] cuts =
        [
            .. from i in Enumerable.Range(0, 8)
               from axis in new[] { 1, 2, 4 }
               where (i & axis) == 0 && heights[i] * heights[i | axis] < 0
               select corners[i] + ((heights[i] / (heights[i] - heights[i | axis])) * (corners[i | axis] - corners[i])),
        ];
        Vector middle = cuts.Aggregate(default(Vector), (sum, c) => sum + c) * (1.0 / Math.Max(1, cuts.Length));
        return [.. cuts.OrderBy(c => plane.ToLocal(c - middle) is var v ? Math.Atan2(v.Y, v.X) : 0)];
    }

    private bool Visit(Node node, in Ray ray, double begin, double end, ref Hit hit)
    {
        hit.Visits++;
        hit.Watch?.Invoke(Polygon(node), hit.Tests);
        bool isHit = false;
        if (node.Behind is null)
        {
            foreach (int shape in node.Shapes)
            {
                hit.Tests++;
                if (_shapes[shape].Intersect(ray, ref hit))
                {
                    hit.Index = shape;
                    isHit = true;
                }
            }

            return isHit;
        }

        // Where the ray crosses the plane; the side that it is on before is the one to look at first.
        double height = node.At - Vector.Dot(ray.Origin, node.Normal);
        double rise = Vector.Dot(ray.Direction, node.Normal);
        double crossing = height / rise;
        bool startsBehind = height > 0 || (height == 0 && rise <= 0);
        (Node near, Node far) = startsBehind ? (node.Behind, node.Front!) : (node.Front!, node.Behind);
        double slack = (_slack + (1e-12 * Math.Abs(height))) / Math.Abs(rise);
        bool crosses = Math.Abs(rise) > 1e-14 ? crossing > -slack : Math.Abs(height) <= _slack;
        if (!crosses || crossing - slack > end)
        {
            return Visit(near, ray, begin, end, ref hit);
        }

        if (!(crossing + slack < begin))
        {
            isHit = Visit(near, ray, begin, Math.Min(end, crossing + slack), ref hit);
        }

        double from = Math.Abs(rise) > 1e-14 ? Math.Max(begin, crossing - slack) : begin;
        return (from <= hit.Distance && Visit(far, ray, from, end, ref hit)) || isHit;
    }

    private Node Build(int[] shapes, int levels)
    {
        if (shapes.Length <= SmallLeaf || levels == 0)
        {
            return Leaf(shapes);
        }

        // Of the planes at the middle shape along each direction, the one whose larger side has the fewest shapes.
        (Vector Normal, double At, int Larger) best = (default, 0, shapes.Length);
        foreach (Vector normal in Directions)
        {
            (double Low, double High)[] reaches = Array.ConvertAll(shapes, s => _shapes[s].Along(normal));
            double[] middles = Array.ConvertAll(reaches, r => 0.5 * (r.Low + r.High));
            Array.Sort(middles);
            double at = middles[middles.Length / 2];
            int larger = Math.Max(reaches.Count(r => r.Low <= at), reaches.Count(r => r.High >= at));
            best = larger < best.Larger ? (normal, at, larger) : best;
        }

        if (best.Larger == shapes.Length)
        {
            return Leaf(shapes);
        }

        // A shape on both sides is listed on both.
        int[] behind = Array.FindAll(shapes, s => _shapes[s].Along(best.Normal).Low <= best.At + _slack);
        int[] front = Array.FindAll(shapes, s => _shapes[s].Along(best.Normal).High >= best.At - _slack);
        return new(best.Normal, best.At, Build(behind, levels - 1), Build(front, levels - 1), []);
    }

    private static Node Leaf(int[] shapes) => new(default, 0, null, null, shapes);

    private sealed record Node(Vector Normal, double At, Node? Behind, Node? Front, int[] Shapes);
}
