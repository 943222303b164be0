using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Textures;

/// <summary>
/// Smooth random functions of space: Perlin's improved noise (Improving noise, 2002), with hashes in place of his table of 256 permuted
/// numbers, so that it repeats only after 65,536 units. It is 0 at points of the grid, has the mean 0 and stays within ±1.036.
/// </summary>
internal static class GradientNoise
{
    private const float Period = 65536;
    private const float OctaveShift = 17.375f;

    /// <summary>One octave of noise.</summary>
    /// <param name="p">The points.</param>
    /// <param name="seed">Selects the function.</param>
    public static FloatW Perlin(in Vec3W p, uint seed) => Between<Hashed>(p, seed);

    /// <summary>One octave of noise by Perlin's table, with the gradients that pbrt gives it: it repeats after 256 units.</summary>
    /// <param name="p">The points.</param>
    public static FloatW Tabled(in Vec3W p) => Between<Permuted>(p, 0);

    // Between the slopes at the eight corners of a cell.
    private static FloatW Between<TSlopes>(in Vec3W p, uint seed)
        where TSlopes : ISlopes
    {
        Split(p.X, out UIntW x0, out UIntW x1, out FloatW x);
        Split(p.Y, out UIntW y0, out UIntW y1, out FloatW y);
        Split(p.Z, out UIntW z0, out UIntW z1, out FloatW z);
        FloatW sx = Fade(x);
        FloatW sy = Fade(y);
        FloatW near = FloatW.Mix(
            FloatW.Mix(TSlopes.At(x0, y0, z0, seed, x, y, z), TSlopes.At(x1, y0, z0, seed, x - 1f, y, z), sx),
            FloatW.Mix(TSlopes.At(x0, y1, z0, seed, x, y - 1f, z), TSlopes.At(x1, y1, z0, seed, x - 1f, y - 1f, z), sx),
            sy);
        FloatW far = FloatW.Mix(
            FloatW.Mix(TSlopes.At(x0, y0, z1, seed, x, y, z - 1f), TSlopes.At(x1, y0, z1, seed, x - 1f, y, z - 1f), sx),
            FloatW.Mix(TSlopes.At(x0, y1, z1, seed, x, y - 1f, z - 1f), TSlopes.At(x1, y1, z1, seed, x - 1f, y - 1f, z - 1f), sx),
            sy);
        return FloatW.Mix(near, far, Fade(z));
    }

    /// <summary>
    /// Octaves of noise, each of twice the frequency of the one before and of <paramref name="gain"/> times its height (fractional Brownian motion), over
    /// the sum of all heights.
    /// </summary>
    /// <param name="p">The points.</param>
    /// <param name="seed">Selects the function.</param>
    /// <param name="octaves">The number of octaves, at least 1.</param>
    /// <param name="gain">Height of each over that of the one before.</param>
    /// <param name="isTurbulent">True if the magnitude of each is summed: creases, as of billows (Perlin, An image synthesizer,
    /// 1985).</param>
    public static FloatW Sum(in Vec3W p, uint seed, int octaves, float gain, bool isTurbulent)
    {
        FloatW sum = 0f;
        float heights = 0;
        float height = 1;
        float frequency = 1;
        for (int octave = 0; octave < octaves; octave++)
        {
            // Moved, lest the zeros of all octaves meet at the points of the first one's grid.
            float shift = octave * OctaveShift;
            FloatW noise = Perlin(Vec3W.MultiplyAdd(p, frequency, new Vec3W(shift, shift, shift)), seed + (uint)octave);
            sum = FloatW.MultiplyAdd(isTurbulent ? FloatW.Abs(noise) : noise, height, sum);
            heights += height;
            height *= gain;
            frequency *= 2;
        }

        return sum * (1 / heights);
    }

    // The cell's two borders, as numbers of the grid, and the place between them.
    private static void Split(FloatW x, out UIntW low, out UIntW high, out FloatW inside)
    {
        FloatW cell = FloatW.Floor(x);
        inside = x - cell;

        // Numbers that are none come out as one that is.
        FloatW wrapped = FloatW.NegatedMultiplyAdd(FloatW.Floor(cell * (1 / Period)), Period, cell);
        low = FloatW.Max(0f, FloatW.Min(wrapped, Period - 1)).ToIntInRange();
        high = (low + 1u) & ((uint)Period - 1);
    }

    // The fifth-degree curve with two derivatives that vanish at both ends.
    private static FloatW Fade(FloatW t) => t * t * t * FloatW.MultiplyAdd(t, FloatW.MultiplyAdd(t, 6f, -15f), 10f);

    // The product of the gradient of a point of the grid with the way from there.
    private interface ISlopes
    {
        static abstract FloatW At(UIntW i, UIntW j, UIntW k, uint seed, FloatW x, FloatW y, FloatW z);
    }

    // The gradient is one of the twelve to the middles of a cube's edges (four of them twice).
    private readonly struct Hashed : ISlopes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static FloatW At(UIntW i, UIntW j, UIntW k, uint seed, FloatW x, FloatW y, FloatW z)
        {
            UIntW hash = Hash.Mix(Hash.Mix(i | (j << 16)) + (k * Hash.Golden) + (seed * 0x85EBCA6Bu)) >> 28;
            FloatW a = (hash < 8u).Select(x, y);
            MaskW takesX = UIntW.Equal(hash & 13u, 12u);
            FloatW b = (hash < 4u).Select(y, takesX.Select(x, z));
            return Signed(hash, a, b);
        }
    }

    private readonly unsafe struct Permuted : ISlopes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static FloatW At(UIntW i, UIntW j, UIntW k, uint seed, FloatW x, FloatW y, FloatW z)
        {
            uint* table = PermutationTable.Numbers;
            UIntW hash = UIntW.Gather(table, i & 255u);
            hash = UIntW.Gather(table, (hash + j) & 255u);
            hash = UIntW.Gather(table, (hash + k) & 255u) & 15u;
            MaskW takesXY = UIntW.Equal(hash & 14u, 12u);
            FloatW a = ((hash < 8u) | takesXY).Select(x, y);
            FloatW b = ((hash < 4u) | takesXY).Select(y, z);
            return Signed(hash, a, b);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Signed(UIntW hash, FloatW a, FloatW b) =>
        (a.AsUInt() ^ (hash << 31)).AsFloat() + (b.AsUInt() ^ ((hash >> 1) << 31)).AsFloat();
}

/// <summary>The numbers from 0 to 255 as Perlin has shuffled them (Improving noise, 2002, its reference implementation).</summary>
internal static unsafe class PermutationTable
{
    private static readonly PinnedBuffer<uint> s_memory = Read();

    /// <summary>The 256 numbers.</summary>
    public static uint* Numbers { get; } = s_memory.Pointer;

    private static PinnedBuffer<uint> Read()
    {
        byte[] numbers = Convert.FromHexString(
            "97A0895B5A0F830DC95F6035C2E907E18C24671E458E086325F0150A17BE0694F778EA4B001AC53E5EFCDBCB75230B2039B12158ED953857AE147D88ABA844AF"
            + "4AA547868B301BA64D929EE7536FE57A3CD385E6DC695C29372EF528F4668F3641193FA101D85049D14C84BBD05912A9C8C4878274BC9F56A4646DC6ADBA0340"
            + "34D9E2FA7C7B05CA2693767EFF5255D4CFCE3BE32F103A11B6BD1C2ADFB7AAD577F898022C9AA346DD99659BA72BAC09811627FD13626C6E4F71E0E8B2B97068"
            + "DAF661E4FB22F2C1EED2900CBFB3A2F1513391EBF90EEF6B31C0D61FB5C76A9DB854CCB07379322D7F0496FE8AECCD5DDE72431D1848F38D80C34E42D73D9CB4");
        PinnedBuffer<uint> memory = new(numbers.Length);
        for (int i = 0; i < numbers.Length; i++)
        {
            memory.Pointer[i] = numbers[i];
        }

        return memory;
    }
}
