using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>
/// Smooths light within things: means over neighbours, near and then further ones, whose weights stop at other things, normals, distances, and at differences that the noise does not explain
/// (Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering"). A register of neighbouring pixels at a time, rows on several threads.
/// </summary>
[SkipLocalsInit]
internal static unsafe class EdgeFilter
{
    // How many standard deviations of its own noise a pixel's luminance may differ before it counts as something else.
    private const float Deviations = 4;

    // Of the logarithm of the distance, for each pixel between the two.
    private const float DepthSlope = 0.02f;

    /// <summary>Smooths once.</summary>
    /// <param name="from">The light.</param>
    /// <param name="guides">The edges.</param>
    /// <param name="step">From a neighbour to the next, at most <see cref="PaddedRows.Margin"/>.</param>
    /// <param name="to">Takes the smoother light.</param>
    /// <param name="threads">The number of threads.</param>
    public static void Smooth(MovingPlanes from, MovingGuides guides, int step, MovingPlanes to, int threads) =>
        MovingRows.ForEach(from.Rows.Height, threads, y =>
        {
            for (int x = 0; x < from.Rows.Width; x += FloatW.Count)
            {
                Smooth(from, guides, x, y, step, to);
            }
        });

    private static void Smooth(MovingPlanes from, MovingGuides guides, int x, int y, int step, MovingPlanes to)
    {
        int at = from.Rows.At(x, y);
        Pixels middle = new(from, guides, at);
        FloatW deviation = 1f / ((FloatW.Sqrt(middle.Variance) * Deviations) + (middle.Luminance * 0.01f) + 1e-4f);
        Sums sums = default;
        sums.Add(middle, 1f);
        for (int dy = -1; dy <= 1; dy++)
        {
            int row = y + (dy * step);
            if (row < 0 || row >= from.Rows.Height)
            {
                continue;
            }

            for (int dx = -1; dx <= 1; dx++)
            {
                if ((dx, dy) == (0, 0))
                {
                    continue;
                }

                Pixels other = new(from, guides, at + (dy * step * from.Rows.Stride) + (dx * step));
                sums.Add(other, Alike(middle, other, deviation, step));
            }
        }

        sums.Store(to, at);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Alike(in Pixels a, in Pixels b, in FloatW deviation, int step)
    {
        FloatW cosine = FloatW.Max(Vec3W.Dot(a.Normal, b.Normal), 0f);
        cosine *= cosine;
        cosine *= cosine;
        cosine *= cosine;
        cosine *= cosine;
        cosine *= cosine;

        // What surrounds everything has no normal.
        cosine = UIntW.Equal(a.Thing, 0u).Select(1f, cosine);
        FloatW light = Fall(FloatW.Abs(a.Luminance - b.Luminance) * deviation);
        FloatW depth = Fall(FloatW.Abs(a.Depth - b.Depth) * (1 / (DepthSlope * step)));
        return UIntW.Equal(a.Thing, b.Thing).Select(cosine * light * depth, 0f);
    }

    // About e⁻ˣ.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Fall(in FloatW x)
    {
        FloatW rest = FloatW.Max(1f - (x * 0.25f), 0f);
        rest *= rest;
        return rest * rest;
    }

    private readonly struct Pixels
    {
        public readonly RgbW Light;
        public readonly FloatW Variance, Luminance, Depth;
        public readonly Vec3W Normal;
        public readonly UIntW Thing;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Pixels(MovingPlanes light, MovingGuides guides, int at)
        {
            (Light, Variance) = (light[at], FloatW.Load(light.Variance + at));
            Luminance = Light.Luminance;
            (Normal, Depth, Thing) = (guides.Seen.Normal(at), FloatW.Load(guides.Depth + at), UIntW.Load(guides.Things + at));
        }
    }

    private struct Sums
    {
        private RgbW _light;
        private FloatW _variance, _weight;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(in Pixels pixels, in FloatW weight)
        {
            _light += pixels.Light * weight;
            _variance += pixels.Variance * weight * weight;
            _weight += weight;
        }

        // Beside the picture, where a row does not end with a register, no weight is left.
        public readonly void Store(MovingPlanes to, int at)
        {
            FloatW scale = 1f / FloatW.Max(_weight, 1e-6f);
            to[at] = _light * scale;
            (_variance * scale * scale).Store(to.Variance + at);
        }
    }
}

/// <summary>Spreads rows over threads.</summary>
internal static class MovingRows
{
    private const int Grain = 8;

    /// <summary>Does something with each row of a picture.</summary>
    public static void ForEach(int height, int threads, Action<int> row) =>
        Parallel.For(0, (height + Grain - 1) / Grain, new ParallelOptions { MaxDegreeOfParallelism = threads }, block =>
        {
            for (int y = block * Grain; y < Math.Min(height, (block + 1) * Grain); y++)
            {
                row(y);
            }
        });
}
