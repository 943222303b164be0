using System.CommandLine;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary><c>raytracer render SCENE -o FILE</c>: the options. The work is in <see cref="RenderRun"/>.</summary>
internal sealed class RenderVerb
{
    private readonly Argument<string> _scene;
    private readonly WritingOptions _writing;
    private readonly ParsedOption<long?> _threads = OptionValues.Integer("--threads", "Number of threads. Default: one per core.", 1, 1024);
    private readonly ParsedOption<int[]?> _crop = OptionValues.Integers("--crop", "x,y,w,h", "Renders only this rectangle of pixels; the rest of the image stays black.");
    private readonly ParsedOption<int[]?> _pixel = OptionValues.Integers("--pixel", "x,y", "Renders only this pixel and prints its radiance.");
    private readonly ParsedOption<long?> _sample = OptionValues.Integer("--sample", "With --pixel: renders only this sample, from 0.", 0, int.MaxValue - 1);
    private readonly ParsedOption<object[]?> _aovs = OptionValues.Words<object>(
        "--aov",
        $"Also writes auxiliary images: of pixels ({AuxiliaryImage.Known.All[0].Name} to {AuxiliaryImage.Known.All[^1].Name}), "
            + "or of parts of the light (emission to lights, which gives one for each light). They become layers of .exr files, and otherwise files beside them "
            + "(out.depth.png). One or more, separated by commas.",
        kind => kind is AuxiliaryImage image ? image.Name : $"{kind}".ToLowerInvariant(),
        [.. AuxiliaryImage.Known.All, .. Enum.GetValues<LightLayer>()]);
    private readonly Option<bool> _denoise = new("--denoise") { Description = "Also writes a denoised picture: as a layer of .exr files, otherwise as a file beside the output (out.denoised.png)." };
    private readonly ParsedOption<double?> _noise = OptionValues.Fraction(
        "--noise", "Stops at this estimated relative error of the picture, or at the number of samples given by --spp (default 65,536). The estimate is conservative: stratified samplers (sobol) do better.");
    private readonly Option<bool> _adaptive = new("--adaptive") { Description = "Spends samples where the error is; --spp is then the mean. With --noise, only as many as that takes." };
    private readonly ParsedOption<SampleRange?> _samples = new("--samples", "A..B", "Renders only these samples of each pixel, both ends included, counted from 0. With -o part.rtfilm, for merge.", SampleShares.Range);
    private readonly ParsedOption<(int Number, int Count)?> _part = new("--part", "I/N", "Renders only share I, counted from 1, of N equal shares of the samples. With -o part.rtfilm, for merge.", SampleShares.Part);
    private readonly ParsedOption<FrameRange?> _frames = OptionValues.Frames();
    private readonly ParsedOption<double?> _rate = OptionValues.Number("--fps", "With --frames and -o FILE.png or FILE.apng, which make an animated PNG: frames per second. Default: the scene's framesPerSecond.", 0.01, 1000);
    private readonly Option<bool> _resume = new("--resume") { Description = "Resumes from the film of --checkpoint if it exists; it must be of exactly this picture. Otherwise starts from scratch, so the same command can be repeated." };
    private readonly SceneOverrides _overrides;
    private readonly LongRenderOptions _long;
    private readonly DisplayOptions _display;

    private RenderVerb(Command command)
    {
        _scene = new("SCENE") { Description = "The scene file: native (.json), Mitsuba (.xml), or a model." };
        command.Arguments.Add(_scene);
        _writing = new(command, $"The image file: {ImageFormat.Endings()}; or .rtfilm, the film itself. Repeatable.");
        _overrides = new(command);
        foreach (Option option in new Option[] { _threads.Symbol }.Concat(_writing.Looks).Concat([_writing.ExrFilm, _crop.Symbol, _pixel.Symbol, _sample.Symbol, _aovs.Symbol, _denoise, _noise.Symbol, _adaptive, _samples.Symbol, _part.Symbol, _frames.Symbol, _rate.Symbol]))
        {
            command.Options.Add(option);
        }

        _long = new(command, "Writes the film to this file (.rtfilm) from time to time, so that resume can continue from it.");
        command.Options.Add(_resume);
        _display = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        RenderVerb verb = new(command);
        command.SetAction(result =>
        {
            RenderRequest request = verb.Request(result);
            verb.WarnOfUnused(result, request, streams);
            if (FramesRun.Is(request))
            {
                return new FramesRun(request, s => verb._overrides.Apply(result, s), streams).Run();
            }

            request = request.Resume ? request.WithCheckpoint() : request;
            return new RenderRun(DisplayOptions.ForTerminal(request.WithFrameWords(), streams), s => verb._overrides.Apply(result, s), streams).Run();
        });
    }

    /// <summary>What some words after <c>render</c> ask for, and how they change the scene.</summary>
    /// <exception cref="CommandException">They are wrong.</exception>
    public static (RenderRequest Request, Func<SceneDescription, SceneDescription> Overrides) Parse(IReadOnlyList<string> words)
    {
        Command command = new("render");
        RenderVerb verb = new(command);
        ParseResult result = command.Parse(words, new() { ResponseFileTokenReplacer = null });
        return (CommandLine.EmptyWord(result) ?? (result.Errors.Count > 0 ? result.Errors[0].Message : null)) is { } complaint
            ? throw new CommandException(ExitStatus.Usage, complaint)
            : (verb.Request(result), s => verb._overrides.Apply(result, s));
    }

    private void WarnOfUnused(ParseResult result, RenderRequest request, Streams streams)
    {
        _writing.WarnOfUnused(result, request.Outputs, streams, isSeen: request.Preview);
        _long.WarnOfUnused(result, request, streams);
        if (request.FramesPerSecond is not null && !FramesRun.MakesAnimation(request))
        {
            streams.Warn("--fps has no effect: it is for animated PNGs (-o FILE.png or FILE.apng), and none is written");
        }
    }

    private RenderRequest Request(ParseResult result)
    {
        RenderRequest request = new()
        {
            ScenePath = result.GetValue(_scene)!,
            Outputs = _writing.Files(result),
            Writing = _writing.Writing(result),
            Threads = (int)(_threads.Value(result) ?? Environment.ProcessorCount),
            Crop = _crop.Value(result),
            Pixel = _pixel.Value(result),
            Sample = _sample.Value(result),
            Aovs = [.. _aovs.Value(result)?.OfType<AuxiliaryImage>() ?? []],
            Layers = [.. _aovs.Value(result)?.OfType<LightLayer>() ?? []],
            Denoise = result.GetValue(_denoise),
            Noise = _noise.Value(result),
            Adaptive = result.GetValue(_adaptive),
            Samples = _samples.Value(result),
            Part = _part.Value(result),
            Frames = _frames.Value(result),
            FramesPerSecond = _rate.Value(result),
            HasSamples = _overrides.HasSamples(result),
            Settings = _overrides.Settings(result),
            OverrideWords = [.. _overrides.Words(result)],
            Resume = result.GetValue(_resume),
            CommandText = CommandLine.Text(result),
        };
        request = _display.Put(result, _long.Put(result, request));
        return (FramesRun.Contradiction(request) ?? Contradiction(request)) is { } complaint ? throw new CommandException(ExitStatus.Usage, complaint) : request;
    }

    private static string? Contradiction(RenderRequest request) => request switch
    {
        { Outputs.Count: 0, Pixel: null, Json: false, Checkpoint: null } => "where to? Give -o FILE (or --json alone for the numbers, or --pixel x,y)",
        { Outputs.Count: > 0, Pixel: not null } => "--pixel prints numbers and writes no image: leave -o out",
        { Crop: not null, Pixel: not null } => "--pixel and --crop cannot go together",
        { Aovs.Count: > 0, Pixel: not null } or { Layers.Count: > 0, Pixel: not null } => "--pixel prints numbers and writes no image: leave --aov out",
        { Denoise: true, Pixel: not null } => "--pixel prints numbers and writes no image: leave --denoise out",
        { Denoise: true, Outputs.Count: 0 } => "--denoise writes an image: where to? Give -o FILE",
        { Aovs.Count: > 0, Outputs.Count: 0 } or { Layers.Count: > 0, Outputs.Count: 0 } => "--aov writes images: where to? Give -o FILE",
        { Pixel: not null } and ({ Noise: not null } or { Adaptive: true }) => "--pixel renders a given number of samples: leave --noise and --adaptive out",
        { Adaptive: true } and ({ Samples: not null } or { Part: not null }) => "--adaptive decides how many samples there are: leave --samples and --part out",
        { Preview: true, Pixel: not null } => "--pixel prints numbers: leave --preview out",
        { Preview: true, Adaptive: true } or { Preview: true, Denoise: true } or { Preview: true, Layers.Count: > 0 } =>
            "--preview shows passes over the whole picture, which --adaptive, --denoise and layers of light do not make: leave it out",
        { Adaptive: true, NeedsPasses: true } => "--adaptive gives pixels different numbers of samples, which films in files, --checkpoint and --time cannot resume: leave it out",
        { Noise: not null } and ({ Samples: not null } or { Part: not null }) => "--noise decides how many samples there are: leave --samples and --part out",
        { Samples: not null, Part: not null } => "--samples and --part cannot go together",
        { Pixel: not null } and ({ Samples: not null } or { Part: not null } or { Time: not null } or { Checkpoint: not null }) =>
            "--pixel goes with --sample only: leave --samples, --part, --time and --checkpoint out",
        { Denoise: true } and ({ NeedsPasses: true } or { Samples: not null } or { Part: not null }) =>
            "--denoise compares two halves of all samples: it cannot go together with shares of them or with .rtfilm, --exr-film, --checkpoint and --time",
        { Checkpoint: { } checkpoint } when !FilmFile.IsNamed(checkpoint) => $"--checkpoint {checkpoint}: films are written to .rtfilm files",
        { Resume: true, Checkpoint: null } => "--resume continues from a checkpoint: give --checkpoint FILE",
        { Adaptive: true, Crop: not null } => "--adaptive distributes samples over the whole picture: leave --crop out",
        { Adaptive: true, Denoise: true } => "--denoise compares two halves with equal numbers of samples, which --adaptive does not give: leave one of them out",
        { NeedsPasses: true, Layers.Count: > 0 } => "layers of light need one rendering, which .rtfilm, --exr-film, --checkpoint and --time may split: leave one of them out",
        { Adaptive: true, Layers.Count: > 0 } => "layers of light need equal numbers of samples, which --adaptive does not give: leave one of them out",
        { Outputs.Count: > 0 } and ({ Aovs.Count: > 0 } or { Denoise: true }) when request.Outputs.All(FilmFile.IsNamed) =>
            "--aov and --denoise write images, but only films are written: give -o FILE.png or another image too",
        { Part: { } part, Frames: not null } when !FramesRun.Is(request) => $"--part {part.Number}/{part.Count}: with --frames, frames are divided among parts: for a share of one frame's samples give --samples",
        { FramesPerSecond: not null, Frames: null } => "--fps is for animated PNGs: give --frames",
        { Outputs.Count: > 0, Frames: null } when request.Outputs.FirstOrDefault(AnimatedPng.IsNamed) is { } animated
            => $"-o {animated}: an animated PNG is made of --frames",
        { Sample: not null, Pixel: null } => "--sample needs --pixel",
        _ => null,
    };
}
