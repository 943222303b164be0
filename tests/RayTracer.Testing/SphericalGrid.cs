using MathNet.Numerics.Integration;

namespace RayTracer.Testing;

/// <summary>
/// Cells of the sphere of directions, for χ² tests of sampled directions against integrals of their pdf. The cells are rings
/// around an axis, cut by half planes; the rings are as fine at the axis as the lobe there, and evenly spaced where there is none.
/// </summary>
public sealed class SphericalGrid
{
    private const int Rings = 40;
    private const int Sectors = 12;
    private readonly GaussLegendreRule _rule;
    private readonly Vector3D _axis;
    private readonly Vector3D _first;
    private readonly Vector3D _second;
    private readonly double _along;
    private readonly double _up;
    private readonly double _scale;

    /// <summary>Lays the cells.</summary>
    /// <param name="axis">Unit vector: the middle of the lobe.</param>
    /// <param name="normal">Unit normal of the surface, across whose horizon densities may jump; on the axis's side.</param>
    /// <param name="scale">Of the lobe: 1 − cosine at which its density has dropped to about a half.</param>
    /// <param name="points">Points of the quadrature of a cell in each direction.</param>
    public SphericalGrid(Vector3D axis, Vector3D normal, double scale, int points = 8)
    {
        _rule = new(0, 1, points);
        // The sectors are laid from the normal, so that the horizon is symmetric to their borders.
        Vector3D up = normal - (axis * axis.Dot(normal));
        _axis = axis;
        _first = up.Length > 1e-6 ? up.Unit : axis.Perpendicular();
        _second = axis.Cross(_first);
        _along = axis.Dot(normal);
        _up = up.Length;
        _scale = scale;
    }

    /// <summary>Number of cells.</summary>
    public static int Count => Rings * Sectors;

    /// <summary>The cell of a direction.</summary>
    public int CellOf(Vector3D direction)
    {
        // Half the squared distance of unit vectors is 1 − cosine, without cancellation.
        double height = (direction - _axis).Squared / 2;
        double turn = Math.Atan2(direction.Dot(_second), direction.Dot(_first)) / (2 * Math.PI);
        int ring = (int)(Rings * Math.Log(1 + (height / _scale)) / Math.Log(1 + (2 / _scale)));
        int sector = (int)(Sectors * (turn < 0 ? turn + 1 : turn));
        return (Math.Min(ring, Rings - 1) * Sectors) + Math.Min(sector, Sectors - 1);
    }

    /// <summary>Integral of a density over each cell, by Gauss's and Legendre's rule between all borders.</summary>
    /// <param name="density">The density per steradian, smooth but at the horizon and a quarter turn from the axis.</param>
    public double[] Integrate(Func<Vector3D, double> density)
    {
        double[] integrals = new double[Count];
        foreach (GridPoint point in Points())
        {
            integrals[point.Cell] += point.Weight * density(point.Direction);
        }

        return integrals;
    }

    /// <summary>The directions at which a density must be known for its integral over each cell, which is the sum of its values times their weights.</summary>
    public IReadOnlyList<GridPoint> Points()
    {
        List<GridPoint> points = [];
        for (int cell = 0; cell < Count; cell++)
        {
            double from = Angle(cell / Sectors);
            double to = Angle((cell / Sectors) + 1);
            double start = 2 * Math.PI * (cell % Sectors) / Sectors;
            double end = start + (2 * Math.PI / Sectors);
            foreach ((double phi, double width) in Quadrature(start, [Crossing(from), Crossing(to), (2 * Math.PI) - Crossing(from), (2 * Math.PI) - Crossing(to)], end))
            {
                Vector3D side = (_first * Math.Cos(phi)) + (_second * Math.Sin(phi));
                double horizon = Math.Atan2(_along, -_up * Math.Cos(phi));
                foreach ((double theta, double height) in Quadrature(from, [horizon, Math.PI / 2], to))
                {
                    double sine = Math.Sin(theta);
                    points.Add(new(cell, (_axis * Math.Cos(theta)) + (side * sine), width * height * sine));
                }
            }
        }

        return points;
    }

    // The points of an integral in pieces, from one break to the next, and their weights.
    private IEnumerable<(double At, double Weight)> Quadrature(double from, double[] breaks, double to)
    {
        double start = from;
        foreach (double end in breaks.Select(b => Math.Clamp(b, from, to)).Append(to).Order())
        {
            for (int i = 0; start < end && i < _rule.Order; i++)
            {
                yield return (start + ((end - start) * _rule.GetAbscissa(i)), (end - start) * _rule.GetWeight(i));
            }

            start = end;
        }
    }

    // The φ at which the horizon passes an angle to the axis.
    private double Crossing(double theta) =>
        Math.Acos(Math.Clamp(-_along * Math.Cos(theta) / Math.Max(_up * Math.Sin(theta), 1e-30), -1, 1));

    private double Angle(int ring) =>
        2 * Math.Asin(Math.Sqrt(Math.Min(1, _scale * (Math.Pow(1 + (2 / _scale), (double)ring / Rings) - 1) / 2)));
}
