using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Jobs;

/// <summary>
/// Films and images of the first format: in place of settings they hold words of the command line, and their content hash counts every
/// parameter and the version of the program.
/// Their samples go with new ones wherever the bits are the same.
/// </summary>
public static class OldFilms
{
    private const string Software = "raytracer 0.1.0";

    /// <summary>The settings of a film of either format.</summary>
    public static IReadOnlyList<string> Settings(FilmHeader header) =>
        header.Words is { } words ? OfWords(["", .. words], "the film").PictureSettings : header.Settings;

    /// <summary>The job of the words after <c>render</c>.</summary>
    /// <exception cref="JobException">They are not understood, or there is no scene.</exception>
    public static RenderJob OfWords(IReadOnlyList<string> words, string file)
    {
        RenderJob job = new() { Scene = "" };
        string? scene = null;
        List<(JobOption Option, string Word)> values = [];
        for (int i = 0; i < words.Count; i++)
        {
            string[] parts = words[i].StartsWith("--", StringComparison.Ordinal) ? words[i].Split('=', 2) : [words[i]];
            if (parts[0] is "-o" or "--output")
            {
                job = job with { Outputs = [.. job.Outputs, parts.Length > 1 || i + 1 == words.Count ? parts[^1] : words[++i]] };
            }
            else if (JobOptions.Find(parts[0]) is { } option)
            {
                values.Add((option, parts.Length > 1 || option.Form is null || i + 1 == words.Count ? parts[^1] : words[++i]));
            }
            else if (!words[i].StartsWith('-'))
            {
                scene ??= words[i];
            }
        }

        // Options went before settings.
        job = values.OrderByDescending(v => v.Option.IsRepeated).Aggregate(job, (all, v) => Put(all, v.Option, v.Word, file));
        return scene is null ? throw new JobException($"'{file}' does not say which scene it shows") : job with { Scene = scene };
    }

    /// <summary>
    /// Returns what a film of the first format would say of itself now, if it is of the same picture; any other film as it is.
    /// </summary>
    /// <param name="header">The header of its file.</param>
    /// <param name="scene">The picture's scene.</param>
    /// <param name="path">The scene's file.</param>
    /// <param name="crop">The part of the picture.</param>
    /// <exception cref="JobException">It is of the same picture, whose bits have changed since.</exception>
    public static FilmHeader Current(FilmHeader header, SceneDescription scene, string path, Tile? crop)
    {
        string old = header.Words is null ? "" : Content(scene, path, crop);
        if (header.Words is null || !header.Content.StartsWith(old, StringComparison.Ordinal))
        {
            return header;
        }

        CheckBits(scene, "the film");
        return header with { Content = ContentHash.Of(scene, path, crop) + header.Content[old.Length..], Settings = Settings(header), Words = null };
    }

    /// <summary>As the other one, of a film whose scene is not loaded yet; where that cannot be found, the film stays as it is.</summary>
    public static FilmHeader Current(FilmHeader header, string file)
    {
        RenderJob job = JobOrigin.Of(header, file);
        return header.Words is not null && SceneLoader.Read(job.Scene, job.Settings, job.Frame).Description is { } scene
            ? Current(header, scene, job.Scene, header.Crop) : header;
    }

    /// <summary>Refuses a picture of the first format whose bits have changed since.</summary>
    /// <exception cref="JobException">They have.</exception>
    public static void CheckBits(SceneDescription scene, string file)
    {
        if (BitVersions.Of(scene) is { Count: > 0 } kinds)
        {
            throw new JobException($"{file} was rendered before a fault was mended: the bits of scenes with {string.Join(" or ", kinds.Select(k => k.Name))} are others now");
        }
    }

    /// <summary>The content hash of the first format.</summary>
    public static string Content(SceneDescription scene, string path, Tile? crop)
    {
        using OldHash hash = new(Path.GetDirectoryName(path) ?? "");
        return hash.Of(scene, crop);
    }

    /// <summary>The content hash of a whole picture of the first format; empty where its bits have changed since.</summary>
    public static string OfPicture(SceneDescription scene, string path, Tile? crop) =>
        BitVersions.Of(scene).Count > 0 || ContentHash.Tone(scene.Render).Length > 0 ? ""
            : string.Create(CultureInfo.InvariantCulture, $"{Content(scene, path, crop)}-{scene.Render.SamplesPerPixel}");

    private static RenderJob Put(RenderJob job, JobOption option, string word, string file)
    {
        try
        {
            return option.Put(job, word);
        }
        catch (FormatException e)
        {
            throw JobOrigin.NotUnderstood(file, e);
        }
    }

    // All parameters that there were; later ones have no effect where they are as without them.
    private sealed class OldHash(string folder) : ContentHash(folder)
    {
        // Parameters that came after the first format: they count only where they are given.
        private static readonly string[] s_later =
            ["mergeRadius", "splitting", "straightThrough", "hideLights", "colorAttribute", "luminance", "density", "noise", "albedoGrid",
             "playback", "variant", "values", "picture", "pictureUp",
             "refinement", "faceOfTriangle", "smooth", "emission", "emissionGrid", "mapping", "cloud", "phase", "secondColorAttribute", "second",
             "temperatureGrid", "temperatureOffset", "temperatureScale", "iridescence", "filmThickness", "filmIndex"];

        public string Of(SceneDescription scene, Tile? crop)
        {
            Text(Software);
            Text($"{crop}");
            return Of(scene);
        }

        private protected override bool Counts(RecordParameter parameter, object? value) => !s_later.Contains(parameter.Key) || base.Counts(parameter, value);

        private protected override void EndRecord()
        {
        }
    }
}
