namespace RayTracer.Textbook;

/// <summary>Every cell is cut in the middle, along all three axes, into eight (Glassner, Space subdivision for fast ray tracing, 1984).</summary>
/// <param name="shapes">The shapes.</param>
public sealed class Octree(IReadOnlyList<IShape> shapes) : CellTree(shapes, mostLevels: 10, Cut)
{
    private static IReadOnlyList<Bounds> Cut(Bounds cell, IReadOnlyList<Bounds> shapes)
    {
        IEnumerable<Bounds> cells = [cell];
        for (int axis = 0; axis < 3; axis++)
        {
            int along = axis;
            cells = [.. cells.Select(c => Halves(c, along, c.Middle[along])).SelectMany(h => new[] { h.Below, h.Above })];
        }

        return [.. cells];
    }
}
