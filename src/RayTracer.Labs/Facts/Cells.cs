namespace RayTracer.Labs;

/// <summary>A rectangle of two coordinates over which a density is given.</summary>
/// <param name="Left">The smallest first coordinate.</param>
/// <param name="Right">The largest first coordinate.</param>
/// <param name="Low">The smallest second coordinate.</param>
/// <param name="High">The largest second coordinate.</param>
public readonly record struct Area(double Left, double Right, double Low, double High)
{
    /// <summary>
    /// The sphere of directions: azimuth, and the cosine with z. Equal areas are equal solid angles there (Archimedes), so that a density per steradian
    /// is one per area.
    /// </summary>
    public static Area Directions { get; } = new(-Math.PI, Math.PI, -1, 1);

    /// <summary>The square around the disk of radius 1.</summary>
    public static Area Disk { get; } = new(-1, 1, -1, 1);

    /// <summary>The square from 0 to 1.</summary>
    public static Area Unit { get; } = new(0, 1, 0, 1);

    internal double Width => Right - Left;

    internal double Height => High - Low;

    internal (double X, double Y) Middle => (0.5 * (Left + Right), 0.5 * (Low + High));

    /// <summary>Where a direction lies in <see cref="Directions"/>.</summary>
    internal static (double X, double Y) Of(Textbook.Vector direction) => (Math.Atan2(direction.Y, direction.X), direction.Z);

    /// <summary>The direction of a place in <see cref="Directions"/>.</summary>
    internal static Textbook.Vector Direction(double azimuth, double cosine)
    {
        double sine = Math.Sqrt(Math.Max(0, 1 - (cosine * cosine)));
        return new(sine * Math.Cos(azimuth), sine * Math.Sin(azimuth), cosine);
    }

    internal Area Part(int column, int row, int columns, int rows) => new(
        Left + (Width * column / columns), Left + (Width * (column + 1) / columns), Low + (Height * row / rows), Low + (Height * (row + 1) / rows));

    internal bool Holds((double X, double Y) at) => at.X >= Left && at.X <= Right && at.Y >= Low && at.Y <= High;
}

/// <summary>
/// Cells of an area that are small where samples are many, so that narrow lobes are seen as well as wide ones. How many samples fall into each is
/// then counted by others than those by which the cells were cut.
/// </summary>
internal sealed class Cells
{
    private const int Columns = 16;
    private const int Rows = 8;
    private const int MostLevels = 12;

    // Of all samples, the share that a cell may have before it is cut into four.
    private const double LargestShare = 1.0 / 150;
    private const int QuadratureLevels = 7;

    // Gauss's and Legendre's rule of three points, from −1 to 1 (Abramowitz & Stegun 1964, table 25.4).
    private static readonly (double At, double Weight)[] s_rule = [(-0.7745966692414834, 5 / 9.0), (0, 8 / 9.0), (0.7745966692414834, 5 / 9.0)];
    private readonly Area _area;
    private readonly List<(Area Area, int FirstPart, int Cell)> _nodes = [];

    /// <summary>Cuts an area.</summary>
    /// <param name="area">The area.</param>
    /// <param name="pilot">Samples.</param>
    public Cells(Area area, IReadOnlyList<(double X, double Y)> pilot)
    {
        _area = area;
        int most = Math.Max(4, (int)(pilot.Count * LargestShare));
        ILookup<int, (double X, double Y)> byRoot = pilot.Where(area.Holds).ToLookup(RootOf);
        for (int root = 0; root < Columns * Rows; root++)
        {
            _nodes.Add((area.Part(root % Columns, root / Columns, Columns, Rows), 0, 0));
        }

        for (int root = 0; root < Columns * Rows; root++)
        {
            Cut(root, [.. byRoot[root]], most, MostLevels);
        }
    }

    /// <summary>The cells.</summary>
    public List<Area> All { get; } = [];

    /// <summary>The number of the cell of a place; −1 outside.</summary>
    public int CellOf((double X, double Y) at)
    {
        if (!_area.Holds(at))
        {
            return -1;
        }

        int node = RootOf(at);
        while (_nodes[node].FirstPart > 0)
        {
            node = _nodes[node].FirstPart + Quarter(_nodes[node].Area, at);
        }

        return _nodes[node].Cell;
    }

    /// <summary>The integral of a density over a cell: halved each way until that changes less than a tolerance.</summary>
    /// <param name="cell">The cell.</param>
    /// <param name="density">The density.</param>
    /// <param name="tolerance">What the integral may be off.</param>
    public static double Integrate(Area cell, Func<double, double, double> density, double tolerance) =>
        Refine(cell, Gauss(cell, density), density, tolerance, QuadratureLevels);

    private static double Refine(Area cell, double whole, Func<double, double, double> density, double tolerance, int levels)
    {
        Span<double> parts = stackalloc double[4];
        double sum = 0;
        for (int i = 0; i < 4; i++)
        {
            parts[i] = Gauss(cell.Part(i & 1, i >> 1, 2, 2), density);
            sum += parts[i];
        }

        if (levels == 0 || Math.Abs(sum - whole) <= tolerance)
        {
            return sum;
        }

        double refined = 0;
        for (int i = 0; i < 4; i++)
        {
            refined += Refine(cell.Part(i & 1, i >> 1, 2, 2), parts[i], density, tolerance / 2, levels - 1);
        }

        return refined;
    }

    private static double Gauss(Area cell, Func<double, double, double> density)
    {
        (double x, double y) = cell.Middle;
        double sum = 0;
        foreach ((double across, double weightX) in s_rule)
        {
            foreach ((double up, double weightY) in s_rule)
            {
                sum += weightX * weightY * density(x + (0.5 * cell.Width * across), y + (0.5 * cell.Height * up));
            }
        }

        return sum * cell.Width * cell.Height / 4;
    }

    private void Cut(int node, List<(double X, double Y)> inside, int most, int levels)
    {
        Area area = _nodes[node].Area;
        if (inside.Count <= most || levels == 0)
        {
            _nodes[node] = (area, 0, All.Count);
            All.Add(area);
            return;
        }

        int first = _nodes.Count;
        _nodes[node] = (area, first, 0);
        ILookup<int, (double X, double Y)> parts = inside.ToLookup(p => Quarter(area, p));
        for (int i = 0; i < 4; i++)
        {
            _nodes.Add((area.Part(i & 1, i >> 1, 2, 2), 0, 0));
        }

        for (int i = 0; i < 4; i++)
        {
            Cut(first + i, [.. parts[i]], most, levels - 1);
        }
    }

    private int RootOf((double X, double Y) at) =>
        (Math.Clamp((int)((at.Y - _area.Low) / _area.Height * Rows), 0, Rows - 1) * Columns) + Math.Clamp((int)((at.X - _area.Left) / _area.Width * Columns), 0, Columns - 1);

    private static int Quarter(Area area, (double X, double Y) at) => (at.X >= area.Middle.X ? 1 : 0) + (at.Y >= area.Middle.Y ? 2 : 0);
}
