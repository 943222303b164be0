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

        foreach (AuxiliaryImage image in job.Aovs)
        {
            if (image.Complaint(scene) is { } complaint)
            {
                throw new JobException(JobFault.Request, $"--aov {image.Name}: {complaint}");
            }
        }

        Strategies = job.Strategies ? StrategiesOf(scene, Film) : null;
        Light = job.Layers.Count > 0 ? LightOf(job, scene, Film) : null;
        Auxiliary = new(Film, job.Aovs);
        CheckPlanes(job, scene);
    }

    /// <summary>The film.</summary>
    public Film Film { get; }

    /// <summary>The layers of light; null where none are wanted.</summary>
    public LightPathAovFilm? Light { get; }

    /// <summary>What each way to make paths brings; null where nobody asks.</summary>
    public StrategyFilm? Strategies { get; }

    /// <summary>The auxiliary images.</summary>
    public AovFilm Auxiliary { get; }

    // Two halves of the samples, where they are compared or kept; the noise of light, where it is shown.
    private static IReadOnlyList<FilmPlane> PlanesOf(RenderJob job, Scene scene) =>
        FilmPlane.Needed(scene.Render.Integrator, job.Denoise || job.Halves, ShowsNoise(job), job.KeepsAlpha, job.KeepsAlpha && scene.HasMattes);

    private static bool ShowsNoise(RenderJob job) => job.Aovs.OfType<ErrorImage>().Any();

    private static void CheckPlanes(RenderJob job, Scene scene)
    {
        if (job.Resumed is { } film)
        {
            PictureFiles.CheckAlpha(job.Writing, film.Film.Planes, film.Path);
        }

        if (job.Resumed is { Path: var path } resumed && PlanesOf(job, scene).Except(resumed.Film.Planes).ToArray() is [var missing, ..])
        {
            throw missing == FilmPlane.LightSquare ? new(
                JobFault.File, $"'{path}' does not know how noisy its light is, which --aov error shows: render it from scratch with --halves")
                : new JobException(
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
        IReadOnlyList<FilmPlane> planes = PlanesOf(job, scene);
        int atWork = PassCell.BytesPerPixel(planes) + (planes.Contains(FilmPlane.Light) ? SplatSums.BytesPerPixel : 0);
        long bytes = FilmMemory.Bytes(width, height, planes) + ((long)atWork * width * height)
            + AovFilm.Bytes(job.Aovs, width, height) + LightPathAovFilm.Bytes(job.Layers, scene)
            + (job.Strategies && scene.Render.Integrator.Has(IntegratorTraits.TracesLight) ? StrategyFilm.Bytes(scene) : 0)
            + (job.Denoise ? Denoising.Bytes(width, height, FilmPlane.Needed(scene.Render.Integrator, noise: true)) : 0);
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
            throw Refused("--aov", e, hint);
        }
    }

    private static StrategyFilm StrategiesOf(Scene scene, Film film)
    {
        try
        {
            return new(film, scene);
        }
        catch (ArgumentException e)
        {
            throw Refused("--aov strategies", e, "choose one of them with --integrator");
        }
    }

    private static JobException Refused(string option, ArgumentException e, string hint)
    {
        string reason = e.Message.Split(" (Parameter '")[0].TrimEnd('.');
        return new(JobFault.Request, $"{option}: {char.ToLowerInvariant(reason[0])}{reason[1..]}: {hint}");
    }
}
