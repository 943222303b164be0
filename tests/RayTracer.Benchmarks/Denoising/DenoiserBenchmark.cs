using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Benchmarks.Denoising;

/// <summary>Errors before and after denoising, against converged pictures of another seed, as the table of docs/denoiser.md.</summary>
internal static class DenoiserBenchmark
{
    private const int Width = 150;
    private const int Height = 112;

    // A square, for the jittered sampler.
    private const int ReferenceSamples = 2304;

    /// <summary>Measures scenes.</summary>
    /// <param name="names">Their names; none for all, <c>checks</c> for those that settings were not chosen on.</param>
    public static int Run(string[] names)
    {
        Console.WriteLine("| scene | samples | relative MSE | denoised | ratio | FLIP | denoised | light cut | processor time a megapixel |");
        Console.WriteLine("|---|---|---|---|---|---|---|---|---|");
        foreach ((string Name, string Content) scene in Chosen(names))
        {
            Picture reference = new RTracer(DenoiserScenes.Build(scene, Width, Height, ReferenceSamples, 77)).Render().Film.ToPicture();
            foreach (int samples in new[] { 4, 16, 64 })
            {
                Console.WriteLine($"| {scene.Name} | {samples} | {Row(DenoiserScenes.Build(scene, Width, Height, samples, 1), reference)} |");
            }
        }

        return 0;
    }

    private static IEnumerable<(string Name, string Content)> Chosen(string[] names) => names switch
    {
        [] => DenoiserScenes.All,
        ["checks"] => DenoiserScenes.Checks,
        _ => DenoiserScenes.All.Concat(DenoiserScenes.Checks).Where(s => names.Contains(s.Name)),
    };

    private static string Row(Scene scene, Picture reference)
    {
        Film film = new(Width, Height, FilmPlane.Half);
        new RTracer(scene).Render(film);
        (HalfRender first, HalfRender second) = HalfRender.Of(scene, new(), film);
        TimeSpan before = Environment.CpuUsage.TotalTime;
        DenoiseResult result = Denoiser.Denoise(first, second, 1);
        double seconds = (Environment.CpuUsage.TotalTime - before).TotalSeconds;
        (double noisy, double noisyFlip) = Errors(film.ToPicture(), reference);
        (double denoised, double denoisedFlip) = Errors(result.Picture, reference);
        return $"{noisy:F5} | {denoised:F5} | {denoised / noisy:F2} | {noisyFlip:F3} | {denoisedFlip:F3} | {result.CutShare:P1} | {seconds * 1e6 / (Width * Height):F1} s";
    }

    private static (double RelativeMse, double Flip) Errors(Picture image, Picture reference) =>
        (ImageComparison.Compare(image, reference).RelativeMse, FlipError.Compare(image, reference, FlipError.StandardPixelsPerDegree).Mean);
}
