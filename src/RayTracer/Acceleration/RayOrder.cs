using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>
/// Sorts rays so that those of a block have much in common: by the coarse place of the origin, then by the direction's octant and slope, then by the
/// fine place, places along a Morton curve (after Moon et al. 2010).
/// </summary>
internal sealed unsafe class RayOrder
{
    /// <summary>Rays sorted at a time: the more, the more alike neighbours are, until the keys no longer fit the caches.</summary>
    public const int Capacity = 1 << 18;

    private const int DigitBits = 11;
    private const int Digits = 1 << DigitBits;
    private readonly PinnedBuffer<ulong> _memory = new(2L * Capacity);

    [ThreadStatic]
    private static RayOrder? s_ofThread;

    private RayOrder()
    {
    }

    /// <summary>The calling thread's own.</summary>
    public static RayOrder OfThread => s_ofThread ??= new();

    /// <summary>Sorts a part of a stream.</summary>
    /// <param name="rays">The stream.</param>
    /// <param name="first">First ray of the part.</param>
    /// <param name="count">Number of rays, at most <see cref="Capacity"/>.</param>
    /// <returns>The rays' indices in the stream in the lower halves; valid until the next call.</returns>
    public ulong* Sort(in RayStream rays, int first, int count)
    {
        ulong* from = _memory.Pointer;
        ulong* to = from + Capacity;
        uint* histogram = stackalloc uint[3 * Digits];
        new Span<uint>(histogram, 3 * Digits).Clear();
        MakeKeys(rays, first, count, from, histogram);
        for (int digit = 0; digit < 3; digit++)
        {
            uint* next = histogram + (digit * Digits);
            uint sum = 0;
            for (int value = 0; value < Digits; value++)
            {
                uint occurrences = next[value];
                next[value] = sum;
                sum += occurrences;
            }

            int shift = 32 + (digit * DigitBits);
            for (int i = 0; i < count; i++)
            {
                ulong ray = from[i];
                to[next[ray >> shift & (Digits - 1)]++] = ray;
            }

            ulong* swap = from;
            from = to;
            to = swap;
        }

        GC.KeepAlive(this);
        return from;
    }

    private static void MakeKeys(in RayStream rays, int first, int count, ulong* keys, uint* histogram)
    {
        Grid x = Grid.Over(rays.OriginX + first, count);
        Grid y = Grid.Over(rays.OriginY + first, count);
        Grid z = Grid.Over(rays.OriginZ + first, count);
        uint* eight = stackalloc uint[8];
        for (int lane = 0; lane < count; lane += 8)
        {
            int lanes = Math.Min(8, count - lane);
            int ray = first + lane;
            Vector256<uint> place = Spread(x.Cell(Load(rays.OriginX + ray, lanes)))
                | (Spread(y.Cell(Load(rays.OriginY + ray, lanes))) << 1)
                | (Spread(z.Cell(Load(rays.OriginZ + ray, lanes))) << 2);
            Vector256<uint> way = Way(Load(rays.DirectionX + ray, lanes), Load(rays.DirectionY + ray, lanes), Load(rays.DirectionZ + ray, lanes));
            (((place >> 21) << 23) | (way << 16) | ((place >> 5) & Vector256.Create(0xFFFFu))).Store(eight);
            for (int i = 0; i < lanes; i++)
            {
                uint key = eight[i];
                keys[lane + i] = ((ulong)key << 32) | (uint)(ray + i);
                histogram[key & (Digits - 1)]++;
                histogram[Digits + (key >> DigitBits & (Digits - 1))]++;
                histogram[(2 * Digits) + (key >> (2 * DigitBits))]++;
            }
        }
    }

    /// <summary>Seven bits: the octant, then two of each of two components of the direction scaled to |x| + |y| + |z| = 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<uint> Way(Vector256<float> x, Vector256<float> y, Vector256<float> z)
    {
        Vector256<float> sizeX = Vector256.Abs(x);
        Vector256<float> sizeY = Vector256.Abs(y);
        Vector256<float> scale = Vector256.Create(3.999f) / (sizeX + sizeY + Vector256.Abs(z));
        Vector256<uint> slope = Quarter(sizeX * scale) | (Quarter(sizeY * scale) << 2);
        return slope | (x.AsUInt32() >>> 31 << 4) | (y.AsUInt32() >>> 31 << 5) | (z.AsUInt32() >>> 31 << 6);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<uint> Quarter(Vector256<float> share) => Vector256.ConvertToInt32(share).AsUInt32() & Vector256.Create(3u);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Load(float* from, int lanes)
    {
        if (lanes == 8)
        {
            return Vector256.Load(from);
        }

        float* padded = stackalloc float[8];
        for (int i = 0; i < 8; i++)
        {
            padded[i] = from[Math.Min(i, lanes - 1)];
        }

        return Vector256.Load(padded);
    }

    /// <summary>Moves ten bits apart, two places between them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<uint> Spread(Vector256<uint> x)
    {
        x = (x | (x << 16)) & Vector256.Create(0x030000FFu);
        x = (x | (x << 8)) & Vector256.Create(0x0300F00Fu);
        x = (x | (x << 4)) & Vector256.Create(0x030C30C3u);
        return (x | (x << 2)) & Vector256.Create(0x09249249u);
    }

    /// <summary>1,024 cells over the range of some numbers.</summary>
    private readonly struct Grid(float lower, float upper)
    {
        private readonly Vector256<float> _lower = Vector256.Create(lower);
        private readonly Vector256<float> _scale = Vector256.Create(1023.9f / MathF.Max(upper - lower, 1e-30f));

        public static Grid Over(float* numbers, int count)
        {
            Vector256<float> lower = Vector256.Create(float.PositiveInfinity);
            Vector256<float> upper = -lower;
            for (int lane = 0; lane < count; lane += 8)
            {
                Vector256<float> eight = Load(numbers + lane, Math.Min(8, count - lane));
                lower = Lanes8.Min(eight, lower);
                upper = Lanes8.Max(eight, upper);
            }

            return new(Lanes8.Smallest(lower), Lanes8.Largest(upper));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector256<uint> Cell(Vector256<float> numbers) =>
            Vector256.ConvertToInt32((numbers - _lower) * _scale).AsUInt32() & Vector256.Create(1023u);
    }
}
