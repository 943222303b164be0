using System.CommandLine;
using System.Runtime.ExceptionServices;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer merge PART… -o FILE</c>: adds films of different samples of one picture up. In any order, the bits are those of one render.</summary>
internal sealed class MergeVerb
{
    private const int MostAtOnce = 4;
    private readonly Argument<string[]> _parts = new("PART") { Description = "The films (.rtfilm).", Arity = new ArgumentArity(1, 100_000) };
    private readonly Option<bool> _partial = new("--partial") { Description = "Allows samples to be missing." };
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Prints errors and warnings only." };
    private readonly Option<bool> _json = new("--json") { Description = "Prints one JSON object." };
    private readonly WritingOptions _writing;

    private MergeVerb(Command command)
    {
        command.Arguments.Add(_parts);
        _writing = new(command);
        foreach (Option option in _writing.Looks.Concat([_partial, _quiet, _json]))
        {
            command.Options.Add(option);
        }
    }

    public static void Build(Command command, Streams streams)
    {
        MergeVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    private int Run(ParseResult result, Streams streams)
    {
        IReadOnlyList<string> outputs = _writing.Files(result);
        if (outputs.Count == 0 && !result.GetValue(_json))
        {
            throw new CommandException(ExitStatus.Usage, "where to? Give -o FILE (or --json alone for the film's hash)");
        }

        foreach (string output in outputs)
        {
            ImageOutputs.CheckFilm(output);
        }

        (string Path, FilmHeader Header)[] parts = [.. result.GetValue(_parts)!.Select(p => (p, FilmFile.ReadHeader(p)))];
        FilmHeader header = Join(parts);
        if (Gaps(header) is { Length: > 0 } gaps)
        {
            string missing = $"samples {gaps} are missing of {header.Total}";
            if (!result.GetValue(_partial))
            {
                throw new CommandException(ExitStatus.InputOutput, $"{missing} (--partial merges what there is)");
            }

            streams.Warn(missing);
        }

        Film film = new(header.Width, header.Height);
        Add(parts, film);
        return Write(result, film, header, outputs, streams);
    }

    // Several at once: checksums take longer than a disk to read what they are of. More than a few only make the disk's way longer.
    private static void Add((string Path, FilmHeader Header)[] parts, Film film)
    {
        Lock adding = new();
        try
        {
            Parallel.ForEach(parts, new() { MaxDegreeOfParallelism = Math.Min(MostAtOnce, Environment.ProcessorCount) }, part =>
            {
                FilmHeader header = FilmFile.AddTo(part.Path, film, adding);
                if (header.Content != part.Header.Content || !header.Samples.SequenceEqual(part.Header.Samples))
                {
                    throw new PictureException($"Cannot read the film '{part.Path}': it was changed meanwhile.");
                }
            });
        }
        catch (AggregateException e)
        {
            ExceptionDispatchInfo.Throw(e.InnerExceptions[0]);
        }
    }

    private int Write(ParseResult result, Film film, FilmHeader header, IReadOnlyList<string> outputs, Streams streams)
    {
        string hash = film.ComputeHash();
        int samples = header.Samples.Sum(r => r.Count);
        IReadOnlyList<string> written = ImageOutputs.Write(outputs, film, header, _writing.Writing(result) with { Metadata = Texts(header, hash) }, streams);
        if (result.GetValue(_json))
        {
            WriteJson(header, samples, hash, written, streams);
        }
        else if (!result.GetValue(_quiet))
        {
            streams.Output.WriteLine($"{header.Width}×{header.Height} pixels, samples {header.SamplesText}");
            streams.Output.WriteLine($"film {hash}");
            foreach (string path in written)
            {
                streams.Output.WriteLine($"wrote {path}");
            }
        }

        return written.Count < outputs.Count ? ExitStatus.InputOutput : ExitStatus.Fine;
    }

    /// <summary>What images say of themselves.</summary>
    public static IReadOnlyList<string> TextKeys { get; } = ["Software", "Command", "Scene", "Samples", "FilmHash", "SampleRange"];

    /// <summary>What an image of a film says of itself.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Texts(FilmHeader header, string hash) =>
    [
        new("Software", CommandLine.Version),
        new("Command", Session.Shell.Command(["render", header.Scene, .. ResumeVerb.Words(header, header.Total), .. CropWords(header)])),
        new("Scene", Path.GetFileName(header.Scene)),
        new("Samples", $"{header.Samples.Sum(r => r.Count)}"),
        new("FilmHash", hash),
        new("SampleRange", header.SamplesText),
    ];

    /// <summary>The options that say which part of the picture a film is of.</summary>
    public static string[] CropWords(FilmHeader header) => header.Crop is { } c ? ["--crop", $"{c.X},{c.Y},{c.Width},{c.Height}"] : [];

    private static void WriteJson(FilmHeader header, int samples, string hash, IReadOnlyList<string> written, Streams streams) => JsonText.Write(streams, json =>
    {
        json.WriteNumber("width", header.Width);
        json.WriteNumber("height", header.Height);
        json.WriteNumber("samplesPerPixel", samples);
        json.WriteString("samples", header.SamplesText);
        json.WriteBoolean("complete", header.IsComplete);
        json.WriteString("filmHash", hash);
        json.WriteStartArray("outputs");
        foreach (string path in written)
        {
            json.WriteStringValue(path);
        }

        json.WriteEndArray();
    });

    // What the films are together.
    private static FilmHeader Join((string Path, FilmHeader Header)[] parts)
    {
        (string firstPath, FilmHeader first) = parts[0];
        if (Array.Find(parts, p => p.Header.Samples.Count == 0).Path is { } empty)
        {
            throw new CommandException(ExitStatus.InputOutput, $"'{empty}' holds no samples yet");
        }

        foreach ((string path, FilmHeader header) in parts)
        {
            if (header.Content != first.Content || (header.Width, header.Height, header.Crop) != (first.Width, first.Height, first.Crop))
            {
                throw new CommandException(
                    ExitStatus.InputOutput, $"'{path}' is not of the same picture as '{firstPath}': the scene, a file that it names, its settings or the program differ");
            }
        }

        (SampleRange Range, string Path)[] ranges = [.. parts.SelectMany(p => p.Header.Samples.Select(r => (r, p.Path))).OrderBy(r => r.r.First).ThenBy(r => r.r.End)];
        for (int i = 1; i < ranges.Length; i++)
        {
            if (ranges[i].Range.First < ranges[i - 1].Range.End)
            {
                SampleRange twice = new(ranges[i].Range.First, Math.Min(ranges[i].Range.End, ranges[i - 1].Range.End));
                throw new CommandException(ExitStatus.InputOutput, $"samples {FilmHeader.Text(twice)} are in both '{ranges[i - 1].Path}' and '{ranges[i].Path}'");
            }
        }

        int total = parts.Max(p => p.Header.Total);
        IEnumerable<SampleRange> joined = ranges.Aggregate(Enumerable.Empty<SampleRange>(), (all, r) => PassRender.Join(all, r.Range));
        return first with { Samples = [.. joined], Total = total, Wanted = new(0, total), Software = CommandLine.Version };
    }

    private static string Gaps(FilmHeader header)
    {
        List<string> gaps = [];
        int end = 0;
        foreach (SampleRange range in header.Samples.Append(new(header.Total, header.Total)))
        {
            if (range.First > end)
            {
                gaps.Add(FilmHeader.Text(new(end, range.First)));
            }

            end = Math.Max(end, range.End);
        }

        return string.Join(", ", gaps);
    }
}
