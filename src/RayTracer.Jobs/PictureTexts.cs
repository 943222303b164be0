using System.Globalization;
using System.Text.Json;
using RayTracer.Imaging;

namespace RayTracer.Jobs;

/// <summary>The texts that images hold: pairs of a key and a text.</summary>
public static class PictureTexts
{
    /// <summary>The key of the settings, a list in JSON.</summary>
    public const string SettingsKey = "Settings";

    /// <summary>The key of the command.</summary>
    public const string CommandKey = "Command";

    /// <summary>The key of the hash of what decides on the picture (<see cref="ContentHash.OfPicture"/>), of frames.</summary>
    public const string ContentKey = "Content";

    /// <summary>The key of how noisy it is, where a noise was wanted.</summary>
    public const string NoiseKey = "Noise";

    /// <summary>The end of the text of a picture that is noisier than wanted.</summary>
    internal const string NotReached = "not reached";

    /// <summary>The keys of what is said of each picture.</summary>
    public static IReadOnlyList<string> Keys { get; } = ["Software", CommandKey, SettingsKey, "Scene", "Samples", "FilmHash", "SampleRange", PictureTone.Key];

    /// <summary>The texts of a picture.</summary>
    /// <param name="job">The job that rendered it.</param>
    /// <param name="hash">The film's hash.</param>
    /// <param name="samples">The number of samples of each pixel, in words.</param>
    /// <param name="range">Which ones, where all have the same; else null.</param>
    private static IReadOnlyList<KeyValuePair<string, string>> Of(RenderJob job, string hash, string samples, string? range) =>
    [
        new("Software", ProgramName.Text),
        new(CommandKey, job.Command),
        new(SettingsKey, JsonArray(job.PictureSettings)),
        new("Scene", Path.GetFileName(job.Scene)),
        new("Samples", samples),
        new("FilmHash", hash),
        .. range is null ? Array.Empty<KeyValuePair<string, string>>() : [new("SampleRange", range)],
    ];

    /// <summary>The texts of a picture of a film.</summary>
    /// <param name="header">The header of the film's file.</param>
    /// <param name="hash">The film's hash.</param>
    public static IReadOnlyList<KeyValuePair<string, string>> Of(FilmHeader header, string hash) =>
    [
        .. Of(JobOrigin.Of(header).WithSamples(header.Total), hash, $"{header.Samples.Sum(r => r.Count)}", header.SamplesText),
        .. OfTone(header.Tone),
    ];

    /// <summary>The text of how a display shows a picture, if there is one.</summary>
    internal static IEnumerable<KeyValuePair<string, string>> OfTone(string? tone) => tone is null ? [] : [new(PictureTone.Key, tone)];

    /// <summary>The texts of a picture that a job made.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Of(RenderJob job, JobResult result)
    {
        string unfinished = result.Statistics.Cancelled ? $", unfinished: {result.Statistics.Paths} paths" : "";
        List<KeyValuePair<string, string>> texts = [.. Of(job, result.Hash, result.SamplesText + unfinished, result.RangeText)];
        if (result.Plan is { } plan && job.Noise is { } wanted)
        {
            string outcome = result.IsNoisy(job) ? NotReached : "reached";
            texts.Add(
                new(NoiseKey, string.Create(CultureInfo.InvariantCulture, $"{100 * plan.Error:G3} % of {100 * wanted:G3} %: {outcome}")));
        }

        if (job.IsOfSequence && result.Description is { } scene)
        {
            texts.Add(new(ContentKey, ContentHash.OfPicture(scene, job.Scene, job.Crop)));
        }

        return texts;
    }

    /// <summary>The texts of a picture that is not a rendering but was made by a command.</summary>
    /// <param name="command">The command, as it is typed.</param>
    /// <param name="scene">The scene's file; null for none.</param>
    public static IReadOnlyList<KeyValuePair<string, string>> Of(string command, string? scene = null) =>
    [
        new("Software", ProgramName.Text),
        new(CommandKey, command),
        .. scene is null ? Array.Empty<KeyValuePair<string, string>>() : [new("Scene", Path.GetFileName(scene))],
    ];

    // Without the serializer, whose start takes longer than a small picture.
    private static string JsonArray(IEnumerable<string> texts) => $"[{string.Join(',', texts.Select(t => $"\"{JsonEncodedText.Encode(t)}\""))}]";
}
