using RayTracer.Rendering;

namespace RayTracer.Imaging;

/// <summary>The planes that a denoiser compares, made from two halves of a picture's samples.</summary>
internal sealed class DenoiserInput
{
    private const int VarianceRadius = 3;
    private const int ChannelsOfFeature = 3;

    // Differences of features below this share of their range are none (Rousselle, Manzi & Zwicker 2013, τ).
    private const float SmallestFeature = 1e-3f;

    // How many deviations, or steps to the neighbours, two features may differ (the same, k_f).
    private const float FeatureTolerance = 0.6f;

    /// <summary>Reads the halves.</summary>
    public DenoiserInput(HalfRender first, HalfRender second)
    {
        (int width, int height) = (first.Film.Width, first.Film.Height);
        HalfRender[] halves = [first, second];
        Colors = [Planes(width, height), Planes(width, height)];
        Sampled = new(width, height);
        PaddedPlane[] spread = [new(width, height), new(width, height)];
        for (int half = 0; half < 2; half++)
        {
            ReadColors(halves[half].Film, Colors[half], spread[half]);
        }

        Sampled.ForEach((x, y) => Sampled[x, y] = first.Film.SampleCount(x, y) > 0 && second.Film.SampleCount(x, y) > 0 ? 1 : 0);
        Variances = [Planes(width, height), Planes(width, height)];
        EstimateVariances(spread);
        Features = new PaddedPlane[HalfRender.Kinds.Count * ChannelsOfFeature];
        FeatureVariances = new PaddedPlane[Features.Length];
        FeatureScales = new PaddedPlane[Features.Length];
        for (int i = 0; i < HalfRender.Kinds.Count; i++)
        {
            ReadFeature(halves, HalfRender.Kinds[i], i * ChannelsOfFeature);
        }
    }

    /// <summary>Red, green and blue of each half.</summary>
    public PaddedPlane[][] Colors { get; }

    /// <summary>Estimated variance of each of them.</summary>
    public PaddedPlane[][] Variances { get; }

    /// <summary>1 where both halves have samples, 0 elsewhere and outside the picture.</summary>
    public PaddedPlane Sampled { get; }

    /// <summary>Coordinates of the normals, channels of the albedos: means of both halves.</summary>
    public PaddedPlane[] Features { get; }

    /// <summary>Estimated variance of each of them.</summary>
    public PaddedPlane[] FeatureVariances { get; }

    /// <summary>The factors of squared differences of features.</summary>
    public PaddedPlane[] FeatureScales { get; }

    private static PaddedPlane[] Planes(int width, int height) => [new(width, height), new(width, height), new(width, height)];

    private static void ReadColors(Film film, PaddedPlane[] colors, PaddedPlane spread)
    {
        spread.ForEach((x, y) =>
        {
            (colors[0][x, y], colors[1][x, y], colors[2][x, y]) = film.Mean(x, y);
            spread[x, y] = film.SampleVariance(x, y) / Math.Max(1, film.SampleCount(x, y));
        });
        Array.ForEach([.. colors, spread], p => p.Extend());
    }

    // The spread of a pixel's samples is known well but too large, for the samples are stratified; half the squared difference of the
    // halves is right but noisy. So the one is scaled by the ratio of their means around the pixel (Rousselle, Knaus & Zwicker 2012,
    // section 4.2).
    private void EstimateVariances(PaddedPlane[] spread)
    {
        PaddedPlane[] around = [spread[0].Blurred(VarianceRadius), spread[1].Blurred(VarianceRadius)];
        PaddedPlane[] near = [spread[0].Blurred(1), spread[1].Blurred(1)];
        for (int channel = 0; channel < 3; channel++)
        {
            (PaddedPlane a, PaddedPlane b) = (Colors[0][channel], Colors[1][channel]);
            PaddedPlane squares = HalfSquares(a, b, 0.5f).Blurred(VarianceRadius);
            for (int half = 0; half < 2; half++)
            {
                (PaddedPlane variance, PaddedPlane mean, PaddedPlane local) = (Variances[half][channel], around[half], near[half]);
                variance.ForEach((x, y) => variance[x, y] = mean[x, y] > 0 ? squares[x, y] * (local[x, y] / mean[x, y]) : squares[x, y]);
                variance.Extend();
            }
        }
    }

    private static PaddedPlane HalfSquares(PaddedPlane a, PaddedPlane b, float factor)
    {
        PaddedPlane squares = new(a.Width, a.Height);
        squares.ForEach((x, y) => squares[x, y] = factor * (a[x, y] - b[x, y]) * (a[x, y] - b[x, y]));
        squares.Extend();
        return squares;
    }

    private void ReadFeature(HalfRender[] halves, AuxiliaryImage kind, int first)
    {
        (int width, int height) = (Sampled.Width, Sampled.Height);
        PaddedPlane[][] read = [Planes(width, height), Planes(width, height)];
        double[] row = new double[width * ChannelsOfFeature];
        for (int half = 0; half < 2; half++)
        {
            for (int y = 0; y < height; y++)
            {
                halves[half].Features.ReadRow(kind, y, row);
                for (int i = 0; i < row.Length; i++)
                {
                    read[half][i % ChannelsOfFeature][i / ChannelsOfFeature, y] = (float)row[i];
                }
            }
        }

        for (int channel = 0; channel < ChannelsOfFeature; channel++)
        {
            AddFeature(first + channel, read[0][channel], read[1][channel]);
        }
    }

    private void AddFeature(int index, PaddedPlane a, PaddedPlane b)
    {
        PaddedPlane mean = new(a.Width, a.Height);
        mean.ForEach((x, y) => mean[x, y] = 0.5f * (a[x, y] + b[x, y]));
        mean.Extend();
        PaddedPlane variance = HalfSquares(a, b, 0.25f).Blurred(1);
        PaddedPlane scale = new(a.Width, a.Height);
        scale.ForEach((x, y) =>
        {
            float dx = 0.5f * (mean[x + 1, y] - mean[x - 1, y]);
            float dy = 0.5f * (mean[x, y + 1] - mean[x, y - 1]);
            float slope = float.FusedMultiplyAdd(dx, dx, dy * dy);
            scale[x, y] = 1 / (FeatureTolerance * FeatureTolerance * float.Max(SmallestFeature, float.Max(variance[x, y], slope)));
        });
        scale.Extend();
        (Features[index], FeatureVariances[index], FeatureScales[index]) = (mean, variance, scale);
    }
}

/// <summary>One half of a picture's samples, and what their camera rays met first.</summary>
/// <param name="Film">The samples' film.</param>
/// <param name="Features">Normals and albedos of the same samples.</param>
public sealed record HalfRender(Film Film, AovFilm Features)
{
    /// <summary>The auxiliary images that a denoiser needs.</summary>
    public static IReadOnlyList<AuxiliaryImage> Kinds { get; } = [new NormalImage(), new AlbedoImage()];

    /// <summary>An empty half.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    public static HalfRender Create(int width, int height)
    {
        Film film = new(width, height);
        return new(film, new AovFilm(film, Kinds));
    }
}
