namespace RayTracer.RenderTests.Analytic;

/// <summary>Exact areas of polygons in the picture.</summary>
internal static class Polygon
{
    /// <summary>The part of a pixel that a convex polygon covers: its clipped area by the shoelace formula.</summary>
    public static double Coverage(IReadOnlyList<(double X, double Y)> corners, int x, int y)
    {
        IReadOnlyList<(double X, double Y)> part = Clip(corners, p => p.X - x);
        part = Clip(part, p => x + 1 - p.X);
        part = Clip(part, p => p.Y - y);
        part = Clip(part, p => y + 1 - p.Y);
        double area = 0;
        for (int i = 0; i < part.Count; i++)
        {
            ((double ax, double ay), (double bx, double by)) = (part[i], part[(i + 1) % part.Count]);
            area += ((ax - x) * (by - y)) - ((bx - x) * (ay - y));
        }

        return Math.Abs(area) / 2;
    }

    // The part of a convex polygon where a linear function is positive.
    private static List<(double X, double Y)> Clip(IReadOnlyList<(double X, double Y)> corners, Func<(double X, double Y), double> inside)
    {
        List<(double X, double Y)> kept = [];
        for (int i = 0; i < corners.Count; i++)
        {
            (double X, double Y) a = corners[i];
            (double X, double Y) b = corners[(i + 1) % corners.Count];
            (double da, double db) = (inside(a), inside(b));
            if (da >= 0)
            {
                kept.Add(a);
            }

            if (da * db < 0)
            {
                double t = da / (da - db);
                kept.Add((a.X + (t * (b.X - a.X)), a.Y + (t * (b.Y - a.Y))));
            }
        }

        return kept;
    }
}
