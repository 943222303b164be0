using System.Globalization;
using System.Text.Json;
using RayTracer.Imaging;

namespace RayTracer.Jobs;

/// <summary>What images say of themselves: pairs of a key and a text.</summary>
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
    public static IReadOnlyList<string> Keys { get; } = ["Software", CommandKey, SettingsKey, "Scene", "Samples", "FilmHash", "SampleRange"];

    /// <summary>The texts of a picture.</summary>
    /// <param name="job">What was rendered.</param>
    /// <param name="hash">The film's hash.</param>
    /// <param name="samples">How many samples the pixels have.</param>
    /// <param name="range">Which ones, where all have the same; else null.</param>
    public static IReadOnlyList<KeyValuePair<string, string>> Of(RenderJob job, string hash, string samples, string? range) =>
    [
        new("Software", ProgramName.Text),
        new(CommandKey, job.Command),
        new(SettingsKey, JsonSerializer.Serialize(job.PictureSettings)),
        new("Scene", Path.GetFileName(job.Scene)),
        new("Samples", samples),
        new("FilmHash", hash),
        .. range is null ? Array.Empty<KeyValuePair<string, string>>() : [new("SampleRange", range)],
    ];

    /// <summary>The texts of a picture of a film.</summary>
    /// <param name="header">What the film's file says.</param>
    /// <param name="hash">The film's hash.</param>
    public static IReadOnlyList<KeyValuePair<string, string>> Of(FilmHeader header, string hash) =>
        Of(JobOrigin.Of(header).WithSamples(header.Total), hash, $"{header.Samples.Sum(r => r.Count)}", header.SamplesText);

    /// <summary>What a frame says of its content.</summary>
    internal static KeyValuePair<string, string>[] Content(string content) => [new(ContentKey, content)];

    /// <summary>What a picture says of its noise.</summary>
    /// <param name="error">The estimated relative error.</param>
    /// <param name="wanted">The wanted one.</param>
    /// <param name="isReached">Whether it is good enough.</param>
    internal static KeyValuePair<string, string>[] Noise(double error, double wanted, bool isReached) =>
        [new(NoiseKey, string.Create(CultureInfo.InvariantCulture, $"{100 * error:G3} % of {100 * wanted:G3} %: {(isReached ? "reached" : NotReached)}"))];
}
