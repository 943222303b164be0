using System.Runtime.Intrinsics;

namespace RayTracer.Imaging;

/// <summary>The inverse discrete cosine transform of 8 × 8 blocks (ITU-T T.81, section A.3.3).</summary>
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
    /// <param name="steps">What each is multiplied by.</param>
    /// <param name="samples">Receives the first sample of each row.</param>
    /// <param name="stride">Bytes from one row of samples to the next.</param>
    public static void Inverse(ReadOnlySpan<short> coefficients, ReadOnlySpan<float> steps, Span<byte> samples, int stride)
    {
        Span<float> values = stackalloc float[JpegComponent.BlockSize];
        Span<float> turned = stackalloc float[JpegComponent.BlockSize];
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = coefficients[i] * steps[i];
        }

        Columns(values);
        for (int i = 0; i < values.Length; i++)
        {
            turned[((i % Side) * Side) + (i / Side)] = values[i];
        }

        Columns(turned);
        for (int y = 0; y < Side; y++)
        {
            Span<byte> row = samples.Slice(y * stride, Side);
            for (int x = 0; x < Side; x++)
            {
                // A quarter belongs to the definition; samples are around 128, and a half more rounds to the nearest.
                row[x] = (byte)Math.Clamp((turned[(x * Side) + y] * 0.25f) + 128.5f, 0, 255);
            }
        }
    }

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
