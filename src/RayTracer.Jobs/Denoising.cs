using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>Keeps two halves of a picture's samples apart while it is rendered, and denoises it. The film is the same to the bit as without.</summary>
internal sealed class Denoising
{
    // So many samples of a half know the surfaces well enough.
    private const int MostFeatureSamples = 64;

    // Samples of both halves together.
    private const int LongestTurns = 128;
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

    /// <summary>
    /// Returns the half that a sample belongs to, and where its turn ends. Turns become longer, so that both halves have samples soon, and
    /// yet there are few; they do not depend on how long passes take.
    /// </summary>
    /// <param name="first">The sample.</param>
    /// <param name="all">All samples.</param>
    public static (int Half, int End) Turn(int first, SampleRange all)
    {
        int since = first - all.First;
        int begin = since < 2 ? 0 : since < LongestTurns ? 1 << int.Log2(since) : since / LongestTurns * LongestTurns;
        int end = Math.Min(all.Count, begin + Math.Clamp(begin, 2, LongestTurns));
        int middle = (begin + end + 1) / 2;
        return since < middle ? (0, all.First + middle) : (1, all.First + end);
    }

    /// <summary>Adds a pass over samples of one half.</summary>
    /// <param name="pass">The samples.</param>
    /// <param name="half">The half.</param>
    /// <param name="options">Which they are.</param>
    public void Add(Film pass, int half, RenderOptions options)
    {
        _halves[half].Film.Merge(pass);
        AddFeatures(half, options);
    }

    /// <summary>Renders all samples in one go, where there can be no passes.</summary>
    /// <param name="film">Takes the picture.</param>
    /// <param name="loaded">What to render.</param>
    /// <param name="plan">The numbers of samples of the pixels; null where all have the same.</param>
    public RenderStatistics Render(Film film, LoadedJob loaded, SamplePlan? plan)
    {
        SampleRange all = plan is null ? loaded.Samples : new(0, plan.Fewest);
        int middle = all.First + (all.Count / 2);
        RenderOptions[] options = [.. new SampleRange[] { new(all.First, middle), new(middle, all.End) }.Select(r => loaded.Options with { Samples = r })];
        (Film first, Film second) = (_halves[0].Film, _halves[1].Film);
        RenderStatistics statistics = plan is null
            ? new RTracer(_scene, options[0]).Render(first, loaded.Progress, loaded.Cancellation)
            : new PlannedRender(_scene, loaded.Options, plan).Render(first, second, loaded.Progress, loaded.Cancellation);
        if (plan is null && !statistics.Cancelled)
        {
            statistics += new RTracer(_scene, options[1]).Render(second, loaded.Progress, loaded.Cancellation);
        }

        film.Merge(first);
        film.Merge(second);
        AddFeatures(0, options[0]);
        AddFeatures(1, options[1]);
        return statistics;
    }

    /// <summary>The denoised picture; null where the rendering was stopped before both halves had samples.</summary>
    public DenoiseResult? Denoise(int threads, IProgress<double>? progress) =>
        _halves.All(h => h.Film.TotalSamples > 0) ? Denoiser.Denoise(_halves[0], _halves[1], threads, progress: progress) : null;

    // A moment's work, without which the samples would be worth nothing here: so it is not cancelled.
    private void AddFeatures(int half, RenderOptions options)
    {
        SampleRange samples = options.Samples!.Value;
        int count = Math.Min(samples.Count, MostFeatureSamples - _features[half]);
        if (count > 0)
        {
            new FirstHitPass(_scene, options with { Samples = new(samples.First, samples.First + count) }).Render(_halves[half].Features);
            _features[half] += count;
        }
    }
}
