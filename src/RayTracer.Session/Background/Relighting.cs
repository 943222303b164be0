using System.Globalization;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Balances the lights of a rendered picture that has a layer for each, as <c>raytracer compose</c> does.</summary>
/// <param name="document">The document that is rendered; files are meant from its folder.</param>
/// <param name="view">The picture, and how light is brought onto the screen.</param>
/// <param name="jobs">The list of what is being done.</param>
public sealed class Relighting(SceneDocument document, PictureView view, JobList jobs)
{
    private const float MostFactor = 1e6f;
    private readonly ViewJobs _jobs = new(document, view, jobs);
    private RelightableImage? _mix;
    private string _path = "";

    /// <summary>Renders what the view shows into an OpenEXR file with a layer for each light, as a job.</summary>
    /// <param name="path">The file; relative to the document's folder.</param>
    /// <param name="overwrite">True if a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">The scene's lights cannot be separated, or there is such a file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Render(string path, bool overwrite)
    {
        string full = _jobs.Whole(path);
        if (!ImageFormat.Has(full, ImageFeatures.Layers))
        {
            throw new SessionException($"Layers of light are written to {ImageFormat.Endings(ImageFeatures.Layers)} files.");
        }

        RenderJob job = _jobs.Shown(full) with { Layers = [LightPathAov.Lights], Writing = new() };
        ViewJobs.Check(job, overwrite);
        CheckLights(view.RequireShown().Scene);
        return _jobs.Render($"lights: {Path.GetFileName(full)}", job, $"wrote {full}");
    }

    /// <summary>Opens a picture.</summary>
    /// <returns>The names of its lights.</returns>
    /// <exception cref="SessionException">It has no layers of lights.</exception>
    public IReadOnlyList<string> Open(string path)
    {
        try
        {
            string full = _jobs.Whole(path);
            RelightableImage mix = RelightableImage.Open(File.ReadAllBytes(full));
            (_mix, _path) = (mix, full);
            return mix.Lights;
        }
        catch (PictureException e)
        {
            throw new SessionException($"The lights of '{path}' cannot be balanced: {e.Message.TrimEnd('.')}.", e);
        }
    }

    /// <summary>The picture with its lights balanced, as a PNG to look at.</summary>
    /// <param name="factors">The factors on lights: red, green and blue; others stay.</param>
    /// <exception cref="SessionException">No picture is open.</exception>
    public byte[] Png(IReadOnlyDictionary<string, float[]> factors) =>
        ImageFile.Encode(".png", Compose(factors), view.Tone.Writing);

    /// <summary>Writes the picture with its lights balanced, as a job.</summary>
    /// <param name="path">The file; relative to the document's folder.</param>
    /// <param name="factors">As for <see cref="Png"/>.</param>
    /// <param name="overwrite">True if a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">No picture is open, or there is such a file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Save(string path, IReadOnlyDictionary<string, float[]> factors, bool overwrite)
    {
        string full = _jobs.Whole(path);
        RenderJob job = _jobs.Saved(full);
        ViewJobs.Check(job, overwrite);
        Picture picture = Compose(factors);
        ImageWriteOptions writing = view.Tone.Writing with { Metadata = PictureTexts.Of(Command(factors, full)) };
        return _jobs.Start($"writing {Path.GetFileName(full)}", watch =>
        {
            JobFiles.Write([full], picture, writing, watch);
            watch.RequireWritten();
            return $"wrote {full}";
        });
    }

    // The command that would do the same.
    private string Command(IReadOnlyDictionary<string, float[]> factors, string output) => Shell.Command(
    [
        "compose", _path,
        .. factors.SelectMany(
            f => new[] { "--light", string.Create(CultureInfo.InvariantCulture, $"{f.Key}={f.Value[0]},{f.Value[1]},{f.Value[2]}") }),
        "-o", output,
    ]);

    private static void CheckLights(Scene scene)
    {
        try
        {
            LightPathAovFilm.NamesOf(scene, [LightPathAov.Lights]);
        }
        catch (ArgumentException e)
        {
            throw new SessionException(e.Message.Split(" (Parameter '")[0], e);
        }
    }

    private Picture Compose(IReadOnlyDictionary<string, float[]> factors)
    {
        RelightableImage mix = _mix ?? throw new SessionException("No picture with layers of lights is open.", SessionFault.Missing);
        return factors.Values.All(f => f.Length == 3 && f.All(x => x is >= 0 and <= MostFactor))
            ? mix.Compose(light => factors.TryGetValue(light, out float[]? f) ? new(f[0], f[1], f[2]) : Rgb.White)
            : throw new SessionException("Lights are multiplied by three numbers from 0 to 1000000.");
    }
}
