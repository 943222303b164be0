namespace RayTracer.Sampling;

/// <summary>
/// Generator matrices of Sobol's sequence. Direction numbers: Joe &amp; Kuo, Constructing Sobol sequences with better
/// two-dimensional projections (SIAM J. Sci. Comput. 30, 2008), the first four dimensions of "new-joe-kuo-6".
/// </summary>
internal static class SobolMatrix
{
    // Degree s and coefficients a of the primitive polynomial, and the first s direction numbers, from dimension 1 on.
    private static readonly (int Degree, uint Coefficients, uint[] Initial)[] s_polynomials =
    [
        (1, 0, [1]),
        (2, 1, [1, 3]),
        (3, 1, [1, 3, 1]),
    ];

    /// <summary>Number of dimensions that there are matrices for.</summary>
    public static int Dimensions => s_polynomials.Length + 1;

    /// <summary>
    /// The 32 columns of a dimension's matrix over GF(2): column k is what binary digit k of the index contributes to
    /// the point. Bit i of a column is the point's binary digit i after the point (so digits are reversed against a fraction's bits).
    /// </summary>
    /// <param name="dimension">The dimension, from 0.</param>
    public static uint[] Columns(int dimension)
    {
        uint[] columns = new uint[32];
        for (int k = 0; k < 32; k++)
        {
            columns[k] = dimension == 0 ? 1u << k : Reverse(DirectionNumbers(dimension)[k]);
        }

        return columns;
    }

    // v_k as 32-bit fractions by the recurrence of Joe & Kuo (2008), eq. 2.
    private static uint[] DirectionNumbers(int dimension)
    {
        (int degree, uint coefficients, uint[] initial) = s_polynomials[dimension - 1];
        uint[] v = new uint[32];
        for (int k = 0; k < 32; k++)
        {
            if (k < degree)
            {
                v[k] = initial[k] << (31 - k);
                continue;
            }

            v[k] = v[k - degree] ^ (v[k - degree] >> degree);
            for (int j = 1; j < degree; j++)
            {
                if ((coefficients >> (degree - 1 - j) & 1) != 0)
                {
                    v[k] ^= v[k - j];
                }
            }
        }

        return v;
    }

    private static uint Reverse(uint x)
    {
        uint reversed = 0;
        for (int bit = 0; bit < 32; bit++)
        {
            reversed |= (x >> bit & 1) << (31 - bit);
        }

        return reversed;
    }
}
