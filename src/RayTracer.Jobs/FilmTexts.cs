using RayTracer.Imaging;

namespace RayTracer.Jobs;

/// <summary>What images of films say of themselves.</summary>
public static class FilmTexts
{
    /// <summary>The texts of an image of a film.</summary>
    /// <param name="header">What the film's file says.</param>
    /// <param name="hash">The film's hash.</param>
    public static IReadOnlyList<KeyValuePair<string, string>> Of(FilmHeader header, string hash) =>
    [
        new("Software", ProgramName.Text),
        new("Command", Shell.Command(["render", header.Scene, .. Words(header, header.Total), .. CropWords(header)])),
        new("Scene", Path.GetFileName(header.Scene)),
        new("Samples", $"{header.Samples.Sum(r => r.Count)}"),
        new("FilmHash", hash),
        new("SampleRange", header.SamplesText),
    ];

    /// <summary>The options that replaced what the scene's file said, with as many samples a pixel as the whole picture has, whatever decided on them.</summary>
    public static IReadOnlyList<string> Words(FilmHeader header, int total) =>
        [.. header.Overrides.Chunk(2).Where(option => option[0] is not ("--spp" or "--noise")).SelectMany(option => option), "--spp", $"{total}"];

    /// <summary>The options that say which part of the picture a film is of.</summary>
    public static string[] CropWords(FilmHeader header) => header.Crop is { } c ? ["--crop", $"{c.X},{c.Y},{c.Width},{c.Height}"] : [];
}
