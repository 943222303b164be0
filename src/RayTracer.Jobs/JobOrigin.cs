using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>The job that a film or an image was made by, as it says itself.</summary>
public static class JobOrigin
{
    /// <summary>The path of the scene of a film or image: where it was, or beside the file.</summary>
    /// <param name="scene">The scene as the command named it, from the folder where that ran.</param>
    /// <param name="file">The film or image.</param>
    /// <param name="outputs">The files that the command wrote, as it named them: with them, <paramref name="file"/> shows from which
    /// folder.</param>
    public static string ScenePath(string scene, string file, IEnumerable<string>? outputs = null)
    {
        string full = Path.GetFullPath(file);
        IEnumerable<string> folders = (outputs ?? [])
            .Select(o => o.StartsWith("./", StringComparison.Ordinal) ? o[2..] : o)
            .Where(o => full.EndsWith(Path.DirectorySeparatorChar + o, StringComparison.Ordinal)).Select(o => full[..^o.Length]);
        string beside = Path.Combine(Path.GetDirectoryName(full)!, Path.GetFileName(scene));
        string? found = folders.Select(f => Path.Combine(f, scene)).Append(scene).Append(beside).FirstOrDefault(File.Exists);
        return found is null || Path.GetFullPath(found) == Path.GetFullPath(scene) ? scene : found;
    }

    /// <summary>The job of a film; the number of its samples is as they were asked for.</summary>
    /// <param name="header">The header of the film's file.</param>
    /// <param name="file">The film's file; null where the scene is not looked for.</param>
    public static RenderJob Of(FilmHeader header, string? file = null) => Put(
        new()
        {
            Scene = file is null ? header.Scene : ScenePath(header.Scene, file),
            Crop = header.Crop,
            Halves = header.Planes.Contains(FilmPlane.Half),
            Alpha = header.Planes.Contains(FilmPlane.Alpha),
        },
        OldFilms.Settings(header), file ?? "the film");

    /// <summary>The job of an image, with the texts that the image has.</summary>
    /// <exception cref="PictureException">It cannot be read.</exception>
    /// <exception cref="JobException">It does not say how it was made.</exception>
    public static (RenderJob Job, IReadOnlyDictionary<string, string> Texts) OfImage(string file)
    {
        Dictionary<string, string> texts = ImageFile.ReadText(file).GroupBy(t => t.Key)
            .ToDictionary(g => g.Key, g => g.First().Value, StringComparer.Ordinal);
        if (!texts.TryGetValue(PictureTexts.CommandKey, out string? line) || Shell.Words(line) is not [_, "render", .. var words])
        {
            throw Unknown(file);
        }

        RenderJob job = OldFilms.OfWords(words, file);
        if (texts.TryGetValue(PictureTexts.SettingsKey, out string? settings))
        {
            job = Put(new() { Scene = job.Scene, Outputs = job.Outputs }, Settings(settings, file), file);
        }

        return (job with { Scene = ScenePath(job.Scene, file, job.Outputs) }, texts);
    }

    private static RenderJob Put(RenderJob job, IEnumerable<string> settings, string file)
    {
        try
        {
            return job.With(settings);
        }
        catch (FormatException e)
        {
            throw NotUnderstood(file, e);
        }
    }

    private static string[] Settings(string json, string file)
    {
        try
        {
            return JsonSerializer.Deserialize<string[]>(json) ?? [];
        }
        catch (JsonException e)
        {
            throw NotUnderstood(file, e);
        }
    }

    /// <summary>The complaint about a file that says nothing of its making.</summary>
    public static JobException Unknown(string file) => new($"'{file}' does not say how it was made: only .rtfilm, {ImageFormat.Endings(ImageFeatures.Texts)} files of render, resume and merge do");

    internal static JobException NotUnderstood(string file, Exception e) =>
        new($"the settings of '{file}' are not understood: {e.Message.TrimEnd('.')}", e);
}
