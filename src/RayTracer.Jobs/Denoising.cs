using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>Renders a picture in two halves, and denoises it. The film is the same to the bit as in one go.</summary>
internal sealed class Denoising
{
    private readonly Scene _scene;
    private readonly HalfRender[] _halves;
    private bool _isWhole;

    private Denoising(Scene scene)
    {
        _scene = scene;
        RenderDescription render = scene.Render;
        _halves = [HalfRender.Create(render.Width, render.Height), HalfRender.Create(render.Width, render.Height)];
    }

    /// <summary>Memory of what is needed besides the film, in bytes.</summary>
    public static long Bytes(int width, int height) =>
        (2 * (FilmMemory.Bytes(width, height) + AovFilm.Bytes(HalfRender.Kinds, width, height)))
            + (Denoiser.BytesPerPixel * (long)width * height);

    /// <summary>Prepares.</summary>
    /// <exception cref="JobException">There are too few samples.</exception>
    public static Denoising Create(Scene scene) => scene.Render.SamplesPerPixel > 1
        ? new(scene)
        : throw new JobException(
            JobFault.Request, "--denoise compares two halves of the samples, but there is only 1 a pixel: give --spp 2 or more");

    /// <summary>Renders into a film.</summary>
    public RenderStatistics Render(Film film, RenderOptions options, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        int count = options.Samples?.Count ?? _scene.Render.SamplesPerPixel;
        SampleRange[] ranges = [new(0, count / 2), new(count / 2, count)];
        RenderStatistics statistics = new();
        for (int i = 0; i < 2; i++)
        {
            RenderOptions half = options with { Samples = ranges[i] };
            statistics += new RTracer(_scene, half).Render(_halves[i].Film, progress, cancellation);
            film.Merge(_halves[i].Film);
        }

        try
        {
            for (int i = 0; i < 2 && !statistics.Cancelled; i++)
            {
                new FirstHitPass(_scene, options with { Samples = ranges[i] }).Render(_halves[i].Features, cancellation);
                _isWhole = i == 1;
            }
        }
        catch (OperationCanceledException)
        {
            // There is a picture, but none to denoise.
        }

        return statistics;
    }

    /// <summary>The denoised picture; null where the rendering was stopped early.</summary>
    public DenoiseResult? Denoise(int threads) => _isWhole ? Denoiser.Denoise(_halves[0], _halves[1], threads) : null;
}
