namespace RayTracer.Textbook;

/// <summary>
/// Space in cells of equal size, about as many as there are shapes (report, section 6.1; Fujimoto, Tanaka &amp; Iwata 1986). A ray steps from cell to cell:
/// along each axis it is known where it meets the next wall, and the nearest of the three comes first (Amanatides &amp; Woo 1987).
/// </summary>
public sealed class UniformGrid : IAccelerator
{
    private const double CellsPerShape = 3;
    private const int MostAlongAxis = 512;
    private readonly IReadOnlyList<IShape> _shapes;
    private readonly Bounds _bounds;
    private readonly int[] _counts = [1, 1, 1];
    private readonly List<int>?[] _cells;

    /// <summary>Puts the shapes into cells.</summary>
    /// <param name="shapes">The shapes.</param>
    public UniformGrid(IReadOnlyList<IShape> shapes)
    {
        _shapes = shapes;
        Bounds all = shapes.Count == 0 ? new(default, default) : shapes.Select(s => s.Bounds).Aggregate((a, b) => a.With(b));
        double slack = 1e-9 * (all.Size.Largest + all.Low.Largest + all.High.Largest);
        _bounds = all.Grown(slack);

        // Cubes, as nearly as that goes; of what is flat, squares.
        double[] sides = [.. Enumerable.Range(0, 3).Select(a => _bounds.Size[a]).Where(s => s > 1e-6 * _bounds.Size.Largest)];
        double cube = sides.Length == 0 ? 1 : Math.Pow(sides.Aggregate(1.0, (product, side) => product * side) / (CellsPerShape * Math.Max(1, shapes.Count)), 1.0 / sides.Length);
        for (int axis = 0; axis < 3; axis++)
        {
            _counts[axis] = (int)Math.Clamp(Math.Ceiling(_bounds.Size[axis] / cube), 1, MostAlongAxis);
        }

        _cells = new List<int>?[_counts[0] * _counts[1] * _counts[2]];
        for (int i = 0; i < shapes.Count; i++)
        {
            Put(i, shapes[i].Bounds.Grown(slack));
        }
    }

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        double begin = 0;
        double end = hit.Distance;
        if (_shapes.Count == 0 || !_bounds.Cut(ray, ref begin, ref end))
        {
            return false;
        }

        // For each axis: the cell, the step to the next, where its wall is met, and how far apart walls are.
        Span<int> cell = stackalloc int[3];
        Span<int> step = stackalloc int[3];
        Span<double> wall = stackalloc double[3];
        Span<double> apart = stackalloc double[3];
        Vector start = ray.At(begin);
        for (int axis = 0; axis < 3; axis++)
        {
            double direction = ray.Direction[axis];
            cell[axis] = CellOf(axis, start[axis]);
            step[axis] = direction < 0 ? -1 : 1;
            double size = _bounds.Size[axis] / _counts[axis];
            double next = _bounds.Low[axis] + ((cell[axis] + (direction < 0 ? 0 : 1)) * size);
            wall[axis] = direction == 0 ? double.PositiveInfinity : (next - ray.Origin[axis]) / direction;
            apart[axis] = direction == 0 ? double.PositiveInfinity : size / Math.Abs(direction);
        }

        bool isHit = false;
        while (true)
        {
            hit.Visits++;
            hit.Watch?.Invoke(BoxOf(cell).Corners, hit.Tests);
            isHit |= Test(cell, ray, ref hit);
            int axis = wall[0] <= wall[1] && wall[0] <= wall[2] ? 0 : wall[1] <= wall[2] ? 1 : 2;
            cell[axis] += step[axis];
            if (wall[axis] > Math.Min(end, hit.Distance) || (uint)cell[axis] >= (uint)_counts[axis])
            {
                return isHit;
            }

            wall[axis] += apart[axis];
        }
    }

    private Bounds BoxOf(Span<int> cell)
    {
        Vector size = new(_bounds.Size.X / _counts[0], _bounds.Size.Y / _counts[1], _bounds.Size.Z / _counts[2]);
        Vector low = _bounds.Low + new Vector(cell[0] * size.X, cell[1] * size.Y, cell[2] * size.Z);
        return new(low, low + size);
    }

    private bool Test(Span<int> cell, in Ray ray, ref Hit hit)
    {
        bool isHit = false;
        foreach (int shape in _cells[Number(cell[0], cell[1], cell[2])] ?? [])
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

    private void Put(int shape, Bounds box)
    {
        for (int z = CellOf(2, box.Low.Z); z <= CellOf(2, box.High.Z); z++)
        {
            for (int y = CellOf(1, box.Low.Y); y <= CellOf(1, box.High.Y); y++)
            {
                for (int x = CellOf(0, box.Low.X); x <= CellOf(0, box.High.X); x++)
                {
                    (_cells[Number(x, y, z)] ??= []).Add(shape);
                }
            }
        }
    }

    private int CellOf(int axis, double at) => (int)Math.Clamp((at - _bounds.Low[axis]) / _bounds.Size[axis] * _counts[axis], 0, _counts[axis] - 1);

    private int Number(int x, int y, int z) => (((z * _counts[1]) + y) * _counts[0]) + x;
}
