using System.CommandLine;
using RayTracer.Imaging;

namespace RayTracer.Cli;

/// <summary>The options of verbs that write pictures.</summary>
internal sealed class WritingOptions
{
    private readonly Option<string[]> _outputs = new("-o", "--output") { HelpName = "FILE" };
    private readonly ParsedOption<double?> _exposure = OptionValues.Number(
        "--exposure", $"{ImageFormat.Names(ImageFeatures.Display)}: exposure in stops (each doubles the light).",
        -100, 100);
    private readonly ParsedOption<ToneMap?> _toneMap = OptionValues.Choice<ToneMap>(
        "--tonemap", $"{ImageFormat.Names(ImageFeatures.Display)}: how bright light is compressed into what a screen can show; clamp cuts it off.");
    private readonly ParsedOption<int?> _bitDepth = OptionValues.Choice<int?>(
        "--bit-depth", $"{ImageFormat.Names(ImageFeatures.BitDepth)}: bits per channel. Default: 8.", ["8", "16"], [8, 16]);
    private readonly ParsedOption<long?> _quality = OptionValues.Integer(
        "--quality", $"{ImageFormat.Names(ImageFeatures.Quality)}: from smallest file to best picture. Default: {JpegWriter.StandardQuality}.",
        1, 100);
    private readonly ParsedOption<JpegChroma?> _chroma = OptionValues.Choice<JpegChroma>(
        "--chroma", $"{ImageFormat.Names(ImageFeatures.Chroma)}: colours for each pixel, or one for every four. Default: full from quality 90 up.");

    /// <summary>Makes the options, for a command that takes the file otherwise: those of <see cref="Looks"/> only.</summary>
    public WritingOptions()
    {
        Output = _outputs;
        Looks = [_exposure.Symbol, _toneMap.Symbol, _bitDepth.Symbol, _quality.Symbol, _chroma.Symbol];
    }

    /// <summary>Gives a command the options.</summary>
    /// <param name="command">The command.</param>
    /// <param name="outputs">What the files are; null for images or the film itself.</param>
    public WritingOptions(Command command, string? outputs = null)
        : this()
    {
        _outputs.Description = outputs
            ?? $"The file to write: {ImageFormat.Endings()}, or .rtfilm for the film itself. Repeatable.";
        command.Options.Add(_outputs);
    }

    /// <summary>The option of the files.</summary>
    public Option Output { get; }

    /// <summary>The options of how pictures look.</summary>
    public IReadOnlyList<Option> Looks { get; }

    /// <summary>The option of verbs that have the film itself: whether .exr files carry it. It is none of <see cref="Looks"/>.</summary>
    public Option<bool> ExrFilm { get; } = new("--exr-film") { Description = "OpenEXR: the image carries the film itself, which resume can continue, as it can an .rtfilm." };

    /// <summary>The files.</summary>
    public IReadOnlyList<string> Files(ParseResult result) => result.GetValue(_outputs) ?? [];

    /// <summary>Warns of options of how pictures look that were given, but change none of the files.</summary>
    /// <param name="result">What was given.</param>
    /// <param name="files">The files to write.</param>
    /// <param name="streams">Takes the warnings.</param>
    /// <param name="isSeen">Whether exposure and tone map are seen elsewhere too.</param>
    public void WarnOfUnused(ParseResult result, IReadOnlyList<string> files, Streams streams, bool isSeen = false)
    {
        foreach (Option option in isSeen ? [] : new Option[] { _exposure.Symbol, _toneMap.Symbol })
        {
            WarnOfUnused(result, option, ImageFeatures.Display, files, streams);
        }

        WarnOfUnused(result, _bitDepth.Symbol, ImageFeatures.BitDepth, files, streams);
        WarnOfUnused(result, _quality.Symbol, ImageFeatures.Quality, files, streams);
        WarnOfUnused(result, _chroma.Symbol, ImageFeatures.Chroma, files, streams);
    }

    /// <summary>Warns of an option that was given, but is for formats with a feature, of which there is no file.</summary>
    public static void WarnOfUnused(ParseResult result, Option option, ImageFeatures feature, IReadOnlyList<string> files, Streams streams)
    {
        bool isGiven = files.Count > 0 && result.GetResult(option) is { Implicit: false };
        if (isGiven && !files.Any(f => ImageFormat.Has(AnimatedPng.IsNamed(f) ? ".png" : f, feature)))
        {
            streams.Warn($"{option.Name} has no effect: it is for {ImageFormat.Names(feature)} files, and none is written");
        }
    }

    /// <summary>The options of how pictures look that were given, as words of a command line.</summary>
    public IEnumerable<string> Words(ParseResult result) => Looks.Where(o => result.GetResult(o) is { Implicit: false }).SelectMany(o => new[] { o.Name, result.GetResult(o)!.Tokens[^1].Value });

    /// <summary>How they are written.</summary>
    /// <param name="result">What was given.</param>
    /// <param name="files">The files to write; null for those of -o.</param>
    /// <exception cref="CommandException">The film shall go into an OpenEXR image, but there is none.</exception>
    public ImageWriteOptions Writing(ParseResult result, IEnumerable<string>? files = null) => new()
    {
        ExrFilm = TakesFilm(result, files ?? Files(result)),
        BitDepth = _bitDepth.Value(result) ?? 8,
        Exposure = (float)(_exposure.Value(result) ?? 0),
        ToneMap = _toneMap.Value(result) ?? ToneMap.Clamp,
        JpegQuality = (int)(_quality.Value(result) ?? JpegWriter.StandardQuality),
        JpegChroma = _chroma.Value(result),
    };

    private bool TakesFilm(ParseResult result, IEnumerable<string> files)
    {
        bool isWanted = result.GetValue(ExrFilm);
        return !isWanted || files.Any(FilmExr.IsNamed) ? isWanted
            : throw new CommandException(ExitStatus.Usage, $"{ExrFilm.Name} is for OpenEXR images, but none is written: give -o FILE.exr");
    }
}
