namespace RayTracer.Imaging;

/// <summary>The wavelet transform of the compression PIZ, undone: sums and differences of neighbours, from the coarsest on.</summary>
internal static class PizWavelet
{
    private const int FourteenBits = 1 << 14;

    /// <summary>Undoes the transform of one channel in place.</summary>
    /// <param name="data">The numbers.</param>
    /// <param name="begin">The index of the first one.</param>
    /// <param name="width">Numbers in a row.</param>
    /// <param name="stepX">From one to the next.</param>
    /// <param name="height">Number of rows.</param>
    /// <param name="stepY">From one row to the next.</param>
    /// <param name="largest">The largest number before the transform: small ones take fewer bits.</param>
    public static void Decode(Span<ushort> data, int begin, int width, int stepX, int height, int stepY, int largest)
    {
        bool isSmall = largest < FourteenBits;
        int coarse = 1;
        while (coarse <= Math.Min(width, height))
        {
            coarse <<= 1;
        }

        coarse >>= 1;
        for (int fine = coarse >> 1; fine >= 1; coarse = fine, fine >>= 1)
        {
            int y = 0;
            for (; y + coarse <= height; y += coarse)
            {
                int row = begin + (y * stepY);
                int x = 0;
                for (; x + coarse <= width; x += coarse)
                {
                    int at = row + (x * stepX);
                    Square(data, at, fine * stepX, fine * stepY, isSmall);
                }

                if ((width & fine) != 0)
                {
                    Pair(data, row + (x * stepX), row + (x * stepX) + (fine * stepY), isSmall);
                }
            }

            if ((height & fine) != 0)
            {
                int row = begin + (y * stepY);
                for (int x = 0; x + coarse <= width; x += coarse)
                {
                    Pair(data, row + (x * stepX), row + (x * stepX) + (fine * stepX), isSmall);
                }
            }
        }
    }

    private static void Square(Span<ushort> data, int at, int right, int down, bool isSmall)
    {
        Pair(data, at, at + down, isSmall);
        Pair(data, at + right, at + right + down, isSmall);
        Pair(data, at, at + right, isSmall);
        Pair(data, at + down, at + down + right, isSmall);
    }

    // Of mean and difference, two numbers: of 14 bits with signs, or of 16 bits around their circle.
    private static void Pair(Span<ushort> data, int first, int second, bool isSmall)
    {
        (int mean, int difference) = (data[first], data[second]);
        if (isSmall)
        {
            difference = (short)difference;
            int sum = (short)mean + (difference & 1) + (difference >> 1);
            data[first] = (ushort)sum;
            data[second] = (ushort)(sum - difference);
            return;
        }

        int b = (mean - (difference >> 1)) & 0xFFFF;
        data[first] = (ushort)(difference + b - 0x8000);
        data[second] = (ushort)b;
    }
}
