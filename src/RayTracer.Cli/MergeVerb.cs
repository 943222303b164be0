using System.CommandLine;
using System.Text.Json.Nodes;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary><c>raytracer merge PART… -o FILE</c>: adds films of different samples of one picture up. In any order, the bits are those of one render.</summary>
internal sealed class MergeVerb
{
    private readonly Argument<string[]> _parts = new("PART") { Description = "The films: .rtfilm files, or .exr images that carry them (--exr-film).", Arity = new ArgumentArity(1, 100_000) };
    private readonly Option<bool> _partial = new("--partial") { Description = "Allows missing samples." };
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Prints errors and warnings only." };
    private readonly Option<bool> _json = new("--json") { Description = "Prints one JSON object." };
    private readonly WritingOptions _writing;
    private readonly VerboseOption _verbose;

    private MergeVerb(Command command)
    {
        command.Arguments.Add(_parts);
        _writing = new(command);
        foreach (Option option in _writing.Looks.Concat([_writing.ExrFilm, _partial, _quiet, _json]))
        {
            command.Options.Add(option);
        }

        _verbose = new(command);
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
            JobFiles.CheckFilm(output);
        }

        _writing.WarnOfUnused(result, outputs, streams);
        StageTimes stages = _verbose.Times(result, streams);
        FilmMerge merge = FilmMerge.Of(result.GetValue(_parts)!);
        if (DecisionCheckpoint.Is(merge.Header))
        {
            throw DecisionCheckpoint.NoPicture(result.GetValue(_parts)![0]);
        }

        if (merge.Missing is { } missing)
        {
            if (!result.GetValue(_partial))
            {
                throw new CommandException(ExitStatus.InputOutput, $"{missing} (--partial merges what is there)");
            }

            streams.Warn(missing);
        }

        JobFiles.CheckUnfinished(outputs, replacement: merge.Header);
        stages.End("headers");
        Film film = merge.Add();
        stages.EndLoad();
        int status = Write(result, film, merge.Header, outputs, streams);
        stages.EndWrite();
        return status;
    }

    private int Write(ParseResult result, Film film, FilmHeader header, IReadOnlyList<string> outputs, Streams streams)
    {
        string hash = film.ComputeHash();
        int samples = header.Samples.Sum(r => r.Count);
        IReadOnlyList<string> written = JobFiles.Write(outputs, film, header, _writing.Writing(result) with { Metadata = PictureTexts.Of(header, hash) }, streams);
        if (result.GetValue(_json))
        {
            JsonText.Write(streams, Json(header, samples, hash, written));
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

    private static JsonObject Json(FilmHeader header, int samples, string hash, IReadOnlyList<string> written) => new()
    {
        ["width"] = header.Width,
        ["height"] = header.Height,
        ["samplesPerPixel"] = samples,
        ["samples"] = header.SamplesText,
        ["complete"] = header.IsComplete,
        ["filmHash"] = hash,
        ["outputs"] = JsonText.List(written),
    };
}
