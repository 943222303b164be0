using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Sobol points, scrambled by Owen's method: every power of two of samples is as evenly spread as points can be, and every
/// pixel and dimension has its own random scrambling, so the picture is unbiased. The first <see cref="TabledPairs"/> pairs
/// of dimensions are those of one high-dimensional sequence; every further group is the first two dimensions again,
/// in an order of its own, and every pair of it in a scrambling of its own (Burley, Practical hash-based Owen scrambling, JCGT 2020).
/// </summary>
public sealed unsafe class SobolSampler : Sampler
{
    /// <summary>Pairs of dimensions that come from one sequence: pixel and lens are stratified together.</summary>
    public const int TabledPairs = 2;

    // Low and high digits of the index look up separate tables, for the sequence is linear in the digits.
    private const int LowDigits = 12;
    private const int TableSize = 1 << LowDigits;

    // Points of dimension d at [d · 2 · TableSize], digits reversed (the first binary digit lowest), low table before high table.
    private static readonly uint* s_points = MakeTable();
    private readonly bool _isLong;

    /// <summary>Makes a sampler.</summary>
    /// <param name="samplesPerPixel">How many samples a pixel will have, up to 2²⁴; powers of two are spread most evenly.</param>
    public SobolSampler(int samplesPerPixel)
        : base(samplesPerPixel)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThan(samplesPerPixel, 1 << (2 * LowDigits));
        _isLong = samplesPerPixel > TableSize;
    }

    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
    {
        points.Key = Hash.GroupKey(pixelKey, group);

        // Shuffling the index by Owen's method too keeps every power of two of samples together.
        points.First = Scramble(sample.ReverseBits(), points.Key ^ 0x55A4A5C3u).ReverseBits();
        points.Second = Pascal(points.First);
    }

    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, uint group, out SamplePoints points)
    {
        if (group >= TabledPairs)
        {
            Begin(pixelKey, sample, (UIntW)group, out points);
            return;
        }

        points.Key = Hash.GroupKey(pixelKey, group);
        points.First = Point(sample, s_points + (4 * TableSize * group));
        points.Second = Point(sample, s_points + (4 * TableSize * group) + (2 * TableSize));
    }

    /// <inheritdoc/>
    public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
    {
        Hash.PairKeys(points.Key, pair, out UIntW keyU, out UIntW keyV);
        u = Unit(Scramble(points.First, keyU));
        v = Unit(Scramble(points.Second, keyV));
    }

    /// <summary>
    /// The second dimension of Sobol's sequence, whose matrix is Pascal's triangle modulo 2: digit j is the sum of the
    /// index's digits at all places that have the ones of j. One step for each digit of j, instead of one for each digit of the index.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static UIntW Pascal(UIntW index)
    {
        UIntW x = index;
        x ^= (x >> 1) & 0x55555555u;
        x ^= (x >> 2) & 0x33333333u;
        x ^= (x >> 4) & 0x0f0f0f0fu;
        x ^= (x >> 8) & 0x00ff00ffu;
        return x ^ (x >> 16);
    }

    // The scrambled point's digits are still reversed.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Unit(UIntW digits) => digits.ReverseBits().ToUnit();

    /// <summary>
    /// A random permutation of the tree of binary digits: every digit is flipped at random by a hash of the digits before it.
    /// With the first digit lowest, that is any hash in which no bit depends on higher ones (Laine &amp; Karras 2011); the constants are Burley's (2020).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static UIntW Scramble(UIntW digits, UIntW key)
    {
        UIntW x = digits + key;
        x ^= x * 0x6c50b47cu;
        x ^= x * 0xb82f1e52u;
        x ^= x * 0xc7afe638u;
        return x ^ (x * 0x8d22f6e6u);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private UIntW Point(UIntW index, uint* table)
    {
        UIntW low = UIntW.Gather(table, index & (TableSize - 1u));
        return _isLong ? low ^ UIntW.Gather(table + TableSize, (index >> LowDigits) & (TableSize - 1u)) : low;
    }

    private static uint* MakeTable()
    {
        const int dimensions = 2 * TabledPairs;
        uint* table = (uint*)NativeMemory.AlignedAlloc(dimensions * 2 * TableSize * sizeof(uint), 64);
        for (int dimension = 0; dimension < dimensions; dimension++)
        {
            ReadOnlySpan<uint> columns = SobolMatrix.Columns(dimension);
            for (int half = 0; half < 2; half++)
            {
                uint* points = table + (((dimension * 2) + half) * TableSize);
                points[0] = 0;
                for (int i = 1; i < TableSize; i++)
                {
                    // Each point is the point without its lowest digit, plus that digit's column.
                    int digit = BitOperations.TrailingZeroCount(i);
                    points[i] = points[i & (i - 1)] ^ columns[digit + (half * LowDigits)];
                }
            }
        }

        return table;
    }
}
