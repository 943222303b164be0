using System.Numerics;
using System.Runtime.CompilerServices;

namespace RayTracer.Session;

/// <summary>
/// Smooths light within things: à-trous wavelets whose weights stop at other things, normals, distances, and at differences that the noise does not explain
/// (Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering"). A register of neighbouring pixels at a time, rows on several threads.
/// </summary>
internal static class EdgeFilter
{
    // How many standard deviations of its own noise a pixel's luminance may differ before it counts as something else.
    private const float Deviations = 4;

    // Of the logarithm of the distance, for each pixel between the two.
    private const float DepthSlope = 0.02f;
    private static readonly float[] s_kernel = [0.25f, 0.5f, 0.25f];

    /// <summary>Smooths once.</summary>
    /// <param name="from">The light.</param>
    /// <param name="guides">The edges.</param>
    /// <param name="step">From a neighbour to the next, at most <see cref="MovingPlanes.Margin"/>.</param>
    /// <param name="to">Takes the smoother light.</param>
    /// <param name="threads">The number of threads.</param>
    public static void Smooth(MovingPlanes from, MovingGuides guides, int step, MovingPlanes to, int threads) =>
        MovingRows.ForEach(from.Height, threads, y =>
        {
            for (int x = 0; x < from.Width; x += Vector<float>.Count)
            {
                Smooth(from, guides, x, y, step, to);
            }
        });

    private static void Smooth(MovingPlanes from, MovingGuides guides, int x, int y, int step, MovingPlanes to)
    {
        int at = from.At(x, y);
        Pixels middle = new(from, guides, at);
        Vector<float> deviation = Vector<float>.One / ((Vector.SquareRoot(middle.Variance) * Deviations) + (middle.Luminance * 0.01f) + new Vector<float>(1e-4f));
        Sums sums = default;
        sums.Add(middle, new(s_kernel[1] * s_kernel[1]));
        for (int dy = -1; dy <= 1; dy++)
        {
            int row = y + (dy * step);
            if (row < 0 || row >= from.Height)
            {
                continue;
            }

            for (int dx = -1; dx <= 1; dx++)
            {
                if ((dx, dy) == (0, 0))
                {
                    continue;
                }

                float share = s_kernel[dx + 1] * s_kernel[dy + 1];
                Pixels other = new(from, guides, at + (dy * step * from.Stride) + (dx * step));
                sums.Add(other, share * Alike(middle, other, deviation, step));
            }
        }

        sums.Store(to, at);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<float> Alike(in Pixels a, in Pixels b, in Vector<float> deviation, int step)
    {
        Vector<float> cosine = Vector.Max((a.NormalX * b.NormalX) + (a.NormalY * b.NormalY) + (a.NormalZ * b.NormalZ), Vector<float>.Zero);
        cosine *= cosine;
        cosine *= cosine;
        cosine *= cosine;
        cosine *= cosine;
        cosine *= cosine;

        // What surrounds everything has no normal.
        cosine = Vector.ConditionalSelect(Vector.Equals(a.Thing, Vector<int>.Zero), Vector<float>.One, cosine);
        Vector<float> light = Fall(Vector.Abs(a.Luminance - b.Luminance) * deviation);
        Vector<float> depth = Fall(Vector.Abs(a.Depth - b.Depth) * (1 / (DepthSlope * step)));
        return Vector.ConditionalSelect(Vector.Equals(a.Thing, b.Thing), cosine * light * depth, Vector<float>.Zero);
    }

    // About e⁻ˣ.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<float> Fall(Vector<float> x)
    {
        Vector<float> rest = Vector.Max(Vector<float>.One - (x * 0.25f), Vector<float>.Zero);
        rest *= rest;
        return rest * rest;
    }

    private readonly ref struct Pixels
    {
        public readonly Vector<float> Red, Green, Blue, Variance, Luminance, NormalX, NormalY, NormalZ, Depth;
        public readonly Vector<int> Thing;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Pixels(MovingPlanes light, MovingGuides guides, int at)
        {
            int size = light.Size;
            (Red, Green, Blue, Variance) = (Load(light.All, at), Load(light.All, size + at), Load(light.All, (2 * size) + at), Load(light.All, (3 * size) + at));
            Luminance = (Red * 0.2126f) + (Green * 0.7152f) + (Blue * 0.0722f);
            (NormalX, NormalY, NormalZ, Depth) = (Load(guides.NormalX, at), Load(guides.NormalY, at), Load(guides.NormalZ, at), Load(guides.Depth, at));
            Thing = Vector.LoadUnsafe(ref guides.Thing[at]);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector<float> Load(float[] plane, int at) => Vector.LoadUnsafe(ref plane[at]);
    }

    private ref struct Sums
    {
        private Vector<float> _red, _green, _blue, _variance, _weight;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(in Pixels pixels, in Vector<float> weight)
        {
            _red += pixels.Red * weight;
            _green += pixels.Green * weight;
            _blue += pixels.Blue * weight;
            _variance += pixels.Variance * weight * weight;
            _weight += weight;
        }

        // Beside the picture, where a row does not end with a register, no weight is left.
        public readonly void Store(MovingPlanes to, int at)
        {
            Vector<float> scale = Vector<float>.One / Vector.Max(_weight, new Vector<float>(1e-6f));
            (_red * scale).CopyTo(to.Red[at..]);
            (_green * scale).CopyTo(to.Green[at..]);
            (_blue * scale).CopyTo(to.Blue[at..]);
            (_variance * scale * scale).CopyTo(to.Variance[at..]);
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
