using System.Numerics;

namespace RayTracer.Import;

/// <summary>
/// Cuts polygons into triangles: convex ones like a fan, others ear by ear (Meisters 1975) in the plane that Newell's normal
/// (Sutherland et al. 1974) faces most.
/// </summary>
internal sealed class PolygonCutter
{
    // Corners that are tried, and tests of points against their ears, for all polygons together: ears of very large, very jagged ones would take for ever.
    private const long MostTests = 100_000_000;

    private readonly List<(double X, double Y)> _plane = [];
    private readonly List<int> _next = [];
    private readonly List<int> _previous = [];
    private readonly List<int> _reflex = [];
    private long _testsLeft = MostTests;

    /// <summary>Polygons that were cut like a fan though they are not convex, because they are no simple polygons or too large.</summary>
    public int Unresolved { get; private set; }

    /// <summary>Cuts a polygon.</summary>
    /// <param name="corners">Its corners, in order.</param>
    /// <param name="triangles">Receives three places of corners for each of the Count − 2 triangles, in the same order around.</param>
    public void Cut(ReadOnlySpan<Vector3> corners, List<int> triangles)
    {
        triangles.Clear();
        if (corners.Length <= 3 || !Flatten(corners) || FindReflex() == 0)
        {
            Fan(corners.Length, triangles);
            return;
        }

        CutEars(corners.Length, triangles);
    }

    private static void Fan(int count, List<int> triangles)
    {
        for (int i = 2; i < count; i++)
        {
            triangles.AddRange([0, i - 1, i]);
        }
    }

    // Leaves out the axis that the normal is nearest to, so that the polygon is seen counter-clockwise; false where it has no area.
    private bool Flatten(ReadOnlySpan<Vector3> corners)
    {
        (double x, double y, double z) = (0, 0, 0);
        Vector3 last = corners[^1];
        foreach (Vector3 c in corners)
        {
            x += ((double)last.Y - c.Y) * ((double)last.Z + c.Z);
            y += ((double)last.Z - c.Z) * ((double)last.X + c.X);
            z += ((double)last.X - c.X) * ((double)last.Y + c.Y);
            last = c;
        }

        (double ax, double ay, double az) = (double.Abs(x), double.Abs(y), double.Abs(z));
        double largest = double.Max(ax, double.Max(ay, az));
        if (!(largest > 0) || !double.IsFinite(largest))
        {
            return false;
        }

        _plane.Clear();
        foreach (Vector3 c in corners)
        {
            (double u, double v, double side) = largest == ax ? (c.Y, c.Z, x) : largest == ay ? (c.Z, c.X, y) : ((double)c.X, (double)c.Y, z);
            _plane.Add(side > 0 ? (u, v) : (v, u));
        }

        return true;
    }

    // Links all corners to a ring; returns the number of those that point inwards.
    private int FindReflex()
    {
        int count = _plane.Count;
        _next.Clear();
        _previous.Clear();
        _reflex.Clear();
        for (int i = 0; i < count; i++)
        {
            _next.Add((i + 1) % count);
            _previous.Add((i + count - 1) % count);
        }

        for (int i = 0; i < count; i++)
        {
            if (Turn(_previous[i], i, _next[i]) < 0)
            {
                _reflex.Add(i);
            }
        }

        return _reflex.Count;
    }

    private void CutEars(int count, List<int> triangles)
    {
        int corner = 0;
        int tried = 0;
        bool isResolved = true;
        while (count > 3)
        {
            (int before, int after) = (_previous[corner], _next[corner]);
            double turn = Turn(before, corner, after);
            _testsLeft--;
            bool isEar = turn > 0 && _testsLeft > 0 && IsFree(before, corner, after);
            if (!isEar && tried < count && _testsLeft > 0)
            {
                tried++;
                corner = after;
                continue;
            }

            // Where no ear is left, the polygon cuts itself or is flat there: any triangle serves.
            isResolved &= isEar || turn == 0;
            triangles.AddRange([before, corner, after]);
            (_next[before], _previous[after]) = (after, before);
            count--;
            tried = 0;
            corner = _next[after];
        }

        triangles.AddRange([_previous[corner], corner, _next[corner]]);
        Unresolved += isResolved ? 0 : 1;
    }

    // Only corners that point inwards can lie in an ear; those that were cut off, or do not point inwards any more, do no harm.
    private bool IsFree(int a, int b, int c)
    {
        _testsLeft -= _reflex.Count;
        foreach (int p in _reflex)
        {
            if (p != a && p != b && p != c && _next[_previous[p]] == p && !IsOneOf(p, a, b, c) && Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0)
            {
                return false;
            }
        }

        return true;
    }

    // Holes are often joined to the outline by a bridge, whose corners come twice.
    private bool IsOneOf(int p, int a, int b, int c) => _plane[p] == _plane[a] || _plane[p] == _plane[b] || _plane[p] == _plane[c];

    // Twice the area of a triangle; above zero where it is seen counter-clockwise.
    private double Turn(int a, int b, int c) =>
        ((_plane[b].X - _plane[a].X) * (_plane[c].Y - _plane[a].Y)) - ((_plane[b].Y - _plane[a].Y) * (_plane[c].X - _plane[a].X));
}
