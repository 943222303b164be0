namespace RayTracer.Tests.Sampling;

/// <summary>Tests of uniformity and independence of numbers in [0, 1).</summary>
internal static class Dependence
{
    private const int Side = 16;

    /// <summary>p-value of a χ² test of one set of numbers for uniformity.</summary>
    public static double Uniformity(float[] numbers, int cells)
    {
        double[] counts = new double[cells];
        foreach (float u in numbers)
        {
            counts[(int)(u * cells)]++;
        }

        return PValues.ChiSquared(counts, [.. Enumerable.Repeat((double)numbers.Length / cells, cells)]);
    }

    /// <summary>p-value of a χ² test that (a, b) are uniform in the square, which sees dependence of any form.</summary>
    public static double JointUniformity(float[] a, float[] b)
    {
        double[] counts = new double[Side * Side];
        for (int i = 0; i < a.Length; i++)
        {
            counts[((int)(a[i] * Side) * Side) + (int)(b[i] * Side)]++;
        }

        return PValues.ChiSquared(counts, [.. Enumerable.Repeat((double)a.Length / (Side * Side), Side * Side)]);
    }

    /// <summary>p-value of the t test that the correlation of a and b is zero.</summary>
    public static double Correlation(float[] a, float[] b)
    {
        double meanA = a.Average();
        double meanB = b.Average();
        double ab = 0;
        double aa = 0;
        double bb = 0;
        for (int i = 0; i < a.Length; i++)
        {
            ab += (a[i] - meanA) * (b[i] - meanB);
            aa += (a[i] - meanA) * (a[i] - meanA);
            bb += (b[i] - meanB) * (b[i] - meanB);
        }

        double r = ab / Math.Sqrt(aa * bb);
        double freedom = a.Length - 2;
        return PValues.StudentT(Math.Abs(r) * Math.Sqrt(freedom / Math.Max(0, 1 - (r * r))), freedom);
    }

    /// <summary>p-value of all tests of independence of two decisions, coordinate by coordinate.</summary>
    public static double Independence(PathDimension first, DrawnNumbers a, PathDimension second, DrawnNumbers b)
    {
        List<double> p = [];
        foreach (float[] x in a.Coordinates(first))
        {
            foreach (float[] y in b.Coordinates(second))
            {
                p.Add(JointUniformity(x, y));
                p.Add(Correlation(x, y));
            }
        }

        return PValues.Smallest(p);
    }
}
