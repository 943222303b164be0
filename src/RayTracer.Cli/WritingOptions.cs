using System.CommandLine;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>The options of verbs that write pictures.</summary>
internal sealed class WritingOptions
{
    private readonly Option<string[]> _outputs = new("-o", "--output") { HelpName = "FILE" };
    private readonly JobOptionSet _options = new([.. JobOptions.OfLooks, JobOptions.Transparent, JobOptions.ExrFilm]);

    /// <summary>Makes the options, for a command that takes the file otherwise: those of <see cref="Looks"/> only.</summary>
    public WritingOptions()
    {
    }

    /// <summary>Gives a command the options.</summary>
    /// <param name="command">The command.</param>
    /// <param name="outputs">A description of the files; null for images or the film itself.</param>
    public WritingOptions(Command command, string? outputs = null)
    {
        _outputs.Description = outputs ?? $"The file to write: {ImageFormat.Endings()}, or .rtfilm for the film itself. May be given several times.";
        command.Options.Add(_outputs);
    }

    /// <summary>The options of how pictures look.</summary>
    public IEnumerable<Option> Looks => JobOptions.OfLooks.Select(_options.Symbol);

    /// <summary>The option of verbs that have the film itself: whether .exr files carry it. It is none of <see cref="Looks"/>.</summary>
    public Option ExrFilm => _options.Symbol(JobOptions.ExrFilm);

    /// <summary>The option of verbs that have the film itself: whether what is behind everything is left out.</summary>
    public Option Transparent => _options.Symbol(JobOptions.Transparent);

    /// <summary>The files.</summary>
    public IReadOnlyList<string> Files(ParseResult result) => result.GetValue(_outputs) ?? [];

    /// <summary>The files, of which there must be one where no JSON object is printed.</summary>
    /// <param name="result">The words that were given.</param>
    /// <param name="display">The user's choice of what is printed.</param>
    /// <param name="alone">The use of the JSON object without files, in words.</param>
    /// <param name="check">Finds out before the work whether a file can be written after it.</param>
    public IReadOnlyList<string> Files(ParseResult result, Display display, string alone, Action<string> check)
    {
        IReadOnlyList<string> files = Files(result);
        if (files.Count == 0 && !display.Json)
        {
            throw new CommandException(ExitStatus.Usage, $"where to? Give -o FILE (or --json alone for {alone})");
        }

        files.ToList().ForEach(check);
        return files;
    }

    /// <summary>Warns of options of how pictures look that were given, but change none of the files.</summary>
    /// <param name="result">The words that were given.</param>
    /// <param name="files">The files to write.</param>
    /// <param name="streams">Takes the warnings.</param>
    /// <param name="isSeen">True if exposure and tone map are seen elsewhere too.</param>
    public void WarnOfUnused(ParseResult result, IReadOnlyList<string> files, Streams streams, bool isSeen = false) =>
        _options.WarnOfUnused(result, files, streams, isSeen);

    /// <summary>Warns of an option that was given, but is for formats with a feature, of which there is no file.</summary>
    public static void WarnOfUnused(ParseResult result, Option option, ImageFeatures feature, IReadOnlyList<string> files, Streams streams)
    {
        bool isGiven = files.Count > 0 && result.GetResult(option) is { Implicit: false };
        if (isGiven && !files.Any(f => ImageFormat.Has(AnimatedPng.IsNamed(f) ? ".png" : f, feature)))
        {
            streams.Warn($"{option.Name} has no effect: it is for {ImageFormat.Names(feature)} files, and none is written");
        }
    }

    /// <summary>Returns whether an option was given.</summary>
    public bool Has(ParseResult result, JobOption option) => _options.Has(result, option.Name);

    /// <summary>The options that were given, as words of a command line.</summary>
    public IEnumerable<string> Words(ParseResult result) => _options.Words(result);

    /// <summary>Returns the details of writing pictures.</summary>
    /// <param name="result">The words that were given.</param>
    /// <param name="files">The files to write; null for those of -o.</param>
    /// <exception cref="CommandException">The film shall go into an OpenEXR image, but there is none.</exception>
    public ImageWriteOptions Writing(ParseResult result, IEnumerable<string>? files = null)
    {
        RenderJob job = _options.Given(result) with { Outputs = [.. files ?? Files(result)] };
        return JobRules.Complaint(job, "--json") is { } complaint ? throw new CommandException(ExitStatus.Usage, complaint) : job.Writing;
    }
}
