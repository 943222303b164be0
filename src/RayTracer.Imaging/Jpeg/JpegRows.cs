using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayTracer.Imaging;

/// <summary>Rows of samples, eight at a time; what is left over at their ends goes one by one, with the same operations.</summary>
internal static class JpegRows
{
    private const int Count = 8;

    /// <summary>
    /// Samples between two rows: three quarters of the near one and a quarter of the far one, which is exact; or those of one row alone.
    /// </summary>
    /// <param name="near">The near row.</param>
    /// <param name="far">As many samples of the far row, or none.</param>
    /// <param name="mixed">Receives the mixture.</param>
    public static void Mix(ReadOnlySpan<byte> near, ReadOnlySpan<byte> far, Span<float> mixed)
    {
        int x = 0;
        for (; x <= near.Length - Count; x += Count)
        {
            Vector256<float> values = Load(near, x);
            (far.IsEmpty ? values : (values * 0.75f) + (Load(far, x) * 0.25f)).CopyTo(mixed[x..]);
        }

        for (; x < near.Length; x++)
        {
            mixed[x] = far.IsEmpty ? near[x] : (near[x] * 0.75f) + (far[x] * 0.25f);
        }
    }

    /// <summary>Two pixels of each sample: three quarters of it, and a quarter of its neighbour on that side.</summary>
    /// <param name="samples">The samples.</param>
    /// <param name="row">Receives the pixels, at most two for each sample.</param>
    public static void Double(ReadOnlySpan<float> samples, Span<float> row)
    {
        int x = 0;
        if (Avx.IsSupported && samples.Length > Count)
        {
            row[x++] = (samples[0] * 0.75f) + (samples[0] * 0.25f);
            for (; (x / 2) + Count < samples.Length && x + (2 * Count) <= row.Length; x += 2 * Count)
            {
                // From the right half of a sample to the left half of the eighth after it.
                Vector256<float> left = Vector256.Create(samples[(x / 2)..]);
                Vector256<float> right = Vector256.Create(samples[((x / 2) + 1)..]);
                Vector256<float> rightHalves = (left * 0.75f) + (right * 0.25f);
                Vector256<float> leftHalves = (right * 0.75f) + (left * 0.25f);
                Vector256<float> low = Avx.UnpackLow(rightHalves, leftHalves);
                Vector256<float> high = Avx.UnpackHigh(rightHalves, leftHalves);
                Avx.Permute2x128(low, high, 0x20).CopyTo(row[x..]);
                Avx.Permute2x128(low, high, 0x31).CopyTo(row[(x + Count)..]);
            }
        }

        for (; x < row.Length; x++)
        {
            int near = x >> 1;
            int far = Math.Clamp(near + ((x & 1) == 0 ? -1 : 1), 0, samples.Length - 1);
            row[x] = (samples[near] * 0.75f) + (samples[far] * 0.25f);
        }
    }

    /// <summary>
    /// The nearest codes of red, green and blue: ITU-T T.871 (JFIF), section 7, which is Rec. 601 luminance with all codes used.
    /// </summary>
    /// <param name="y">Luminance.</param>
    /// <param name="cb">Difference of blue.</param>
    /// <param name="cr">Difference of red.</param>
    /// <param name="codes">Receives red, green and blue.</param>
    public static void ToRgb(ReadOnlySpan<byte> y, ReadOnlySpan<float> cb, ReadOnlySpan<float> cr, byte[][] codes)
    {
        int x = 0;
        for (; x <= y.Length - Count; x += Count)
        {
            Vector256<float> light = Load(y, x) + Vector256.Create(0.5f);
            Vector256<float> blue = Vector256.Create(cb[x..]) - Vector256.Create(128f);
            Vector256<float> red = Vector256.Create(cr[x..]) - Vector256.Create(128f);
            Store(light + (red * 1.402f), codes[0].AsSpan(x));
            Store(light - (blue * 0.344136286f) - (red * 0.714136286f), codes[1].AsSpan(x));
            Store(light + (blue * 1.772f), codes[2].AsSpan(x));
        }

        for (; x < y.Length; x++)
        {
            (float red, float green, float blue) = ToRgb(y[x] + 0.5f, cb[x], cr[x]);
            codes[0][x] = (byte)Math.Clamp(red, 0, 255);
            codes[1][x] = (byte)Math.Clamp(green, 0, 255);
            codes[2][x] = (byte)Math.Clamp(blue, 0, 255);
        }
    }

    /// <summary>Red, green and blue of one pixel.</summary>
    public static (float R, float G, float B) ToRgb(float y, float cb, float cr)
    {
        (float blue, float red) = (cb - 128, cr - 128);
        return (y + (1.402f * red), y - (0.344136286f * blue) - (0.714136286f * red), y + (1.772f * blue));
    }

    /// <summary>The nearest codes from 0 to 255.</summary>
    public static void Round(ReadOnlySpan<float> values, Span<byte> codes)
    {
        int x = 0;
        for (; x <= values.Length - Count; x += Count)
        {
            Store(Vector256.Create(values[x..]) + Vector256.Create(0.5f), codes[x..]);
        }

        for (; x < values.Length; x++)
        {
            codes[x] = (byte)Math.Clamp(values[x] + 0.5f, 0, 255);
        }
    }

    /// <summary>Stores eight values, brought into 0 to 255 and rounded down.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Vector256<float> values, Span<byte> to)
    {
        if (Avx.IsSupported)
        {
            // What is far below becomes the least integer; narrowing brings the others up to 0.
            Vector256<int> integers = Avx.ConvertToVector256Int32WithTruncation(Avx.Min(values, Vector256.Create(255f)));
            Vector128<short> shorts = Sse2.PackSignedSaturate(integers.GetLower(), integers.GetUpper());
            MemoryMarshal.Write(to, Sse2.PackUnsignedSaturate(shorts, shorts).AsUInt64().ToScalar());
            return;
        }

        Vector256<int> whole = Vector256.ConvertToInt32(Vector256.Min(Vector256.Max(values, Vector256<float>.Zero), Vector256.Create(255f)));
        Vector128<ushort> words = Vector128.Narrow(whole.GetLower(), whole.GetUpper()).AsUInt16();
        MemoryMarshal.Write(to, Vector128.Narrow(words, words).AsUInt64().ToScalar());
    }

    /// <summary>Three codes a pixel as light.</summary>
    /// <param name="red">Codes of red.</param>
    /// <param name="green">Codes of green.</param>
    /// <param name="blue">Codes of blue.</param>
    /// <param name="values">The light of each code.</param>
    /// <param name="pixels">Receives red, green and blue of each pixel.</param>
    public static void Decode(ReadOnlySpan<byte> red, ReadOnlySpan<byte> green, ReadOnlySpan<byte> blue, ReadOnlySpan<float> values, Span<float> pixels)
    {
        green = green[..red.Length];
        blue = blue[..red.Length];
        pixels = pixels[..(3 * red.Length)];

        // Codes are below 256, and so many values there are: no bounds to be checked for each.
        ref float light = ref MemoryMarshal.GetReference(values[..256]);
        ref float pixel = ref MemoryMarshal.GetReference(pixels);
        for (int x = 0; x < red.Length; x++)
        {
            pixel = Unsafe.Add(ref light, red[x]);
            Unsafe.Add(ref pixel, 1) = Unsafe.Add(ref light, green[x]);
            Unsafe.Add(ref pixel, 2) = Unsafe.Add(ref light, blue[x]);
            pixel = ref Unsafe.Add(ref pixel, 3);
        }
    }

    private static Vector256<float> Load(ReadOnlySpan<byte> samples, int x)
    {
        Vector128<ushort> words = Vector128.WidenLower(Vector128.CreateScalarUnsafe(MemoryMarshal.Read<ulong>(samples[x..])).AsByte());
        (Vector128<uint> low, Vector128<uint> high) = Vector128.Widen(words);
        return Vector256.ConvertToSingle(Vector256.Create(low, high).AsInt32());
    }
}
