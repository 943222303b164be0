using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>The error of a picture against the number of its samples.</summary>
/// <param name="Points">The error after 1, 2, 4 … samples.</param>
/// <param name="Slope">By what power of the number of samples it shrinks, fitted to the points; the theory of independent samples says
/// −0.5. Null below two points.</param>
public sealed record Convergence(IReadOnlyList<ConvergencePoint> Points, double? Slope)
{
    /// <summary>
    /// The errors of earlier pictures, against the newest one. Its samples hold those of the earlier ones, so the mean square of the
    /// difference is
    /// σ²·(1/k − 1/n), and the error σ²/k of the earlier one is n/(n − k) times as much.
    /// </summary>
    /// <param name="earlier">Earlier pictures, and how many samples they had.</param>
    /// <param name="newest">The newest picture.</param>
    /// <param name="samples">The number of samples of each of its pixels.</param>
    public static Convergence Of(IEnumerable<(int Samples, Rgb[] Means)> earlier, Rgb[] newest, int samples)
    {
        List<ConvergencePoint> points = [];
        foreach ((int count, Rgb[] means) in earlier.Where(e => e.Samples < samples))
        {
            double sum = 0;
            for (int i = 0; i < newest.Length; i++)
            {
                sum += Square(means[i].R - newest[i].R) + Square(means[i].G - newest[i].G) + Square(means[i].B - newest[i].B);
            }

            double owns = samples / (double)(samples - count);
            points.Add(new(count, Math.Sqrt(sum / (3.0 * newest.Length) * owns)));
        }

        return new(points, SlopeOf([.. points.Where(p => p.Error > 0)]));
    }

    // Least squares through the logarithms.
    private static double? SlopeOf(ConvergencePoint[] points)
    {
        if (points.Length < 2)
        {
            return null;
        }

        double[] x = [.. points.Select(p => (double)LaneMath.Log(p.Samples))];
        double[] y = [.. points.Select(p => (double)LaneMath.Log((float)p.Error))];
        (double middleX, double middleY) = (x.Average(), y.Average());
        return x.Zip(y).Sum(p => (p.First - middleX) * (p.Second - middleY)) / x.Sum(v => Square(v - middleX));
    }

    private static double Square(double v) => v * v;
}

/// <summary>The error of a picture.</summary>
/// <param name="Samples">Samples in each pixel.</param>
/// <param name="Error">Root of the mean square error over pixels and channels.</param>
public readonly record struct ConvergencePoint(int Samples, double Error);
