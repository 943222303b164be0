namespace RayTracer.Textbook;

/// <summary>
/// Every cell is cut in the middle along its two longest sides, into four (report, section 3.5; Finkel &amp; Bentley 1974): enough for landscapes and cities,
/// which lie in a plane.
/// </summary>
/// <param name="shapes">The shapes.</param>
public sealed class Quadtree(IReadOnlyList<IShape> shapes) : CellTree(shapes, mostLevels: 12, Cut)
{
    private static IReadOnlyList<Bounds> Cut(Bounds cell, IReadOnlyList<Bounds> shapes)
    {
        int longest = cell.LongestAxis;
        int second = cell.Size[(longest + 1) % 3] >= cell.Size[(longest + 2) % 3] ? (longest + 1) % 3 : (longest + 2) % 3;
        (Bounds below, Bounds above) = Halves(cell, longest, cell.Middle[longest]);
        (Bounds a, Bounds b) = Halves(below, second, cell.Middle[second]);
        (Bounds c, Bounds d) = Halves(above, second, cell.Middle[second]);
        return [a, b, c, d];
    }
}
