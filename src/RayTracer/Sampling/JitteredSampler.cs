using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// The report's jittered sampling (section 3.4): n×n cells, one random point in each. Every pair of dimensions visits its
/// cells in its own order, a hashed permutation of the pixel, so that the pairs are independent of one another and any
/// first part of the samples is an unbiased picture.
/// </summary>
internal class JitteredSampler : Sampler
{
    private readonly uint _count;
    private readonly uint _bits;
    private readonly int _half;
    private readonly int _root;
    private readonly bool _isPowerOf2;

    /// <summary>Makes a sampler of n×n cells.</summary>
    /// <param name="samplesPerPixel">The number of samples that a pixel will have: a square.</param>
    /// <exception cref="ArgumentException">The number is not a square.</exception>
    public JitteredSampler(int samplesPerPixel)
        : base(samplesPerPixel)
    {
        _root = Root(samplesPerPixel)
            ?? throw new ArgumentException(SamplerKind.Jittered.Complaint(samplesPerPixel), nameof(samplesPerPixel));
        _count = (uint)samplesPerPixel;
        _bits = BitOperations.RoundUpToPowerOf2(_count) - 1;
        _half = Math.Max(1, BitOperations.PopCount(_bits) / 2);
        _isPowerOf2 = _bits == _count - 1;
    }

    /// <summary>The square root of a square; null of any other number.</summary>
    public static int? Root(int n)
    {
        int root = (int)double.Round(double.Sqrt(n));
        return root * root == n ? root : null;
    }

    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
    {
        points.Key = Hash.GroupKey(pixelKey, group);
        points.First = points.Second = sample;
    }

    /// <inheritdoc/>
    public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
    {
        Hash.PairKeys(points.Key, pair, out UIntW order, out UIntW key);
        Cell(Permute(points.First, order), out FloatW column, out FloatW row);

        // Sixteen random digits are plenty within a cell, so that one hash serves both coordinates.
        UIntW random = Hash.Mix(key + (points.First * 0xC2B2AE3Du));
        FloatW x = FloatW.MultiplyAdd((random >> 16).ToFloat(), 1f / 65536, 0.5f / 65536);
        FloatW y = FloatW.MultiplyAdd((random & 0xffffu).ToFloat(), 1f / 65536, 0.5f / 65536);
        float scale = 1f / _root;

        // Rounding may carry the last cell's largest number up to 1.
        u = FloatW.Min((column + x) * scale, FloatBits.OneMinusEpsilon);
        v = FloatW.Min((row + y) * scale, FloatBits.OneMinusEpsilon);
    }

    /// <summary>Column and row of a cell, as whole numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private protected void Cell(UIntW cell, out FloatW column, out FloatW row)
    {
        if (_isPowerOf2)
        {
            // The root of a power of two that is a square has half of its digits.
            row = (cell >> BitOperations.TrailingZeroCount(_root)).ToFloat();
            column = (cell & (uint)(_root - 1)).ToFloat();
            return;
        }

        // The quotient in floats may be one off where there are millions of cells; the remainder decides.
        UIntW quotient = (cell.ToFloat() * (1f / _root)).ToIntInRange();
        UIntW remainder = cell - (quotient * (uint)_root);
        MaskW isTooLarge = remainder > int.MaxValue;
        quotient = isTooLarge.Select(quotient - 1u, quotient);
        remainder = isTooLarge.Select(remainder + (uint)_root, remainder);
        MaskW isTooSmall = remainder > (uint)(_root - 1);
        row = isTooSmall.Select(quotient + 1u, quotient).ToFloat();
        column = isTooSmall.Select(remainder - (uint)_root, remainder).ToFloat();
    }

    /// <summary>Number of cells along a side.</summary>
    private protected int Side => _root;

    /// <summary>
    /// A permutation of the cells, chosen by the key: a bijection of the next power of two, applied until the result is a cell
    /// (Kensler, Correlated multi-jittered sampling, Pixar technical memo 13-01, 2013, describes such cycle walking).
    /// </summary>
    /// <remarks>What takes a second walk is no longer uniform, for the key is the same; so, as Kensler does, the cells are turned by a random number at last.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private UIntW Permute(UIntW i, UIntW key) => _isPowerOf2 ? Walk(i, key) : WalkToCell(i, key);

    // What lanes that are not in use hold becomes a cell by the last mask.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private UIntW Walk(UIntW i, UIntW key)
    {
        // Digits are cut off where a shift would bring them down.
        UIntW x = ((i + key) * (key >> 7 | 1u)) & _bits;
        x ^= x >> _half;
        x = (x * (key >> 19 | 1u)) & _bits;
        x ^= x >> _half;
        return ((x * 0x6935fa69u) ^ (key >> 13)) & _bits;
    }

    private UIntW WalkToCell(in UIntW start, in UIntW key)
    {
        // From a number that is no cell (a lane that is not in use) the walk might never arrive.
        UIntW i = (start < _count).Select(start, 0u);
        MaskW outside = MaskW.All;
        do
        {
            i = outside.Select(Walk(i, key), i);
            outside &= i > (_count - 1);
        }
        while (outside.Any);
        return Turn(i, key);
    }

    /// <summary>Adds a random number of cells, modulo their number.</summary>
    private UIntW Turn(UIntW i, UIntW key)
    {
        UIntW turned = i + (((key * Hash.Golden) >> 8).ToFloat() * (_count * (1f / 16777216f))).ToIntInRange();
        return (turned > (_count - 1)).Select(turned - _count, turned);
    }
}

/// <summary>Samplers of n×n cells.</summary>
internal class JitteredKind(string name = "jittered") : SamplerKind(name)
{
    public override bool DependsOnCount => true;

    public override string? Complaint(int samplesPerPixel)
    {
        int below = (int)double.Sqrt(samplesPerPixel);
        return JitteredSampler.Root(samplesPerPixel) is not null ? null
            : $"the {Name} sampler needs a square number of samples, but {samplesPerPixel} is not one: use {below * below} or {(below + 1) * (below + 1)}";
    }

    public override Sampler Create(int samplesPerPixel) => new JitteredSampler(samplesPerPixel);
}
