using System.CommandLine;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Cli;

/// <summary><c>raytracer resume FILE</c>: goes on with a film that was not finished, or gives it more samples.</summary>
internal sealed class ResumeVerb
{
    private readonly Argument<string> _file = new("FILE") { Description = "The film: .rtfilm, of --checkpoint or -o; or an .exr image that carries it (--exr-film). It is brought up to date itself, now and then and at the end." };
    private readonly ParsedOption<long?> _samples = OptionValues.Parameter("--spp", nameof(RenderDescription.SamplesPerPixel));
    private readonly Option<string?> _scene = new("--scene") { Description = "The scene file, where it is no longer where it was.", HelpName = "SCENE" };
    private readonly ParsedOption<long?> _threads = OptionValues.Integer("--threads", "Number of threads; without it, one for each core.", 1, 1024);
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

        _long = new(command, "Writes the film to this file now and then; without it, to FILE.");
        _display = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        ResumeVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    /// <summary>The complaint about a scene that a film is not of.</summary>
    public static CommandException OtherScene(string path) =>
        new(ExitStatus.InputOutput, $"the film is not of '{path}': the scene, a file that it names, its settings or the program are others than they were");

    /// <summary>The complaint about a film of other content than what it shall be gone on with.</summary>
    public static CommandException OtherFilm(RenderRequest request, FilmHeader header, RenderDescription render) => ContentHash.HasPattern(render) && render.SamplesPerPixel != header.Total
        ? new(
            ExitStatus.Usage,
            $"--spp {render.SamplesPerPixel}: the places of the {render.Sampler.ToString().ToLowerInvariant()} sampler's samples depend on how many there are, so that a film of {header.Total} cannot be given more or fewer: render it anew, or with --sampler sobol")
        : OtherScene(request.ScenePath);

    private int Run(ParseResult result, Streams streams)
    {
        string file = result.GetValue(_file)!;
        (FilmHeader header, Film film) = CarriedFilm.Read(file);
        SampleRange wanted = Wanted(header, (int?)_samples.Value(result));
        int total = Math.Max(header.Total, wanted.End);
        if (_samples.Value(result) is not null)
        {
            total = wanted.End;
        }

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
            Frames = first.Frames,
            HasSamples = true,
            Checkpoint = file,
            Resumed = new(header, film, file),
            Settings = first.Settings,
            OverrideWords = words,
            CommandText = Shell.Command(["render", scene, .. words, .. FilmTexts.CropWords(header)]),
        }));
        if (request.Checkpoint == file && FilmExr.Is(file))
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
                ExitStatus.Usage, $"'{file}' has layers that are not made again when more samples come ({string.Join(", ", layers)}): with --checkpoint FILE.rtfilm (and -o) it stays as it is");
        }
    }

    // The samples that the film shall come to hold.
    private static SampleRange Wanted(FilmHeader header, int? samples)
    {
        SampleRange wanted = samples is { } more ? new(header.Wanted.First, more) : header.Wanted;
        if (samples is not null && header.Wanted.First != 0)
        {
            throw new CommandException(ExitStatus.Usage, $"--spp {samples}: the film is a part of a picture, samples {FilmHeader.Text(header.Wanted)}");
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
