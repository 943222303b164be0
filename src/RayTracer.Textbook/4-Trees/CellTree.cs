namespace RayTracer.Textbook;

/// <summary>
/// What kd-tree, octree and quadtree have in common (report, section 3.5): space is cut into cells, and those into smaller ones. A shape is listed in
/// every cell that it reaches into; a ray visits cells in the order in which it enters them, and ends where it has met something nearer than the next.
/// </summary>
public abstract class CellTree : IAccelerator
{
    private const int SmallLeaf = 3;
    private readonly IReadOnlyList<IShape> _shapes;
    private readonly Bounds[] _bounds;
    private readonly Func<Bounds, IReadOnlyList<Bounds>, IReadOnlyList<Bounds>> _cut;
    private readonly Cell _root;
    private readonly double _slack;

    /// <summary>Builds the tree.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="mostLevels">How often cells are cut at most.</param>
    /// <param name="cut">Cuts a cell, in which shapes with some boxes lie, into smaller ones; into none where that is not worth it.</param>
    protected CellTree(IReadOnlyList<IShape> shapes, int mostLevels, Func<Bounds, IReadOnlyList<Bounds>, IReadOnlyList<Bounds>> cut)
    {
        (_shapes, _cut, _bounds) = (shapes, cut, [.. shapes.Select(s => s.Bounds)]);
        Bounds all = _bounds.Aggregate(Bounds.Empty, (box, own) => box.With(own));

        // What touches a cell but for rounding belongs to it.
        _slack = shapes.Count == 0 ? 0 : 1e-9 * (all.Size.Largest + all.Low.Largest + all.High.Largest);
        _root = Build(shapes.Count == 0 ? new(default, default) : all.Grown(_slack), [.. Enumerable.Range(0, shapes.Count)], mostLevels);
    }

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        double begin = 0;
        double end = hit.Distance;
        return _root.Box.Cut(ray, ref begin, ref end) && Visit(_root, ray, ref hit);
    }

    private bool Visit(Cell cell, in Ray ray, ref Hit hit)
    {
        hit.Visits++;
        hit.Watch?.Invoke(cell.Box.Corners, hit.Tests);
        bool isHit = false;
        foreach (int shape in cell.Shapes)
        {
            hit.Tests++;
            if (_shapes[shape].Intersect(ray, ref hit))
            {
                hit.Index = shape;
                isHit = true;
            }
        }

        // The cells inside that the ray meets, by where it enters them.
        Span<(double Begin, int Child)> met = stackalloc (double, int)[cell.Children.Length];
        int count = 0;
        for (int child = 0; child < cell.Children.Length; child++)
        {
            double begin = 0;
            double end = hit.Distance;
            if (cell.Children[child].Box.Cut(ray, ref begin, ref end))
            {
                int at = count++;
                for (; at > 0 && met[at - 1].Begin > begin; at--)
                {
                    met[at] = met[at - 1];
                }

                met[at] = (begin, child);
            }
        }

        for (int i = 0; i < count && met[i].Begin <= hit.Distance; i++)
        {
            isHit |= Visit(cell.Children[met[i].Child], ray, ref hit);
        }

        return isHit;
    }

    private Cell Build(Bounds box, int[] shapes, int levels)
    {
        if (shapes.Length <= SmallLeaf || levels == 0)
        {
            return new(box, [], shapes);
        }

        Bounds[] smaller = [.. _cut(box, Array.ConvertAll(shapes, s => _bounds[s])).Select(b => b.Grown(_slack))];
        int[][] listed = Array.ConvertAll(smaller, b => Array.FindAll(shapes, s => Overlaps(b, _bounds[s])));
        bool isWorthIt = smaller.Length > 0 && !Array.Exists(listed, l => l.Length == shapes.Length && Array.TrueForAll(listed, o => o.Length > 0));
        return isWorthIt ? new(box, [.. smaller.Zip(listed, (b, l) => Build(b, l, levels - 1))], []) : new(box, [], shapes);
    }

    private static bool Overlaps(Bounds a, Bounds b) =>
        a.Low.X <= b.High.X && b.Low.X <= a.High.X && a.Low.Y <= b.High.Y && b.Low.Y <= a.High.Y && a.Low.Z <= b.High.Z && b.Low.Z <= a.High.Z;

    /// <summary>The two halves of a box.</summary>
    /// <param name="box">The box.</param>
    /// <param name="axis">The axis that is cut.</param>
    /// <param name="at">Where.</param>
    protected static (Bounds Below, Bounds Above) Halves(Bounds box, int axis, double at) =>
        (box with { High = Put(box.High, axis, at) }, box with { Low = Put(box.Low, axis, at) });

    private static Vector Put(Vector v, int axis, double value) => axis == 0 ? v with { X = value } : axis == 1 ? v with { Y = value } : v with { Z = value };

    // A leaf has shapes, another cell has children.
    private sealed record Cell(Bounds Box, Cell[] Children, int[] Shapes);
}
