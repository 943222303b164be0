using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>Finds out whether a file already holds the picture of a job, whole.</summary>
public static class FinishedPicture
{
    /// <summary>Returns whether an image file holds the picture of a job.</summary>
    /// <param name="file">The image file.</param>
    /// <param name="job">The job; scene, files to write, and all that the content says do not count.</param>
    /// <param name="scene">The job's scene.</param>
    /// <returns>False also where there is no file, or something else or a damaged one.</returns>
    public static bool Is(string file, RenderJob job, SceneDescription scene) => Holds(file, f =>
    {
        (RenderJob made, IReadOnlyDictionary<string, string> texts) = JobOrigin.OfImage(f);
        string content = texts.ContainsKey(PictureTexts.SettingsKey) ? ContentHash.OfPicture(scene, job.Scene, job.Crop)
            : OldFilms.OfPicture(scene, job.Scene, job.Crop);

        // Texts stand before the pixels, which may be missing.
        return texts.GetValueOrDefault(PictureTexts.ContentKey) == content && Looks(made, scene).SequenceEqual(Looks(job, scene))
            && ImageFile.Read(f).Width > 0;
    });

    /// <summary>Returns whether an image file says that the wanted noise was not reached.</summary>
    /// <param name="file">The image file.</param>
    public static bool IsNoisy(string file) => Holds(file, f => ImageFile.ReadText(f).Any(
        t => t.Key == PictureTexts.NoiseKey && t.Value.EndsWith(PictureTexts.NotReached, StringComparison.Ordinal)));

    /// <summary>Returns whether a film holds the picture of a job.</summary>
    /// <param name="file">The film.</param>
    /// <param name="job">The job.</param>
    /// <param name="scene">The job's scene.</param>
    /// <param name="wanted">The samples; null for those that the film was to have.</param>
    /// <returns>False also where there is no file, or something else or a damaged one.</returns>
    public static bool IsFilm(string file, RenderJob job, SceneDescription scene, SampleRange? wanted) => Holds(file, f =>
        OldFilms.Current(FilmFile.ReadHeader(f), scene, job.Scene, job.Crop) is { IsComplete: true } header
            && Guidance.Unguided(header.Content) == Edition.Content(ContentHash.Of(scene, job.Scene, job.Crop), Edition.For(job.Edition, scene.Render)) && Guidance.IsGuided(header.Content) == job.Guide
        && header.Planes.SequenceEqual(job.Planes(scene.Render.Integrator, header.Planes.Contains(FilmPlane.Matte))) && (wanted is null || header.Wanted == wanted) && FilmFile.Read(f).Film.Width > 0);

    private static IEnumerable<string> Looks(RenderJob job, SceneDescription scene)
    {
        RenderJob shown = job with { Frames = null, Writing = job.Writing.For(scene.Render) };
        return JobOptions.Kept(shown with { Crop = null }, JobOptionUse.Pictures).Concat(JobOptions.Kept(shown, JobOptionUse.Films));
    }

    private static bool Holds(string file, Predicate<string> read)
    {
        // An output that is looked at counts as no input.
        using InputFiles looked = InputFiles.Begin();
        try
        {
            return File.Exists(file) && read(file);
        }
        catch (Exception e) when (e is PictureException or JobException)
        {
            return false;
        }
    }
}
