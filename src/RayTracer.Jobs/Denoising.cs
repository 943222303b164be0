using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>Keeps two halves of a picture's samples apart while it is rendered, and denoises it. The film is the same to the bit as without.</summary>
internal sealed class Denoising
{
    // So many samples of a half know the surfaces well enough.
    private const int MostFeatureSamples = 64;

    private readonly int[] _features = new int[2];
    private readonly Scene _scene;
    private readonly HalfRender[] _halves;

    private Denoising(Scene scene)
    {
        _scene = scene;
        RenderDescription render = scene.Render;
        _halves = [HalfRender.Create(render.Width, render.Height), HalfRender.Create(render.Width, render.Height)];
    }

    /// <summary>Memory of what is needed besides the film, in bytes.</summary>
    public static long Bytes(int width, int height) =>
        (2 * (FilmMemory.Bytes(width, height) + AovFilm.Bytes(HalfRender.Kinds, width, height))) + (Denoiser.BytesPerPixel * (long)width * height);

    /// <summary>Prepares.</summary>
    /// <exception cref="JobException">There are too few samples.</exception>
    public static Denoising Create(Scene scene) => scene.Render.SamplesPerPixel > 1
        ? new(scene)
        : throw new JobException(JobFault.Request, "--denoise compares two halves of the samples, but there is only 1 a pixel: give --spp 2 or more");

    /// <summary>The films of the halves.</summary>
    public SampleHalves Films => new([.. _halves.Select(h => h.Film)]);

    /// <summary>The denoised picture; null where the rendering was stopped before both halves had samples.</summary>
    public DenoiseResult? Denoise(int threads, IProgress<double>? progress) =>
        _halves.All(h => h.Film.TotalSamples > 0) ? Denoiser.Denoise(_halves[0], _halves[1], threads, progress: progress) : null;

    /// <summary>Adds the surfaces that a pass has met.</summary>
    /// <param name="pass">The samples of the pass.</param>
    /// <param name="options">How to compute it, with all samples.</param>
    public void Add(SampleRange pass, RenderOptions options)
    {
        (int half, _) = SampleHalves.Turn(pass.First, options.Samples!.Value);
        int count = Math.Min(pass.Count, MostFeatureSamples - _features[half]);
        if (count > 0)
        {
            new FirstHitPass(_scene, options with { Samples = new(pass.First, pass.First + count) }).Render(_halves[half].Features);
            _features[half] += count;
        }
    }
}
