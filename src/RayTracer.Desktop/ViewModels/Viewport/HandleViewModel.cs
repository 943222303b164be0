namespace RayTracer.Desktop.ViewModels;

/// <summary>A handle of the selected shape: a line along an axis, or a ring about it.</summary>
/// <param name="Axis">0 to 2; null for the one in the middle.</param>
/// <param name="Points">Its line on the screen.</param>
/// <param name="Color">Its colour as #rrggbb.</param>
/// <param name="Name">What a screen reader calls it.</param>
internal sealed record HandleViewModel(int? Axis, IReadOnlyList<Spot> Points, string Color, string Name)
{
    /// <summary>How far a point of the screen is from it.</summary>
    public double DistanceTo(Spot point) => Points.Zip(Points.Skip(1)).Select(s => Distance(point, s.First, s.Second)).DefaultIfEmpty(double.PositiveInfinity).Min();

    private static double Distance(Spot point, Spot a, Spot b)
    {
        (double dx, double dy) = (b.X - a.X, b.Y - a.Y);
        double length = (dx * dx) + (dy * dy);
        double t = length > 0 ? Math.Clamp((((point.X - a.X) * dx) + ((point.Y - a.Y) * dy)) / length, 0, 1) : 0;
        return point.DistanceTo(new(a.X + (t * dx), a.Y + (t * dy)));
    }
}
