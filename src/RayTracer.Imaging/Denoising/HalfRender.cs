using RayTracer.Rendering;

namespace RayTracer.Imaging;

/// <summary>One half of a picture's samples, and what their camera rays met first.</summary>
/// <param name="Film">The samples' film.</param>
/// <param name="Features">Normals and albedos of the same samples.</param>
public sealed record HalfRender(Film Film, AovFilm Features)
{
    /// <summary>The auxiliary images that a denoiser needs.</summary>
    public static IReadOnlyList<AuxiliaryImage> Kinds { get; } = [new NormalImage(), new AlbedoImage()];

    // So many samples of a half know the surfaces well enough.
    private const int MostFeatureSamples = 64;

    /// <summary>The two halves of a film's samples, with what their camera rays meet, which is found by rays of their own.</summary>
    /// <param name="scene">The scene that the film shows.</param>
    /// <param name="options">The options of the computation, and the samples that the film holds.</param>
    /// <param name="film">The film.</param>
    /// <param name="progress">Takes how much of the rays is traced, 0 to 1; may be null.</param>
    /// <exception cref="ArgumentException">The film has no <see cref="FilmPlane.Half"/>.</exception>
    public static (HalfRender First, HalfRender Second) Of(Scene scene, RenderOptions options, Film film, IProgress<double>? progress = null)
    {
        (Film first, Film second) = film.Halves();
        SampleRange all = options.Samples ?? new(0, scene.Render.SamplesPerPixel);
        double whole = Math.Min(2 * MostFeatureSamples, all.Count);
        int done = 0;
        return (Half(first, isFirst: true), Half(second, isFirst: false));

        HalfRender Half(Film half, bool isFirst)
        {
            AovFilm features = new(half, Kinds);
            int left = MostFeatureSamples;
            for (int sample = all.First; sample < all.End && left > 0; sample++)
            {
                int begin = sample;
                while (sample < all.End && left > 0 && FilmPlane.IsOfHalf(sample) == isFirst)
                {
                    sample++;
                    left--;
                }

                if (sample > begin)
                {
                    Pass(scene, options with { Samples = new(begin, sample) }).Render(features);
                    done += sample - begin;
                    progress?.Report(Math.Min(1, done / whole));
                }
            }

            return new(half, features);
        }
    }

    /// <summary>Finds the features: what camera rays meet, through mirrors and clear glass.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="options">The options of the computation, and which samples count.</param>
    public static FirstHitPass Pass(Scene scene, RenderOptions options) => new(scene, options) { SeesThrough = true };

    /// <summary>An empty half.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="planes">The planes of its film.</param>
    public static HalfRender Create(int width, int height, params IReadOnlyList<FilmPlane> planes)
    {
        Film film = new(width, height, planes);
        return new(film, new AovFilm(film, Kinds));
    }
}
