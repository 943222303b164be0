namespace Lab2;

/// <summary>Where rays meet boxes whose edges are parallel to the axes.</summary>
public static class Box
{
    /// <summary>Finds where a ray enters a box: between two planes for each axis, so that it is inside where all three intervals overlap (Kay and Kajiya 1986).</summary>
    /// <param name="box">The box, from its corner Low to its corner High.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="end">The t from which on nothing counts.</param>
    /// <returns>The t at which it enters, 0 where it starts inside; null where it misses the box, or meets it only before 0 or beyond the end.</returns>
    public static double? Enter(Bounds box, Ray ray, double end)
    {
        //? Box.Enter: for each axis, the t of both planes; the smaller one is where the ray may begin to be inside, the larger one where it ends.
        double begin = 0;
        for (int axis = 0; axis < 3; axis++)
        {
            double low = (box.Low[axis] - ray.Origin[axis]) / ray.Direction[axis];
            double high = (box.High[axis] - ray.Origin[axis]) / ray.Direction[axis];
            begin = Math.Max(begin, Math.Min(low, high));
            end = Math.Min(end, Math.Max(low, high));
        }

        return begin <= end ? begin : null;
        //!
    }
}
