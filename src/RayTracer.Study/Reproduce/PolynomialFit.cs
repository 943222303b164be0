namespace RayTracer.Study;

/// <summary>
/// A polynomial that comes closest to points by least squares (the least sum of squared distances in y). The columns 1, u, u², …
/// with u = x / max|x| are made orthogonal by the modified Gram–Schmidt process (Björck 1967, "Solving linear least squares
/// problems by Gram–Schmidt orthogonalization", BIT 7), which keeps the accuracy that the normal equations square away.
/// </summary>
internal sealed class PolynomialFit
{
    private PolynomialFit(double[] coefficients) => Coefficients = coefficients;

    /// <summary>The coefficients of 1, x, x², ….</summary>
    public IReadOnlyList<double> Coefficients { get; }

    /// <summary>Fits.</summary>
    /// <param name="degree">The highest power, at least 0.</param>
    /// <param name="points">At least <paramref name="degree"/> + 1 points with different x, not all of them 0.</param>
    /// <exception cref="ArgumentException">There are too few points.</exception>
    public static PolynomialFit Of(int degree, IReadOnlyList<(double X, double Y)> points)
    {
        int terms = degree + 1;
        if (points.DistinctBy(p => p.X).Count() < terms)
        {
            throw new ArgumentException($"A polynomial of degree {degree} needs {terms} points with different x.", nameof(points));
        }

        double scale = points.Max(p => Math.Abs(p.X));
        double[][] columns = Columns(terms, points, scale);
        double[] rest = [.. points.Select(p => p.Y)];
        double[,] r = new double[terms, terms];
        double[] projections = new double[terms];
        for (int k = 0; k < terms; k++)
        {
            r[k, k] = Math.Sqrt(Dot(columns[k], columns[k]));
            columns[k] = [.. columns[k].Select(v => v / r[k, k])];
            for (int j = k + 1; j < terms; j++)
            {
                r[k, j] = TakeAway(columns[j], columns[k]);
            }

            projections[k] = TakeAway(rest, columns[k]);
        }

        return new(Solve(r, projections, scale));
    }

    /// <summary>The polynomial's value.</summary>
    public double At(double x) => Coefficients.Reverse().Aggregate(0.0, (sum, c) => (sum * x) + c);

    /// <summary>
    /// R², the coefficient of determination: 1 where all points lie on the curve, 0 where it explains no more than their mean does.
    /// </summary>
    /// <param name="points">The points; their y are not all the same.</param>
    public double Determination(IReadOnlyList<(double X, double Y)> points)
    {
        double mean = points.Average(p => p.Y);
        double left = points.Sum(p => (p.Y - At(p.X)) * (p.Y - At(p.X)));
        return 1 - (left / points.Sum(p => (p.Y - mean) * (p.Y - mean)));
    }

    private static double[][] Columns(int terms, IReadOnlyList<(double X, double Y)> points, double scale)
    {
        double[][] columns = new double[terms][];
        columns[0] = [.. points.Select(_ => 1.0)];
        for (int k = 1; k < terms; k++)
        {
            columns[k] = [.. columns[k - 1].Zip(points, (power, p) => power * (p.X / scale))];
        }

        return columns;
    }

    // Back substitution; then from u to x.
    private static double[] Solve(double[,] r, double[] projections, double scale)
    {
        double[] solution = new double[projections.Length];
        for (int k = solution.Length - 1; k >= 0; k--)
        {
            double value = projections[k];
            for (int j = k + 1; j < solution.Length; j++)
            {
                value -= r[k, j] * solution[j];
            }

            solution[k] = value / r[k, k];
        }

        double power = 1;
        for (int k = 0; k < solution.Length; k++)
        {
            solution[k] /= power;
            power *= scale;
        }

        return solution;
    }

    // Takes the part along a unit vector away, and says how long that was.
    private static double TakeAway(double[] vector, double[] direction)
    {
        double length = Dot(vector, direction);
        for (int i = 0; i < vector.Length; i++)
        {
            vector[i] -= length * direction[i];
        }

        return length;
    }

    private static double Dot(double[] a, double[] b) => a.Zip(b, (x, y) => x * y).Sum();
}
