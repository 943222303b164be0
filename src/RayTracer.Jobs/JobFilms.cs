using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>
/// The films that a job renders into: the picture's, auxiliary images and layers of light.
/// </summary>
internal sealed class JobFilms
{
    /// <summary>Prepares them.</summary>
    /// <param name="job">The job to render.</param>
    /// <param name="scene">Its scene.</param>
    /// <exception cref="JobException">They cannot be had, or there is not enough memory.</exception>
    public JobFilms(RenderJob job, Scene scene)
    {
        Film = job.Resumed?.Film ?? FilmOf(job, scene);
        if ((Film.Width, Film.Height) != (scene.Render.Width, scene.Render.Height))
        {
            throw LoadedJob.OtherScene(job.Scene);
        }

        Light = job.Layers.Count > 0 ? LightOf(job, scene, Film) : null;
        Auxiliary = new(Film, job.Aovs);
        CheckHalves(job, scene);
    }

    /// <summary>The film.</summary>
    public Film Film { get; }

    /// <summary>The layers of light; null where none are wanted.</summary>
    public LightPathAovFilm? Light { get; }

    /// <summary>The auxiliary images.</summary>
    public AovFilm Auxiliary { get; }

    // Two halves of the samples, where they are compared or kept.
    private static IReadOnlyList<FilmPlane> PlanesOf(RenderJob job) => job.Denoise || job.Halves ? [FilmPlane.Half] : [];

    private static void CheckHalves(RenderJob job, Scene scene)
    {
        if (PlanesOf(job).Except(job.Resumed?.Film.Planes ?? PlanesOf(job)).Any())
        {
            string path = job.Resumed!.Path;
            throw new JobException(
                JobFault.File,
                $"'{path}' does not keep two halves of its samples, which --denoise compares: render it from scratch with --halves, "
                + $"or estimate its noise otherwise, which is worse: \"raytracer denoise {path}\"");
        }

        if (job.Denoise && scene.Render.SamplesPerPixel < 2)
        {
            throw new JobException(
                JobFault.Request, "--denoise compares two halves of the samples, but there is only 1 a pixel: give --spp 2 or more");
        }
    }

    private static Film FilmOf(RenderJob job, Scene scene)
    {
        (int width, int height) = (scene.Render.Width, scene.Render.Height);
        IReadOnlyList<FilmPlane> planes = PlanesOf(job);
        long bytes = FilmMemory.Bytes(width, height, planes) + ((long)PassCell.BytesPerPixel * width * height)
            + AovFilm.Bytes(job.Aovs, width, height) + LightPathAovFilm.Bytes(job.Layers, scene) + (job.Denoise ? Denoising.Bytes(width, height) : 0);
        long available = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        return bytes <= available && (long)width * height <= Film.MaxPixels ? new(width, height, planes) : throw new JobException(
            JobFault.File, $"a film of {width}×{height} pixels takes {FilmMemory.Text(bytes)} of memory, more than is available ({FilmMemory.Text(available)})");
    }

    private static LightPathAovFilm LightOf(RenderJob job, Scene scene, Film film)
    {
        try
        {
            return new(film, scene, job.Layers);
        }
        catch (ArgumentException e)
        {
            string hint = scene.Render.Integrator.Has(IntegratorTraits.Layers) ? "give several of them one \"lightGroup\""
                : "choose another --integrator";
            string reason = e.Message.Split(" (Parameter '")[0].TrimEnd('.');
            throw new JobException(JobFault.Request, $"--aov: {char.ToLowerInvariant(reason[0])}{reason[1..]}: {hint}");
        }
    }
}
