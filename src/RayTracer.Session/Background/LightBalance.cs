using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Balances the lights of a rendered picture that has a layer for each, as <c>raytracer compose</c> does.</summary>
/// <param name="document">What is rendered; files are meant from its folder.</param>
/// <param name="view">The picture, and how light is brought onto the screen.</param>
/// <param name="jobs">Where the work goes on.</param>
public sealed class LightBalance(SceneDocument document, PictureView view, JobList jobs)
{
    private const float MostFactor = 1e6f;
    private LightMix? _mix;

    /// <summary>Renders what the view shows anew, into an OpenEXR file with a layer for each light, as a job.</summary>
    /// <param name="path">The file; relative to the document's folder.</param>
    /// <param name="overwrite">Whether a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">The scene's lights cannot be told apart, or there is such a file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Render(string path, bool overwrite)
    {
        string full = Whole(path);
        if (!ImageFormat.Has(full, ImageFeatures.Layers))
        {
            throw new SessionException($"Layers of light are written to {ImageFormat.Endings(ImageFeatures.Layers)} files.");
        }

        Check(full, overwrite);
        (Scene scene, ViewSettings settings) = (view.RequireShown().Scene, view.Settings);
        Film film = FilmBudget.Create(scene.Render.Width, scene.Render.Height);
        LightLayerFilm layers = Layers(film, scene);
        RenderJob job = ViewJob.Of(document.Place, document.Read.Description, settings, Tone.Plain, full) with { Layers = [LightLayer.Lights] };
        return jobs.Start($"lights: {Path.GetFileName(full)}", (progress, cancellation) =>
        {
            BackgroundRenders.Render(scene, new() { Threads = settings.Threads, Crop = settings.Region, Layers = layers }, progress, cancellation, film);
            ImageFile.Write(full, film, new() { Metadata = PictureTexts.Of(job, film.ComputeHash(), $"{scene.Render.SamplesPerPixel}", null), ExrLayers = AovFiles.Layers(layers) });
            return $"wrote {full}";
        });
    }

    /// <summary>Opens a picture.</summary>
    /// <returns>The names of its lights.</returns>
    /// <exception cref="SessionException">It has no layers of lights.</exception>
    public IReadOnlyList<string> Open(string path)
    {
        try
        {
            LightMix mix = LightMix.Open(File.ReadAllBytes(Whole(path)));
            _mix = mix;
            return mix.Lights;
        }
        catch (PictureException e)
        {
            throw new SessionException($"The lights of '{path}' cannot be balanced: {e.Message.TrimEnd('.')}.", e);
        }
    }

    /// <summary>The picture with its lights balanced, as a PNG to look at.</summary>
    /// <param name="factors">What lights are multiplied by: red, green and blue; others stay.</param>
    /// <exception cref="SessionException">No picture is open.</exception>
    public byte[] Png(IReadOnlyDictionary<string, float[]> factors) =>
        ImageFile.Encode(".png", Compose(factors), new() { Exposure = view.Tone.Exposure, ToneMap = view.Tone.ToneMap });

    /// <summary>Writes the picture with its lights balanced, as a job.</summary>
    /// <param name="path">The file; relative to the document's folder.</param>
    /// <param name="factors">As for <see cref="Png"/>.</param>
    /// <param name="overwrite">Whether a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">No picture is open, or there is such a file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Save(string path, IReadOnlyDictionary<string, float[]> factors, bool overwrite)
    {
        string full = Whole(path);
        Check(full, overwrite);
        Picture picture = Compose(factors);
        Tone tone = view.Tone;
        return jobs.Start($"writing {Path.GetFileName(full)}", (_, _) =>
        {
            ImageFile.Write(full, picture, new() { Exposure = tone.Exposure, ToneMap = tone.ToneMap, Metadata = [new("Software", ProgramName.Text)] });
            return $"wrote {full}";
        });
    }

    private static LightLayerFilm Layers(Film film, Scene scene)
    {
        try
        {
            return new(film, scene, [LightLayer.Lights]);
        }
        catch (ArgumentException e)
        {
            throw new SessionException(e.Message.Split(" (Parameter '")[0], e);
        }
    }

    private static void Check(string full, bool overwrite)
    {
        ImageFile.Check(full);
        if (!overwrite && File.Exists(full))
        {
            throw new SessionException($"The file '{full}' exists already.", SessionFault.Conflict);
        }
    }

    private Picture Compose(IReadOnlyDictionary<string, float[]> factors)
    {
        LightMix mix = _mix ?? throw new SessionException("No picture with layers of lights is open.", SessionFault.Missing);
        return factors.Values.All(f => f.Length == 3 && f.All(x => x is >= 0 and <= MostFactor))
            ? mix.Compose(light => factors.TryGetValue(light, out float[]? f) ? new(f[0], f[1], f[2]) : Rgb.White)
            : throw new SessionException("Lights are multiplied by three numbers from 0 to 1000000.");
    }

    private string Whole(string path) => string.IsNullOrWhiteSpace(path) || path.Contains('\0', StringComparison.Ordinal)
        ? throw new SessionException("A file needs a name.")
        : Path.GetFullPath(path, Path.GetFullPath(document.Place.Folder is "" ? "." : document.Place.Folder));
}
