using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayTracer.Imaging;

/// <summary>The discrete cosine transform of 8 × 8 blocks and its inverse (ITU-T T.81, section A.3.3).</summary>
internal static class JpegTransform
{
    private const int Side = JpegComponent.Side;

    // cos(kπ/16) for k = 1 … 7, correctly rounded, so that every machine computes with the same bits.
    private const float C1 = 0.98078528040323045f;
    private const float C2 = 0.92387953251128676f;
    private const float C3 = 0.83146961230254524f;
    private const float C4 = 0.70710678118654752f;
    private const float C5 = 0.55557023301960222f;
    private const float C6 = 0.38268343236508977f;
    private const float C7 = 0.19509032201612827f;

    /// <summary>Makes 64 samples from 64 coefficients.</summary>
    /// <param name="coefficients">Quantized coefficients, row by row.</param>
    /// <param name="steps">The factor on each coefficient.</param>
    /// <param name="samples">Receives the first sample of each row.</param>
    /// <param name="stride">Bytes from one row of samples to the next.</param>
    public static void Inverse(ReadOnlySpan<short> coefficients, ReadOnlySpan<float> steps, Span<byte> samples, int stride)
    {
        if (!coefficients[1..].ContainsAnyExcept((short)0))
        {
            Flat(coefficients[0] * steps[0] * C4 * C4, samples, stride);
            return;
        }

        Span<float> values = stackalloc float[JpegComponent.BlockSize];
        Span<float> turned = stackalloc float[JpegComponent.BlockSize];
        for (int row = 0; row < Side; row++)
        {
            Vector128<short> eight = Vector128.Create(coefficients.Slice(row * Side, Side));
            Vector256<int> wide = Vector256.Create(Vector128.WidenLower(eight), Vector128.WidenUpper(eight));
            Set(values, row, Vector256.ConvertToSingle(wide) * Vector256.Create(steps.Slice(row * Side, Side)));
        }

        Columns(values);
        Turn(values, turned);
        Columns(turned);
        Turn(turned, values);
        for (int y = 0; y < Side; y++)
        {
            // A quarter belongs to the definition; samples are around 128, and a half more rounds to the nearest.
            JpegRows.Store((Row(values, y) * 0.25f) + Vector256.Create(128.5f), samples.Slice(y * stride, Side));
        }
    }

    // What the transform makes of a block without differences, with the same operations.
    private static void Flat(float value, Span<byte> samples, int stride)
    {
        byte sample = (byte)Math.Clamp((value * 0.25f) + 128.5f, 0, 255);
        for (int y = 0; y < Side; y++)
        {
            samples.Slice(y * stride, Side).Fill(sample);
        }
    }

    /// <summary>Makes 64 quantized coefficients from 64 samples.</summary>
    /// <param name="samples">The samples around zero, row by row; they are lost.</param>
    /// <param name="factors">A quarter (which belongs to the definition) of one over each coefficient's step, row by row.</param>
    /// <param name="coefficients">Receives the coefficients in the order of scans.</param>
    public static void Forward(Span<float> samples, ReadOnlySpan<float> factors, Span<short> coefficients)
    {
        Span<float> turned = stackalloc float[JpegComponent.BlockSize];
        ForwardColumns(samples);
        Turn(samples, turned);
        ForwardColumns(turned);
        for (int k = 0; k < coefficients.Length; k++)
        {
            int place = JpegScan.PlaceOf(k);
            int turnedPlace = ((place % Side) * Side) + (place / Side);
            coefficients[k] = (short)MathF.Round(turned[turnedPlace] * factors[place]);
        }
    }

    private static void Turn(Span<float> values, Span<float> turned)
    {
        if (Avx.IsSupported)
        {
            TurnWide(values, turned);
            return;
        }

        for (int i = 0; i < values.Length; i++)
        {
            turned[((i % Side) * Side) + (i / Side)] = values[i];
        }
    }

    private static void TurnWide(Span<float> values, Span<float> turned)
    {
        // Halves of rows four apart side by side, then squares of 4 × 4 in each half.
        TurnSquares(Lower(values, 0), Lower(values, 1), Lower(values, 2), Lower(values, 3), turned[..(4 * Side)]);
        TurnSquares(Upper(values, 0), Upper(values, 1), Upper(values, 2), Upper(values, 3), turned[(4 * Side)..]);
    }

    private static Vector256<float> Lower(Span<float> values, int row) => Avx.Permute2x128(Row(values, row), Row(values, row + 4), 0x20);

    private static Vector256<float> Upper(Span<float> values, int row) => Avx.Permute2x128(Row(values, row), Row(values, row + 4), 0x31);

    private static void TurnSquares(Vector256<float> a, Vector256<float> b, Vector256<float> c, Vector256<float> d, Span<float> turned)
    {
        Vector256<float> acLow = Avx.UnpackLow(a, c);
        Vector256<float> acHigh = Avx.UnpackHigh(a, c);
        Vector256<float> bdLow = Avx.UnpackLow(b, d);
        Vector256<float> bdHigh = Avx.UnpackHigh(b, d);
        Set(turned, 0, Avx.UnpackLow(acLow, bdLow));
        Set(turned, 1, Avx.UnpackHigh(acLow, bdLow));
        Set(turned, 2, Avx.UnpackLow(acHigh, bdHigh));
        Set(turned, 3, Avx.UnpackHigh(acHigh, bdHigh));
    }

    // The transpose of the inverse's columns.
    private static void ForwardColumns(Span<float> values)
    {
        Vector256<float> s0 = Row(values, 0) + Row(values, 7);
        Vector256<float> s1 = Row(values, 1) + Row(values, 6);
        Vector256<float> s2 = Row(values, 2) + Row(values, 5);
        Vector256<float> s3 = Row(values, 3) + Row(values, 4);
        Vector256<float> d0 = Row(values, 0) - Row(values, 7);
        Vector256<float> d1 = Row(values, 1) - Row(values, 6);
        Vector256<float> d2 = Row(values, 2) - Row(values, 5);
        Vector256<float> d3 = Row(values, 3) - Row(values, 4);
        Set(values, 0, (s0 + s1 + s2 + s3) * C4);
        Set(values, 1, (d0 * C1) + (d1 * C3) + (d2 * C5) + (d3 * C7));
        Set(values, 2, ((s0 - s3) * C2) + ((s1 - s2) * C6));
        Set(values, 3, (d0 * C3) - (d1 * C7) - (d2 * C1) - (d3 * C5));
        Set(values, 4, (s0 - s1 - s2 + s3) * C4);
        Set(values, 5, (d0 * C5) - (d1 * C1) + (d2 * C7) + (d3 * C3));
        Set(values, 6, ((s0 - s3) * C6) - ((s1 - s2) * C2));
        Set(values, 7, (d0 * C7) - (d1 * C5) + (d2 * C3) - (d3 * C1));
    }

    private static void Set(Span<float> values, int row, Vector256<float> value) => value.CopyTo(values.Slice(row * Side, Side));

    // One-dimensional transforms of all eight columns, without the factor ½; sums and differences of the even and the odd
    // terms of the definition. Products and sums are separate operations on all machines.
    private static void Columns(Span<float> values)
    {
        Vector256<float> x0 = Row(values, 0);
        Vector256<float> x1 = Row(values, 1);
        Vector256<float> x2 = Row(values, 2);
        Vector256<float> x3 = Row(values, 3);
        Vector256<float> x4 = Row(values, 4);
        Vector256<float> x5 = Row(values, 5);
        Vector256<float> x6 = Row(values, 6);
        Vector256<float> x7 = Row(values, 7);
        Vector256<float> sum = (x0 + x4) * C4;
        Vector256<float> difference = (x0 - x4) * C4;
        Vector256<float> outer = (x2 * C2) + (x6 * C6);
        Vector256<float> inner = (x2 * C6) - (x6 * C2);
        SetPair(values, 0, sum + outer, (x1 * C1) + (x3 * C3) + (x5 * C5) + (x7 * C7));
        SetPair(values, 1, difference + inner, (x1 * C3) - (x3 * C7) - (x5 * C1) - (x7 * C5));
        SetPair(values, 2, difference - inner, (x1 * C5) - (x3 * C1) + (x5 * C7) + (x7 * C3));
        SetPair(values, 3, sum - outer, (x1 * C7) - (x3 * C5) + (x5 * C3) - (x7 * C1));
    }

    private static Vector256<float> Row(Span<float> values, int row) => Vector256.Create<float>(values.Slice(row * Side, Side));

    private static void SetPair(Span<float> values, int row, Vector256<float> even, Vector256<float> odd)
    {
        (even + odd).CopyTo(values.Slice(row * Side, Side));
        (even - odd).CopyTo(values.Slice((Side - 1 - row) * Side, Side));
    }
}
