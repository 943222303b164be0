using System.CommandLine;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary><c>raytracer resume FILE</c>: goes on with a film that was not finished, or gives it more samples.</summary>
internal sealed class ResumeVerb
{
    private readonly Argument<string> _file = new("FILE") { Description = "The film: .rtfilm, from --checkpoint or -o; or an .exr image that carries it (--exr-film). The file itself is updated from time to time and at the end." };
    private readonly ParsedOption<long?> _samples = OptionValues.Parameter("--spp", nameof(RenderDescription.SamplesPerPixel));
    private readonly Option<string?> _scene = new("--scene") { Description = "The scene file, if it has moved.", HelpName = "SCENE" };
    private readonly ParsedOption<long?> _threads = OptionValues.Integer("--threads", "Number of threads. Default: one per core.", 1, 1024);
    private readonly WritingOptions _writing;
    private readonly LongRenderOptions _long;
    private readonly DisplayOptions _display;

    private ResumeVerb(Command command)
    {
        command.Arguments.Add(_file);
        _writing = new(command);
        foreach (Option option in new Option[] { _samples.Symbol, _scene, _threads.Symbol }.Concat(_writing.Looks).Append(_writing.ExrFilm))
        {
            command.Options.Add(option);
        }

        _long = new(command, "Writes the film to this file from time to time. Default: FILE.");
        _display = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        ResumeVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    /// <summary>The complaint about a scene that a film is not of.</summary>
    public static CommandException OtherScene(string path) =>
        new(ExitStatus.InputOutput, $"the film is not of '{path}': the scene, a file that it refers to, its settings or the program have changed");

    /// <summary>The complaint about a film of other content than what it shall be gone on with.</summary>
    public static CommandException OtherFilm(RenderRequest request, FilmHeader header, RenderDescription render) => render.Sampler.DependsOnCount && render.SamplesPerPixel != header.Total
        ? new(
            ExitStatus.Usage,
            $"--spp {render.SamplesPerPixel}: the places of the {render.Sampler.ToString().ToLowerInvariant()} sampler's samples depend on how many there are, so a film of {header.Total} cannot have more or fewer: render from scratch, or with --sampler sobol")
        : OtherScene(request.ScenePath);

    /// <summary>The header of a film that is gone on with.</summary>
    /// <param name="film">The film.</param>
    /// <param name="header">The header of a new film.</param>
    /// <param name="request">What was asked for.</param>
    /// <param name="render">How it is rendered.</param>
    /// <exception cref="CommandException">It is of another picture, or of other samples.</exception>
    public static FilmHeader GoOn(ResumedFilm film, FilmHeader header, RenderRequest request, RenderDescription render)
    {
        FilmHeader old = film.Header;
        if (old.Content != header.Content)
        {
            throw OtherFilm(request, old, render);
        }

        bool isBegin = old.Samples is [] || (old.Samples is [var held] && held.First == header.Wanted.First && held.End <= header.Wanted.End);
        return isBegin ? header with { Samples = old.Samples, Overrides = header.Wanted == old.Wanted ? old.Overrides : header.Overrides } : throw new CommandException(
            ExitStatus.InputOutput, $"'{film.Path}' holds samples {old.SamplesText}, which are not the first of the requested {FilmHeader.Text(header.Wanted)}");
    }

    private int Run(ParseResult result, Streams streams)
    {
        string file = result.GetValue(_file)!;
        (FilmHeader header, Film film) = CarriedFilm.Read(file);
        if (DecisionCheckpoint.Is(header))
        {
            return Decide(result, new(header, film, file), streams);
        }

        int? samples = (int?)_samples.Value(result);
        bool isOpenEnded = _long.HasTime(result) && samples is null && header.IsComplete && IsWhole(header) && header.Total < NoiseRequest.Limit;
        SampleRange wanted = isOpenEnded ? new(0, NoiseRequest.Limit) : Wanted(header, samples);
        int total = samples is null ? Math.Max(header.Total, wanted.End) : wanted.End;
        IReadOnlyList<string> words = FilmTexts.Words(header, total);
        string scene = result.GetValue(_scene) ?? PictureOrigin.ScenePath(header.Scene, file);
        (RenderRequest first, Func<SceneDescription, SceneDescription> overrides) = RenderVerb.Parse([scene, "--json", .. words]);
        RenderRequest request = _display.Put(result, _long.Put(result, new()
        {
            ScenePath = scene,
            Outputs = _writing.Files(result),
            Writing = Writing(result, file),
            Threads = (int)(_threads.Value(result) ?? Environment.ProcessorCount),
            Crop = header.Crop is { } c ? [c.X, c.Y, c.Width, c.Height] : null,
            Samples = wanted,
            IsOpenEnded = isOpenEnded,
            Frames = first.Frames,
            HasSamples = true,
            Checkpoint = file,
            Resumed = new(header, film, file),
            Settings = first.Settings,
            OverrideWords = words,
            CommandText = Shell.Command(["render", scene, .. words, .. FilmTexts.CropWords(header)]),
        }));
        if (header.Samples is [var held] && held == wanted)
        {
            streams.Warn($"'{file}' has all {(IsWhole(header) ? $"{held.Count} samples: give --spp or --time for more" : $"samples of its part, {header.SamplesText}")}; nothing is rendered");
        }

        return Run(result, request, overrides, streams);
    }

    // Goes on with deciding how many samples there shall be, and renders them.
    private int Decide(ParseResult result, ResumedFilm film, Streams streams)
    {
        if (_samples.Value(result) is { } samples)
        {
            throw new CommandException(ExitStatus.Usage, $"--spp {samples}: the film's number of samples is still being decided (--noise): leave --spp out");
        }

        string scene = result.GetValue(_scene) ?? PictureOrigin.ScenePath(film.Header.Scene, film.Path);
        string[] words = [scene, .. film.Header.Overrides];
        (RenderRequest first, Func<SceneDescription, SceneDescription> overrides) = RenderVerb.Parse([.. words, "--json"]);
        RenderRequest request = _display.Put(result, _long.Put(result, first with
        {
            Outputs = _writing.Files(result),
            Writing = Writing(result, film.Path),
            Threads = (int)(_threads.Value(result) ?? Environment.ProcessorCount),
            Checkpoint = film.Path,
            Decision = film,
            CommandText = Shell.Command(["render", .. words]),
        }));
        return Run(result, request.WithFrameWords(), overrides, streams);
    }

    private int Run(ParseResult result, RenderRequest request, Func<SceneDescription, SceneDescription> overrides, Streams streams)
    {
        if (result.GetValue(_file)! is var file && request.Checkpoint == file && FilmExr.Is(file))
        {
            CheckLayers(file);
        }
        else if (!FilmFile.IsNamed(request.Checkpoint!))
        {
            throw new CommandException(ExitStatus.Usage, $"--checkpoint {request.Checkpoint}: films are written to .rtfilm files");
        }

        _writing.WarnOfUnused(result, request.Outputs, streams, isSeen: request.Preview);
        return new RenderRun(DisplayOptions.ForTerminal(request, streams), overrides, streams).Run();
    }

    private static bool IsWhole(FilmHeader header) => header.Wanted == new SampleRange(0, header.Total);

    // Whoever goes on with an image that carries the film does not lose it.
    private ImageWriteOptions Writing(ParseResult result, string file)
    {
        ImageWriteOptions writing = _writing.Writing(result, [.. _writing.Files(result), file]);
        return writing with { ExrFilm = writing.ExrFilm || FilmExr.Is(file) };
    }

    private static void CheckLayers(string file)
    {
        if (FilmExr.OtherLayers(file) is { Count: > 0 } layers)
        {
            throw new CommandException(
                ExitStatus.Usage, $"'{file}' has layers that are not updated when samples are added ({string.Join(", ", layers)}): with --checkpoint FILE.rtfilm (and -o) it stays unchanged");
        }
    }

    // The samples that the film shall come to hold.
    private static SampleRange Wanted(FilmHeader header, int? samples)
    {
        SampleRange wanted = samples is { } more ? new(header.Wanted.First, more) : header.Wanted;
        if (samples is not null && !IsWhole(header))
        {
            throw new CommandException(ExitStatus.Usage, $"--spp {samples}: the film is a part of a picture, samples {FilmHeader.Text(header.Wanted)} of {header.Total}: render the others and merge");
        }

        return header.Samples switch
        {
            [] => wanted,
            [var held] when held.First == wanted.First && held.End <= wanted.End => wanted,
            [var held] when held.First == wanted.First => throw new CommandException(ExitStatus.Usage, $"--spp {samples}: the film has {held.Count} samples a pixel already"),
            _ => throw new CommandException(ExitStatus.InputOutput, $"samples are missing within the film, which has {header.SamplesText}: render them and merge"),
        };
    }
}
