using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>
/// SSIM of two images given row by row (Wang, Bovik, Sheikh, Simoncelli 2004): Gaussian windows of 11×11 pixels, σ = 1.5, that lie wholly
/// inside; K₁ = 0.01, K₂ = 0.03, and a range of 1, on the luma (Rec. 709 weights) of sRGB-encoded channels.
/// </summary>
internal sealed class StructuralSimilarity
{
    private const int Size = 11;

    // What a window needs: means of x, y, x², y² and xy.
    private const int Moments = 5;

    private static readonly double[] Weights = GaussianWeights();

    private readonly int _width;
    private readonly double[] _lumaA;
    private readonly double[] _lumaB;

    // The last 11 rows, filtered along x, in a ring.
    private readonly double[][] _filtered;
    private int _rows;
    private double _sum;

    public StructuralSimilarity(int width)
    {
        _width = width;
        _lumaA = new double[width];
        _lumaB = new double[width];
        int windows = Math.Max(0, width - Size + 1);
        _filtered = [.. Enumerable.Range(0, Size).Select(_ => new double[Moments * windows])];
    }

    /// <summary>The mean over all windows; NaN if there is none.</summary>
    public double Mean => _sum / ((double)(_filtered[0].Length / Moments) * Math.Max(0, _rows - Size + 1));

    /// <summary>Adds the next row of each image: finite linear RGB.</summary>
    public void Add(ReadOnlySpan<float> a, ReadOnlySpan<float> b)
    {
        for (int x = 0; x < _width; x++)
        {
            _lumaA[x] = Luma(a.Slice(3 * x, 3));
            _lumaB[x] = Luma(b.Slice(3 * x, 3));
        }

        double[] row = _filtered[_rows % Size];
        for (int x = 0; x < row.Length / Moments; x++)
        {
            FilterAlongX(x, row.AsSpan(Moments * x, Moments));
        }

        _rows++;
        if (_rows >= Size)
        {
            AddWindows();
        }
    }

    private static double Luma(ReadOnlySpan<float> rgb) =>
        ((0.2126 * SrgbCurve.Encode16(rgb[0])) + (0.7152 * SrgbCurve.Encode16(rgb[1])) + (0.0722 * SrgbCurve.Encode16(rgb[2]))) / 65535;

    private void FilterAlongX(int x, Span<double> moments)
    {
        moments.Clear();
        for (int i = 0; i < Size; i++)
        {
            double a = _lumaA[x + i];
            double b = _lumaB[x + i];
            double weight = Weights[i];
            moments[0] += weight * a;
            moments[1] += weight * b;
            moments[2] += weight * a * a;
            moments[3] += weight * b * b;
            moments[4] += weight * a * b;
        }
    }

    private void AddWindows()
    {
        Span<double> m = stackalloc double[Moments];
        for (int x = 0; x < _filtered[0].Length; x += Moments)
        {
            m.Clear();
            for (int i = 0; i < Size; i++)
            {
                // _rows is one past the newest row, so in the ring it is the oldest one.
                double[] row = _filtered[(_rows + i) % Size];
                for (int k = 0; k < Moments; k++)
                {
                    m[k] += Weights[i] * row[x + k];
                }
            }

            _sum += Similarity(m[0], m[1], m[2] - (m[0] * m[0]), m[3] - (m[1] * m[1]), m[4] - (m[0] * m[1]));
        }
    }

    // Equation 13.
    private static double Similarity(double meanA, double meanB, double varianceA, double varianceB, double covariance)
    {
        const double C1 = 0.01 * 0.01;
        const double C2 = 0.03 * 0.03;
        return ((2 * meanA * meanB) + C1) * ((2 * covariance) + C2)
            / (((meanA * meanA) + (meanB * meanB) + C1) * (varianceA + varianceB + C2));
    }

    private static double[] GaussianWeights()
    {
        const double Sigma = 1.5;
        const double Log2OfE = 1.4426950408889634;
        var weights = new double[Size];
        for (int i = 0; i < Size; i++)
        {
            double distance = i - (Size / 2);
            weights[i] = PortableMath.Exp2(-distance * distance / (2 * Sigma * Sigma) * Log2OfE);
        }

        double sum = weights.Sum();
        return [.. weights.Select(weight => weight / sum)];
    }
}
