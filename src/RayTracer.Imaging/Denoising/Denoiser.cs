using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Takes noise out of renders: non-local means (Buades, Coll &amp; Morel 2005) over two halves of the samples, each filtered with weights
/// that the other one gives, so that no noise chooses its own weights (Rousselle, Knaus &amp; Zwicker 2012), and guided by normals and
/// albedos (Rousselle, Manzi &amp; Zwicker 2013). A pixel's result depends on its surroundings only, in a fixed order: it is the same to
/// the bit for any number of threads.
/// </summary>
public static class Denoiser
{
    /// <summary>Memory that is taken besides the halves, in bytes a pixel of a large picture.</summary>
    public const int BytesPerPixel = 200;

    /// <summary>The distance up to which a pixel's likes are looked for, in pixels.</summary>
    internal const int Window = 8;

    // Half the side of the patches that are compared.
    private const int Patch = 3;
    private const int BandHeight = 16;

    // Strength: how many deviations apart two colours may be (Rousselle, Knaus & Zwicker 2012, k).
    private const float Tolerance = 0.45f;
    private const float Tiny = 1e-10f;

    /// <summary>Denoises a picture.</summary>
    /// <param name="first">One half of the samples.</param>
    /// <param name="second">The other half; of the same size.</param>
    /// <param name="threads">How many threads to use; 0 for one a core.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <returns>The mean of both halves, without most of its noise; where one has no samples, the mean of all there are.</returns>
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public static Picture Denoise(HalfRender first, HalfRender second, int threads = 0, CancellationToken cancellation = default)
    {
        (int width, int height) = (first.Film.Width, first.Film.Height);
        if ((second.Film.Width, second.Film.Height) != (width, height))
        {
            throw new ArgumentException($"Halves of {width}×{height} and {second.Film.Width}×{second.Film.Height} pixels are not of one picture.", nameof(second));
        }

        DenoiserInput input = new(first, second);
        Picture result = new(width, height);
        ParallelOptions parallel = new() { MaxDegreeOfParallelism = threads > 0 ? threads : Environment.ProcessorCount, CancellationToken = cancellation };
        Parallel.For(0, (height + BandHeight - 1) / BandHeight, parallel, () => new Band(input), (i, _, band) =>
        {
            int top = i * BandHeight;
            int rows = Math.Min(BandHeight, height - top);
            for (int half = 0; half < 2; half++)
            {
                band.Filter(half, top, rows);
                for (int y = top; y < top + rows; y++)
                {
                    band.AddRow(half, y, (half == 0 ? first : second).Film, (half == 0 ? second : first).Film, result);
                }
            }

            return band;
        }, _ => { });
        return result;
    }

    /// <summary>Filters rows of a picture. Each thread has its own.</summary>
    private sealed class Band
    {
        private readonly DenoiserInput _input;
        private readonly int _width;
        private readonly int _stride;
        private readonly float[] _distance;
        private readonly float[] _across;
        private readonly float[][] _sums;
        private int _top;
        private int _rows;

        public Band(DenoiserInput input)
        {
            _input = input;
            _width = input.Sampled.Width;
            _stride = _width + (2 * Patch) + (2 * Vector<float>.Count);
            _distance = new float[_stride * (BandHeight + (2 * Patch))];
            _across = new float[_distance.Length];
            _sums = [new float[_stride * BandHeight], new float[_stride * BandHeight], new float[_stride * BandHeight], new float[_stride * BandHeight]];
        }

        /// <summary>Filters one half with the weights that the other gives.</summary>
        public void Filter(int half, int top, int rows)
        {
            (_top, _rows) = (top, rows);
            Array.ForEach(_sums, Array.Clear);
            for (int dy = -Window; dy <= Window; dy++)
            {
                for (int dx = -Window; dx <= Window; dx++)
                {
                    Compare(1 - half, dx, dy);
                    Gather(_input.Colors[half], dx, dy);
                }
            }
        }

        /// <summary>Adds a half's share to a row of the result.</summary>
        public void AddRow(int half, int y, Rendering.Film film, Rendering.Film other, Picture result)
        {
            for (int x = 0; x < _width; x++)
            {
                double count = film.SampleCount(x, y);
                float share = count > 0 ? (float)(count / (count + other.SampleCount(x, y))) : 0;
                int at = ((y - _top) * _stride) + x;
                float weight = _sums[3][at];
                for (int channel = 0; channel < 3; channel++)
                {
                    float own = _input.Colors[half][channel][x, y];
                    float change = weight > 0 ? _sums[channel][at] / weight : 0;
                    result.Pixels[(3 * ((y * _width) + x)) + channel] += share * (own + change);
                }
            }
        }

        // Differences between each pixel and the one that lies dx, dy from it, in units of what noise makes expected; then their sums along
        // rows.
        private void Compare(int guide, int dx, int dy)
        {
            int lanes = Vector<float>.Count;
            for (int row = 0; row < _rows + (2 * Patch); row++)
            {
                int y = _top + row - Patch;
                Span<float> distance = _distance.AsSpan(row * _stride, _stride);
                for (int x = -Patch; x < _width + Patch; x += lanes)
                {
                    FloatW sum = Difference(guide, 0, x, y, dx, dy) + Difference(guide, 1, x, y, dx, dy) + Difference(guide, 2, x, y, dx, dy);
                    sum.V.CopyTo(distance[(x + Patch)..]);
                }

                Span<float> across = _across.AsSpan(row * _stride, _stride);
                for (int x = 0; x < _width; x += lanes)
                {
                    FloatW sum = 0f;
                    for (int i = 0; i <= 2 * Patch; i++)
                    {
                        sum += new FloatW(new Vector<float>(distance[(x + i)..]));
                    }

                    sum.V.CopyTo(across[x..]);
                }
            }
        }

        private FloatW Difference(int guide, int channel, int x, int y, int dx, int dy)
        {
            PaddedPlane color = _input.Colors[guide][channel];
            PaddedPlane variance = _input.Variances[guide][channel];
            FloatW here = variance.Load(x, y);
            FloatW there = variance.Load(x + dx, y + dy);
            FloatW d = color.Load(x, y) - color.Load(x + dx, y + dy);
            FloatW surprise = FloatW.MultiplyAdd(d, d, -(here + FloatW.Min(here, there)));
            return surprise / FloatW.MultiplyAdd(Tolerance * Tolerance, here + there, Tiny);
        }

        private void Gather(PaddedPlane[] colors, int dx, int dy)
        {
            int lanes = Vector<float>.Count;
            const float scale = 1f / (3 * ((2 * Patch) + 1) * ((2 * Patch) + 1));
            for (int row = 0; row < _rows; row++)
            {
                int y = _top + row;
                if (y + dy < 0 || y + dy >= _input.Sampled.Height)
                {
                    continue;
                }

                for (int x = 0; x < _width; x += lanes)
                {
                    FloatW patch = 0f;
                    for (int i = 0; i <= 2 * Patch; i++)
                    {
                        patch += new FloatW(new Vector<float>(_across, ((row + i) * _stride) + x));
                    }

                    FloatW far = FloatW.Max(patch * scale, FeatureDistance(x, y, dx, dy));
                    FloatW weight = LaneMath.Exp(-FloatW.Max(far, 0f)) * Inside(x + dx) * _input.Sampled.Load(x + dx, y + dy);
                    int at = (row * _stride) + x;
                    for (int channel = 0; channel < 3; channel++)
                    {
                        // What is alike everywhere changes nothing, not even by rounding.
                        FloatW change = colors[channel].Load(x + dx, y + dy) - colors[channel].Load(x, y);
                        FloatW.MultiplyAdd(weight, change, new(new Vector<float>(_sums[channel], at))).V.CopyTo(_sums[channel], at);
                    }

                    (new FloatW(new Vector<float>(_sums[3], at)) + weight).V.CopyTo(_sums[3], at);
                }
            }
        }

        // The planes' margins repeat the picture's edge, which must not count twice.
        private FloatW Inside(int x)
        {
            FloatW column = FloatW.Iota + (float)x;
            return ((column > -0.5f) & (column < _width - 0.5f)).Select(1f, 0f);
        }

        private FloatW FeatureDistance(int x, int y, int dx, int dy)
        {
            FloatW largest = 0f;
            for (int i = 0; i < _input.Features.Length; i++)
            {
                FloatW d = _input.Features[i].Load(x, y) - _input.Features[i].Load(x + dx, y + dy);
                FloatW here = _input.FeatureVariances[i].Load(x, y);
                FloatW surprise = FloatW.MultiplyAdd(d, d, -(here + FloatW.Min(here, _input.FeatureVariances[i].Load(x + dx, y + dy))));
                largest = FloatW.Max(largest, surprise * _input.FeatureScales[i].Load(x, y));
            }

            return largest;
        }
    }
}
