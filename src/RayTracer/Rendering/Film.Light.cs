namespace RayTracer.Rendering;

/// <summary>The light that paths from the lights bring, in planes of the film.</summary>
public sealed partial class Film
{
    private const int Channels = 3;

    // The weights of Rec. 709 in 65,536ths.
    private const int LuminanceBits = 16;
    private const int RedWeight = 13933;
    private const int GreenWeight = 46871;
    private const int BlueWeight = 4732;

    // From the square of 2⁻³² to 2⁻⁴⁸.
    private const int SquareShift = 16;
    private static readonly Int128 s_limit = (Int128)(SampleLimit * ChannelUnits);
    private readonly Int128[]? _light;
    private readonly Int128[]? _lightSquares;

    /// <summary>The planes that files keep, and its hash covers: what is there for its noise alone is not among them.</summary>
    internal IReadOnlyList<FilmPlane> KeptPlanes =>
        Planes.Contains(FilmPlane.LightHalf) ? Planes : [.. Planes.Where(p => p != FilmPlane.LightSquare)];

    /// <summary>True if <see cref="MeanVariance"/> covers all that the film holds.</summary>
    internal bool KnowsNoise => _light is null || _lightSquares is not null;

    /// <summary>
    /// Estimated variance of the luminance of a pixel's mean, as if all of its samples were independent (<see cref="SampleVariance"/>): of the
    /// camera samples' mean, and of the light samples' where the film has <see cref="FilmPlane.LightSquare"/>.
    /// </summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    internal float MeanVariance(int x, int y)
    {
        long pixel = Index(x, y);
        float variance = SampleVariance(x, y) / Math.Max(1, _counts[pixel]);
        if (_light is null || _lightSquares is null)
        {
            return variance;
        }

        ReadOnlySpan<Int128> light = LightSums(pixel);
        return variance + (Variance(light, _lightSquares[pixel], (double)light[Channels]) / Math.Max(1, (uint)light[Channels]));
    }

    /// <summary>Adds a light sample of pixels in a row.</summary>
    /// <param name="x">Column of the first pixel.</param>
    /// <param name="y">Row.</param>
    /// <param name="sums">Red, green and blue of each pixel, in units of 2⁻³².</param>
    /// <param name="sample">The sample's number.</param>
    /// <exception cref="ArgumentException">The film has no <see cref="FilmPlane.Light"/>.</exception>
    internal void AddLight(int x, int y, ReadOnlySpan<Int128> sums, int sample)
    {
        int pixels = sums.Length / Channels;
        long first = Index(x, y);
        Span<Int128> light = PlaneRow(FilmPlane.Light, first, pixels * FilmPlane.Light.Sums.Count);
        Span<Int128> squares = _lightSquares is null ? default : _lightSquares.AsSpan((int)first, pixels);
        int perHalf = FilmPlane.IsOfHalf(sample) && Planes.Contains(FilmPlane.LightHalf) ? FilmPlane.LightHalf.Sums.Count : 0;
        Span<Int128> half = perHalf > 0 ? PlaneRow(FilmPlane.LightHalf, first, pixels * perHalf) : default;
        for (int i = 0; i < pixels; i++)
        {
            ReadOnlySpan<Int128> own = sums.Slice(i * Channels, Channels);
            AddSample(light.Slice(i * FilmPlane.Light.Sums.Count, FilmPlane.Light.Sums.Count), own);
            Int128 square = squares.IsEmpty ? 0 : Square(own);
            if (!squares.IsEmpty)
            {
                squares[i] += square;
            }

            if (perHalf > 0)
            {
                Span<Int128> target = half.Slice(i * perHalf, perHalf);
                AddSample(target, own);
                target[SquareSum] += square;
            }
        }
    }

    // The last of the sums is the number of samples.
    private static void AddSample(Span<Int128> target, ReadOnlySpan<Int128> sample)
    {
        for (int i = 0; i < Channels; i++)
        {
            target[i] += sample[i];
        }

        target[^1]++;
    }

    // Luminance beyond the limit of samples counts as that, so that squares cannot overflow.
    private static Int128 Square(ReadOnlySpan<Int128> sample)
    {
        Int128 weighted = (sample[0] * RedWeight) + (sample[1] * GreenWeight) + (sample[2] * BlueWeight);
        Int128 luminance = Int128.Clamp(weighted >> LuminanceBits, -s_limit, s_limit);
        return luminance * luminance >> SquareShift;
    }

    private ReadOnlySpan<Int128> LightSums(long pixel) => _light.AsSpan((int)pixel * FilmPlane.Light.Sums.Count, FilmPlane.Light.Sums.Count);

    private void AddLightMean(long pixel, ref double red, ref double green, ref double blue)
    {
        ReadOnlySpan<Int128> light = LightSums(pixel);
        if (light[Channels] != 0)
        {
            double scale = 1 / (ChannelUnits * (double)light[Channels]);
            red += ToDouble(light[0]) * scale;
            green += ToDouble(light[1]) * scale;
            blue += ToDouble(light[2]) * scale;
        }
    }

    private void PutLightHalves(Film first, Film second)
    {
        ReadOnlySpan<Int128> half = _planes[PlaneIndex(FilmPlane.LightHalf)];
        int perPixel = FilmPlane.LightHalf.Sums.Count;
        for (int pixel = 0; pixel < _counts.Length; pixel++)
        {
            ReadOnlySpan<Int128> own = half.Slice(pixel * perPixel, perPixel);
            Span<Int128> target = first._light.AsSpan(pixel * FilmPlane.Light.Sums.Count, FilmPlane.Light.Sums.Count);
            own[..Channels].CopyTo(target);
            target[Channels] = own[^1];
            first._lightSquares![pixel] = own[SquareSum];
        }

        Take(_light!, first._light!, second._light!);
        Take(_planes[PlaneIndex(FilmPlane.LightSquare)], first._lightSquares!, second._lightSquares!);
    }

    private static void Take(Int128[] all, Int128[] first, Int128[] second)
    {
        for (int i = 0; i < all.Length; i++)
        {
            second[i] = all[i] - first[i];
        }
    }
}
