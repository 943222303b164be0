using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>
/// Denoises a film that keeps two halves of its samples (<see cref="FilmPlane.Half"/>). What the camera rays meet is found by rays of their
/// own, afterwards: so films need not keep it.
/// </summary>
/// <param name="scene">The scene that the film shows.</param>
/// <param name="options">The options of its computation, with the first of its samples.</param>
public sealed class Denoising(Scene scene, RenderOptions options)
{
    private const int MostSamples = 128;

    // About so much of the time goes into finding what the camera rays meet.
    private const double GuidesEnd = 0.5;

    /// <summary>Memory of what is needed besides the film, in bytes.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="planes">The planes of each half.</param>
    public static long Bytes(int width, int height, params IReadOnlyList<FilmPlane> planes) =>
        (2 * (FilmMemory.Bytes(width, height, planes) + AovFilm.Bytes(HalfRender.Kinds, width, height))) + (Denoiser.BytesPerPixel * (long)width * height);

    /// <summary>Prepares for a film in a file, whose scene is loaded for that; null where the scene is wrong, which was reported.</summary>
    /// <param name="film">The film.</param>
    /// <param name="scene">The scene's file, where it is no longer where it was; else null.</param>
    /// <param name="threads">The number of threads.</param>
    /// <param name="watch">Takes what there is to report.</param>
    /// <exception cref="JobException">The scene is another.</exception>
    public static Denoising? Of(HeldFilm film, string? scene, int threads, IJobWatch watch)
    {
        FilmHeader header = film.Header;
        RenderJob job = JobOrigin.Of(header, film.Path).WithSamples(header.Total);
        job = job with { Scene = scene ?? job.Scene };
        SceneLoadResult load = job.Load();
        watch.Read(load.Diagnostics);
        if (load is not { Scene: { } built, Description: { } description })
        {
            return null;
        }

        string content = Guidance.Unguided(OldFilms.Current(header, description, job.Scene, header.Crop).Content);
        return content == ContentHash.Of(description, job.Scene, header.Crop)
            ? new(built, new() { Threads = threads, Crop = header.Crop, Samples = header.Samples[0] })
            : throw LoadedJob.OtherScene(job.Scene);
    }

    /// <summary>Returns the denoised picture; null where a half has no samples.</summary>
    /// <param name="film">The film.</param>
    /// <param name="progress">Takes how much is done, 0 to 1; may be null.</param>
    public DenoiseResult? Denoise(Film film, IProgress<double>? progress)
    {
        (HalfRender first, HalfRender second) = HalfRender.Of(scene, options with { Samples = SamplesOf(film) }, film, Part(progress, 0, GuidesEnd));
        return first.Film.TotalSamples > 0 && second.Film.TotalSamples > 0
            ? Denoiser.Denoise(first, second, options.Threads, Part(progress, GuidesEnd, 1)) : null;
    }

    /// <summary>Returns the denoised picture of a film without halves: its noise is estimated from its pixels, which is worse.</summary>
    /// <param name="film">The film.</param>
    public Picture DenoiseWhole(Film film)
    {
        AovFilm features = new(film, HalfRender.Kinds);
        HalfRender.Pass(scene, options with { Samples = SamplesOf(film) }).Render(features);
        return Denoiser.Denoise(new HalfRender(film, features), options.Threads);
    }

    // No more than a pixel of the film has, and enough to know the surfaces: looking for them must not take longer than the picture.
    private SampleRange SamplesOf(Film film)
    {
        int first = options.Samples?.First ?? 0;
        long pixels = options.Crop?.Pixels ?? ((long)film.Width * film.Height);
        return new(first, first + (int)Math.Clamp((film.TotalSamples + pixels - 1) / pixels, 1, MostSamples));
    }

    private static PartOfProgress? Part(IProgress<double>? whole, double from, double to) => whole is null ? null : new(whole, from, to);

    private sealed class PartOfProgress(IProgress<double> whole, double from, double to) : IProgress<double>
    {
        public void Report(double value) => whole.Report(from + ((to - from) * value));
    }
}
