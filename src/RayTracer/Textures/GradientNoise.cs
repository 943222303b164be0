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
    public static FloatW Perlin(in Vec3W p, uint seed)
    {
        Split(p.X, out UIntW x0, out UIntW x1, out FloatW x);
        Split(p.Y, out UIntW y0, out UIntW y1, out FloatW y);
        Split(p.Z, out UIntW z0, out UIntW z1, out FloatW z);
        FloatW sx = Fade(x);
        FloatW sy = Fade(y);
        FloatW near = Mix(
            Mix(Slope(x0, y0, z0, seed, x, y, z), Slope(x1, y0, z0, seed, x - 1f, y, z), sx),
            Mix(Slope(x0, y1, z0, seed, x, y - 1f, z), Slope(x1, y1, z0, seed, x - 1f, y - 1f, z), sx),
            sy);
        FloatW far = Mix(
            Mix(Slope(x0, y0, z1, seed, x, y, z - 1f), Slope(x1, y0, z1, seed, x - 1f, y, z - 1f), sx),
            Mix(Slope(x0, y1, z1, seed, x, y - 1f, z - 1f), Slope(x1, y1, z1, seed, x - 1f, y - 1f, z - 1f), sx),
            sy);
        return Mix(near, far, Fade(z));
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

    private static FloatW Mix(FloatW a, FloatW b, FloatW t) => FloatW.MultiplyAdd(b - a, t, a);

    // The product of a point of the grid's gradient, one of the twelve to the middles of a cube's edges (four of them twice), with the way
    // from there.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Slope(UIntW i, UIntW j, UIntW k, uint seed, FloatW x, FloatW y, FloatW z)
    {
        UIntW hash = Hash.Mix(Hash.Mix(i | (j << 16)) + (k * Hash.Golden) + (seed * 0x85EBCA6Bu)) >> 28;
        FloatW a = (hash < 8u).Select(x, y);
        MaskW takesX = UIntW.Equal(hash & 13u, 12u);
        FloatW b = (hash < 4u).Select(y, takesX.Select(x, z));
        return (a.AsUInt() ^ (hash << 31)).AsFloat() + (b.AsUInt() ^ ((hash >> 1) << 31)).AsFloat();
    }
}
