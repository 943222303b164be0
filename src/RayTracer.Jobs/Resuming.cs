using RayTracer.Description;
using RayTracer.Imaging;

namespace RayTracer.Jobs;

/// <summary>Whether samples can be added to a film.</summary>
internal static class Resuming
{
    /// <summary>The complaint about a scene that a film is not of.</summary>
    public static JobException OtherScene(string path) =>
        new(JobFault.File, $"the film is not of '{path}': the scene, a file that it names, its settings, a plug-in or the program are others than they were");

    /// <summary>The header of a film that samples are added to.</summary>
    /// <param name="film">The film.</param>
    /// <param name="header">The header of a new film.</param>
    /// <param name="job">What is rendered.</param>
    /// <param name="scene">Its scene.</param>
    /// <exception cref="JobException">The film is of another picture, or of other samples.</exception>
    public static FilmHeader Header(HeldFilm film, FilmHeader header, RenderJob job, SceneDescription scene)
    {
        FilmHeader old = OldFilms.Current(film.Header, scene, job.Scene, header.Crop);
        if (old.Content != header.Content)
        {
            throw OtherFilm(job, old, scene.Render);
        }

        bool isBegin = old.Samples is [] || (old.Samples is [var held] && held.First == header.Wanted.First && held.End <= header.Wanted.End);
        return isBegin ? header with { Samples = old.Samples, Settings = header.Wanted == old.Wanted ? old.Settings : header.Settings } : throw new JobException(
            JobFault.File, $"'{film.Path}' holds samples {old.SamplesText}, which are not the first of the requested {FilmHeader.Text(header.Wanted)}");
    }

    private static JobException OtherFilm(RenderJob job, FilmHeader header, RenderDescription render) => render.Sampler.DependsOnCount && render.SamplesPerPixel != header.Total
        ? new(JobFault.Request, $"--spp {render.SamplesPerPixel}: the places of the {render.Sampler.ToString().ToLowerInvariant()} sampler's samples depend on how many there are, "
            + $"so that a film of {header.Total} cannot be given more or fewer: render it from scratch, or with --sampler sobol")
        : OtherScene(job.Scene);
}
