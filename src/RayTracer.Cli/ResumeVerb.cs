using System.CommandLine;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary><c>raytracer resume FILE</c>: adds samples to a film that was not finished, or more than it was to have.</summary>
internal sealed class ResumeVerb
{
    private static readonly JobOption s_samples = JobOptions.Find("--spp")!;
    private static readonly JobOption s_denoise = JobOptions.Find("--denoise")!;
    private readonly Argument<string> _file = new("FILE")
    {
        Description = "The film: .rtfilm, of --checkpoint or -o; or an .exr image that carries it (--exr-film). It is brought up to date itself, now and then and at the end.",
    };

    private readonly Option<string?> _scene = new("--scene") { Description = "The scene file, where it is no longer where it was.", HelpName = "SCENE" };
    private readonly WritingOptions _writing;
    private readonly JobOptionSet _options;
    private readonly JobOptionSet _long;
    private readonly DisplayOptions _display;

    private ResumeVerb(Command command)
    {
        command.Arguments.Add(_file);
        _writing = new(command);
        _options = new(command, [s_samples, JobOptions.Threads, s_denoise, JobOptions.GuideFile]);
        command.AddOptions([_scene, .. _writing.Looks, _writing.Transparent, _writing.ExrFilm]);

        _long = new(command, JobOptions.OfLongRenders.Select(o => o.Name == "--checkpoint" ? o with { Description = "Writes the film to this file now and then; without it, to FILE." } : o));
        _display = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        ResumeVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    private int Run(ParseResult result, Streams streams)
    {
        string file = result.GetValue(_file)!;
        HeldFilm film = HeldFilm.Read(file);
        RenderJob origin = JobOrigin.Of(film.Header, file);
        RenderJob given = _long.Put(
            result, _options.Put(result, new() { Scene = result.GetValue(_scene) ?? origin.Scene, Checkpoint = file }));
        RenderJob job = given with
        {
            Settings = origin.Settings,
            Frames = origin.Frames,
            Noise = origin.Noise,
            Guide = origin.Guide,
            Edition = origin.Edition,
            Crop = origin.Crop,
            Halves = origin.Halves,
            Alpha = origin.KeepsAlpha,
            Outputs = _writing.Files(result),
            Writing = Writing(result, file),
        };
        int? samples = given.GivenSamples;
        job = DecisionCheckpoint.Is(film.Header) ? Decide(job, film, samples) : Continue(job, film, samples, streams);
        bool isImage = job.Checkpoint == file && FilmExr.Is(file);
        if (JobRules.Complaint(job with { Checkpoint = isImage ? null : job.Checkpoint, Writing = new() }, "--json") is { } complaint)
        {
            throw new CommandException(ExitStatus.Usage, complaint);
        }

        if (isImage)
        {
            CheckLayers(file);
        }

        Display display = _display.Of(result);
        _writing.WarnOfUnused(result, job.Outputs, streams, isSeen: display.Preview);
        return new ConsoleRun(display, streams).Run(job);
    }

    private static RenderJob Continue(RenderJob job, HeldFilm film, int? samples, Streams streams)
    {
        FilmHeader header = film.Header;
        bool isOpenEnded = job.Time is not null && samples is null && header.IsComplete && IsWhole(header)
            && header.Total < SampleDecision.Limit;
        SampleRange wanted = isOpenEnded ? new(0, SampleDecision.Limit) : Wanted(header, samples);
        if (header.Samples is [var held] && held == wanted)
        {
            string what = IsWhole(header) ? $"{held.Count} samples: give --spp or --time for more"
                : $"samples of its part, {header.SamplesText}";
            streams.Warn($"'{film.Path}' has all {what}; nothing is rendered");
        }

        return job.WithSamples(samples is null ? Math.Max(header.Total, wanted.End) : wanted.End) with { Samples = wanted, IsOpenEnded = isOpenEnded, Resumed = film };
    }

    // Continues to decide how many samples there are, and renders them.
    private static RenderJob Decide(RenderJob job, HeldFilm film, int? samples) => samples is null ? job with { Decision = film }
        : throw new CommandException(
            ExitStatus.Usage, $"--spp {samples}: it is being decided how many samples the film shall have (--noise): leave --spp out");

    private static bool IsWhole(FilmHeader header) => header.Wanted == new SampleRange(0, header.Total);

    // An image that carries the film does not lose it.
    private ImageWriteOptions Writing(ParseResult result, string file)
    {
        ImageWriteOptions writing = _writing.Writing(result, [.. _writing.Files(result), file]);
        return writing with { ExrFilm = writing.ExrFilm || FilmExr.Is(file) };
    }

    private static void CheckLayers(string file)
    {
        if (FilmExr.OtherLayers(file) is { Count: > 0 } layers)
        {
            throw new CommandException(ExitStatus.Usage, $"'{file}' has layers that are not updated when samples are added ({string.Join(", ", layers)}): "
                + "with --checkpoint FILE.rtfilm (and -o) it stays unchanged");
        }
    }

    // The samples that the film shall come to hold.
    private static SampleRange Wanted(FilmHeader header, int? samples)
    {
        SampleRange wanted = samples is { } more ? new(header.Wanted.First, more) : header.Wanted;
        if (samples is not null && !IsWhole(header))
        {
            throw new CommandException(
                ExitStatus.Usage, $"--spp {samples}: the film is a part of a picture, samples {FilmHeader.Text(header.Wanted)} of {header.Total}: render the others and merge");
        }

        return header.Samples switch
        {
            [] => wanted,
            [var held] when held.First == wanted.First && held.End <= wanted.End => wanted,
            [var held] when held.First == wanted.First =>
                throw new CommandException(ExitStatus.Usage, $"--spp {samples}: the film has {held.Count} samples a pixel already"),
            _ => throw new CommandException(
                ExitStatus.InputOutput, $"samples are missing within the film, which has {header.SamplesText}: render them and merge"),
        };
    }
}
