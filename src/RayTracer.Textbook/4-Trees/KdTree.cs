namespace RayTracer.Textbook;

/// <summary>
/// Every cell is cut in two by a plane across an axis (report, section 3.5; Bentley 1975), wherever the surface area heuristic expects the least work
/// (MacDonald &amp; Booth 1990).
/// </summary>
/// <param name="shapes">The shapes.</param>
public sealed class KdTree(IReadOnlyList<IShape> shapes) : CellTree(shapes, MostLevels(shapes.Count), Cut)
{
    // Where a test costs 1.
    private const double VisitCost = 1;
    private const int Candidates = 16;

    private static int MostLevels(int count) => 8 + (int)(1.3 * Math.Log2(count + 1));

    private static IReadOnlyList<Bounds> Cut(Bounds cell, IReadOnlyList<Bounds> shapes)
    {
        IReadOnlyList<Bounds> best = [];
        double least = shapes.Count;
        for (int axis = 0; axis < 3; axis++)
        {
            for (int i = 1; i < Candidates; i++)
            {
                double at = cell.Low[axis] + (cell.Size[axis] * i / Candidates);
                (Bounds below, Bounds above) = Halves(cell, axis, at);
                (int onBelow, int onAbove) = (0, 0);
                foreach (Bounds shape in shapes)
                {
                    onBelow += shape.Low[axis] <= at ? 1 : 0;
                    onAbove += shape.High[axis] >= at ? 1 : 0;
                }

                double cost = VisitCost + (((below.Area * onBelow) + (above.Area * onAbove)) / cell.Area);
                if (cost < least)
                {
                    (best, least) = ([below, above], cost);
                }
            }
        }

        return best;
    }
}
