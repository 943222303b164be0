using System.CommandLine;
using System.Text.Json.Nodes;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>
/// <c>raytracer merge PART… -o FILE</c>: adds films of different samples of one picture up. In any order, the bits are those of one render.
/// </summary>
internal sealed class MergeVerb
{
    private readonly Argument<string[]> _parts = new("PART") { Description = "The films: .rtfilm files, or .exr images that carry them (--exr-film).", Arity = new ArgumentArity(1, 100_000) };
    private readonly Option<bool> _partial = new("--partial") { Description = "Allows missing samples." };
    private readonly WritingOptions _writing;
    private readonly DisplayOptions _display;

    private MergeVerb(Command command)
    {
        command.Arguments.Add(_parts);
        _writing = new(command);
        command.AddOptions([.. _writing.Looks, _writing.Transparent, _writing.ExrFilm, _partial]);
        _display = new(command, hasPreview: false);
    }

    public static void Build(Command command, Streams streams)
    {
        MergeVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    private int Run(ParseResult result, Streams streams)
    {
        IReadOnlyList<string> outputs = _writing.Files(result, _display.Of(result), "the film's hash", JobFiles.CheckFilm);
        _writing.WarnOfUnused(result, outputs, streams);
        StageTimes stages = _display.Times(result, streams);
        FilmMerge merge = FilmMerge.Of(result.GetValue(_parts)!);
        HeldFilm.CheckPicture(merge.Header, result.GetValue(_parts)![0]);
        if (merge.Missing is { } missing)
        {
            if (!result.GetValue(_partial))
            {
                throw new CommandException(ExitStatus.InputOutput, $"{missing} (--partial merges what is there)");
            }

            streams.Warn(missing);
        }

        foreach ((string path, FilmPlane plane) in merge.Lost)
        {
            streams.Warn($"'{path}' has no plane '{plane}' as others have, so that what is merged has none (render {(plane == FilmPlane.Alpha ? JobOptions.Transparent : JobOptions.Halves).Name})");
        }

        PictureFiles.CheckAlpha(_writing.Writing(result), merge.Header.Planes, result.GetValue(_parts)![0]);
        UnfinishedFilms.Check(outputs, replacement: merge.Header);
        stages.End("headers");
        Film film = merge.Add();
        stages.End(JobStage.Load);
        int status = Write(result, film, merge.Header, outputs, streams);
        stages.End(JobStage.Write);
        return status;
    }

    private int Write(ParseResult result, Film film, FilmHeader header, IReadOnlyList<string> outputs, Streams streams)
    {
        string hash = film.ComputeHash();
        int samples = header.Samples.Sum(r => r.Count);
        IReadOnlyList<string> written = JobFiles.Write(
            outputs, film, header, _writing.Writing(result).With(header.Tone) with { Metadata = PictureTexts.Of(header, hash) }, streams);
        Display display = _display.Of(result);
        if (display.Json)
        {
            JsonText.Write(streams, Json(header, samples, hash, written));
        }
        else if (!display.Quiet)
        {
            streams.Output.WriteLine($"{header.Width}×{header.Height} pixels, samples {header.SamplesText}");
            streams.Output.WriteLine($"film {hash}");
            streams.Wrote(written);
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
