using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Sobol points, scrambled by Owen's method: every power of two of samples is as evenly spread as points can be, and every
/// pixel and dimension has its own random scrambling, so the picture is unbiased. The first <see cref="TabledPairs"/> pairs
/// of dimensions are those of the first two groups; every further group is one of these pairs again, in an order that
/// two groups share (<see cref="Dimensions.SecondOfFour"/>), and every pair of it in its own scrambling (Burley, Practical
/// hash-based Owen scrambling, JCGT 2020).
/// </summary>
internal sealed unsafe class SobolSampler : Sampler
{
    /// <summary>Pairs of dimensions that come from one sequence: pixel and lens are stratified together.</summary>
    public const int TabledPairs = 2;

    private const int MaxDigits = 24;

    // Of the first digits of an index, the point's two coordinates fit into one number.
    private const int LowDigits = 12;

    // By digits of the index: what each contributes to the points of both pairs, digits reversed (the first binary digit lowest).
    private static readonly uint[][] s_columns = [.. Enumerable.Range(0, 2 * TabledPairs).Select(SobolMatrix.Columns)];
    private static readonly uint* s_low = MakeLow();
    private readonly int _digits;

    /// <summary>Makes a sampler.</summary>
    /// <param name="samplesPerPixel">The number of samples that a pixel will have, up to 2²⁴; powers of two are spread most evenly.</param>
    public SobolSampler(int samplesPerPixel)
        : base(samplesPerPixel)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThan(samplesPerPixel, 1 << MaxDigits);
        _digits = 32 - BitOperations.LeadingZeroCount((uint)samplesPerPixel - 1);
    }

    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
    {
        UIntW second = group & Dimensions.SecondOfFour;
        UIntW key = Hash.GroupKey(pixelKey, group - second);
        points.Key = key + (second * 0x85EBCA6Bu);

        // Shuffling the index by Owen's method too keeps every power of two of samples together. Sample 0 stays in its place, so that
        // digits that no sample has are zero; the scrambling of the points makes up for that.
        UIntW order = key ^ 0x55A4A5C3u;
        Place(Scramble(sample.ReverseBits(), order) ^ Scramble(0u, order), UIntW.Equal(second, 0u), out points.First, out points.Second);
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
        Place(sample.ReverseBits(), group == 0 ? MaskW.All : MaskW.None, out points.First, out points.Second);
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
    /// With the first digit lowest, that is any hash in which no bit depends on higher ones (Laine &amp; Karras 2011); the constants are
    /// Burley's (2020).
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

    // The points whose indices, digits reversed, are given: of the first pair of dimensions or of the second.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Place(UIntW reversed, MaskW isFirst, out UIntW first, out UIntW second)
    {
        UIntW both = 0u;
        int low = Math.Min(_digits, LowDigits);
        for (uint* columns = s_low; columns < s_low + (2 * low); columns += 2, reversed += reversed)
        {
            both ^= reversed.TopDigit.Select(isFirst.Select((UIntW)columns[0], columns[1]), 0u);
        }

        first = both & 0xffffu;
        second = both >> 16;
        if (_digits > LowDigits)
        {
            // Copies, as what is passed by reference stays in memory.
            (UIntW rest, MaskW chosen) = (reversed, isFirst);
            PlaceHigh(rest, chosen, ref first, ref second);
        }
    }

    private void PlaceHigh(in UIntW rest, in MaskW isFirst, ref UIntW first, ref UIntW second)
    {
        UIntW reversed = rest;
        for (int k = LowDigits; k < _digits; k++, reversed += reversed)
        {
            first ^= reversed.TopDigit.Select(isFirst.Select((UIntW)s_columns[0][k], s_columns[2][k]), 0u);
            second ^= reversed.TopDigit.Select(isFirst.Select((UIntW)s_columns[1][k], s_columns[3][k]), 0u);
        }
    }

    private static uint* MakeLow()
    {
        uint* low = (uint*)NativeMemory.AlignedAlloc(2 * LowDigits * sizeof(uint), 64);
        for (int k = 0; k < LowDigits; k++)
        {
            low[2 * k] = s_columns[0][k] | (s_columns[1][k] << 16);
            low[(2 * k) + 1] = s_columns[2][k] | (s_columns[3][k] << 16);
        }

        return low;
    }
}

/// <summary>The Sobol sampler.</summary>
internal sealed class SobolKind() : SamplerKind("sobol")
{
    public override Sampler Create(int samplesPerPixel) => new SobolSampler(samplesPerPixel);
}
