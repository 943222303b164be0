using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Sobol points, scrambled by Owen's method: every power of two of samples is as evenly spread as points can be, and every
/// pixel and dimension has its own random scrambling, so the picture is unbiased. The first <see cref="TabledPairs"/> pairs
/// of dimensions are those of the first two groups; every further group is one of these pairs again, in an order that
/// two groups share (<see cref="Dimensions.SecondOfFour"/>), and every pair of it in a scrambling of its own (Burley, Practical
/// hash-based Owen scrambling, JCGT 2020).
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
        UIntW second = group & Dimensions.SecondOfFour;
        UIntW order = Hash.GroupKey(pixelKey, group - second) ^ 0x55A4A5C3u;
        UIntW index = Scramble(sample.ReverseBits(), order).ReverseBits();
        if (_isLong)
        {
            // The first samples are those that there would be without the others.
            index ^= Scramble(0u, order).ReverseBits() & ~(TableSize - 1u);
        }

        UIntW table = second * (4u * TableSize / Dimensions.SecondOfFour);
        points.First = Point(index, table);
        points.Second = Point(index, table + (2u * TableSize));
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
        points.First = Point(sample, 4u * TableSize * group);
        points.Second = Point(sample, (4u * TableSize * group) + (2u * TableSize));
    }

    /// <inheritdoc/>
    public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
    {
        Hash.PairKeys(points.Key, pair, out UIntW keyU, out UIntW keyV);
        u = Unit(Scramble(points.First, keyU));
        v = Unit(Scramble(points.Second, keyV));
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
    private UIntW Point(UIntW index, UIntW table)
    {
        UIntW low = UIntW.Gather(s_points, table + (index & (TableSize - 1u)));
        return _isLong ? low ^ UIntW.Gather(s_points + TableSize, table + ((index >> LowDigits) & (TableSize - 1u))) : low;
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
