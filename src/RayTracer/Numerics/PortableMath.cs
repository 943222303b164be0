namespace RayTracer.Numerics;

/// <summary>Transcendental functions in double precision from + − × ÷ alone, so that their bits are the same on every machine.</summary>
internal static class PortableMath
{
    private const double Ln2 = 0.69314718055994530942;

    /// <summary>The fifth root of x ≥ 0 to within 2 ulp; below 1e-300 it is 0.</summary>
    public static double FifthRoot(double x)
    {
        if (!(x >= 1e-300))
        {
            return 0;
        }

        // A fifth of the exponent and mantissa bits is within 4 % of the root; Newton's steps then square that error.
        const long FourFifthsOfOne = 0x3FF0000000000000 / 5 * 4;
        double root = BitConverter.Int64BitsToDouble((BitConverter.DoubleToInt64Bits(x) / 5) + FourFifthsOfOne);
        for (int step = 0; step < 5; step++)
        {
            double square = root * root;
            root -= (root - (x / (square * square))) / 5;
        }

        return root;
    }

    /// <summary>The binary logarithm of a normal x &gt; 0, to within 1e-15.</summary>
    public static double Log2(double x)
    {
        // x = m·2ᵉ with m in [√½, √2), and ln m = 2 artanh((m − 1)/(m + 1)).
        int exponent = Math.ILogB(x);
        double m = Math.ScaleB(x, -exponent);
        if (m > 1.4142135623730951)
        {
            m /= 2;
            exponent++;
        }

        double z = (m - 1) / (m + 1);
        double square = z * z;
        double sum = 0;
        for (int k = 21; k >= 1; k -= 2)
        {
            sum = (sum * square) + (1.0 / k);
        }

        return exponent + (2 / Ln2 * z * sum);
    }

    /// <summary>2ˣ to within 2 ulp, and exact for whole x.</summary>
    public static double Exp2(double x)
    {
        double whole = Math.Round(x);
        double t = (x - whole) * Ln2;
        double sum = 1;
        for (int k = 18; k >= 1; k--)
        {
            sum = (sum * t / k) + 1;
        }

        return Math.ScaleB(sum, (int)whole);
    }
}
