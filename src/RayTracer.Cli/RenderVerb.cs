using System.CommandLine;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Cli;

/// <summary><c>raytracer render SCENE -o FILE</c>: the options. The work is in <see cref="RenderRun"/>.</summary>
internal sealed class RenderVerb
{
    private readonly Argument<string> _scene;
    private readonly Option<string[]> _outputs = new("-o", "--output") { Description = "The image file: .png, .pfm, .exr or .hdr. May be given several times.", HelpName = "FILE" };
    private readonly ParsedOption<long?> _threads = OptionValues.Integer("--threads", "Number of threads; without it, one for each core.", 1, 1024);
    private readonly ParsedOption<double?> _exposure = OptionValues.Number("--exposure", "PNG: stops by which the picture is made brighter (each doubles the light).", -100, 100);
    private readonly ParsedOption<ToneMap?> _toneMap = OptionValues.Choice<ToneMap>("--tonemap", "PNG: how bright light is brought into what a screen can show; clamp cuts it off.");
    private readonly ParsedOption<int?> _bitDepth = OptionValues.Choice<int?>("--bit-depth", "PNG: bits a channel; 8 without it.", ["8", "16"], [8, 16]);
    private readonly ParsedOption<int[]?> _crop = OptionValues.Integers("--crop", "x,y,w,h", "Renders only this rectangle of pixels; the rest of the image stays black.");
    private readonly ParsedOption<int[]?> _pixel = OptionValues.Integers("--pixel", "x,y", "Renders only this pixel and prints its radiance.");
    private readonly ParsedOption<long?> _sample = OptionValues.Integer("--sample", "With --pixel: renders only this sample, from 0.", 0, int.MaxValue - 1);
    private readonly ParsedOption<Enum[]?> _aovs = OptionValues.Words<Enum>(
        "--aov", "Writes auxiliary images too: of what camera rays meet first (depth to samples), or parts of the light (emission to lights, which is one for each light). As layers of .exr files, else in files beside them (out.depth.png). One or more, with commas between them.", kind => kind is Aov aov ? AovFiles.Name(aov) : $"{kind}".ToLowerInvariant(), [.. Enum.GetValues<Aov>(), .. Enum.GetValues<LightLayer>()]);
    private readonly Option<bool> _denoise = new("--denoise") { Description = "Writes a denoised picture too: as a layer of .exr files, else in a file beside them (out.denoised.png)." };
    private readonly ParsedOption<double?> _noise = OptionValues.Fraction(
        "--noise", "Stops at this estimated relative error of the picture, or at the number of samples given by --spp (65,536 without it). The estimate is cautious: stratified samplers (sobol) come out better.");
    private readonly Option<bool> _adaptive = new("--adaptive") { Description = "Spends samples where the error is: --spp is the mean then. With --noise, only as many as that takes." };
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Prints errors and warnings only." };
    private readonly Option<bool> _json = new("--json") { Description = "Prints one JSON object of numbers." };
    private readonly SceneOverrides _overrides;

    private RenderVerb(Command command)
    {
        _scene = new("SCENE") { Description = "The scene file: native (.json), of Mitsuba (.xml), or a model." };
        command.Arguments.Add(_scene);
        command.Options.Add(_outputs);
        _overrides = new(command);
        foreach (Option option in new Option[] { _threads.Symbol, _exposure.Symbol, _toneMap.Symbol, _bitDepth.Symbol, _crop.Symbol, _pixel.Symbol, _sample.Symbol, _aovs.Symbol, _denoise, _noise.Symbol, _adaptive, _quiet, _json })
        {
            command.Options.Add(option);
        }
    }

    public static void Build(Command command, Streams streams)
    {
        RenderVerb verb = new(command);
        command.SetAction(result => new RenderRun(verb.Request(result), s => verb._overrides.Apply(result, s), streams).Run());
    }

    private RenderRequest Request(ParseResult result)
    {
        RenderRequest request = new()
        {
            ScenePath = result.GetValue(_scene)!,
            Outputs = result.GetValue(_outputs) ?? [],
            Writing = new()
            {
                BitDepth = _bitDepth.Value(result) ?? 8,
                Exposure = (float)(_exposure.Value(result) ?? 0),
                ToneMap = _toneMap.Value(result) ?? ToneMap.Clamp,
            },
            Threads = (int)(_threads.Value(result) ?? Environment.ProcessorCount),
            Crop = _crop.Value(result),
            Pixel = _pixel.Value(result),
            Sample = _sample.Value(result),
            Aovs = [.. _aovs.Value(result)?.OfType<Aov>() ?? []],
            Layers = [.. _aovs.Value(result)?.OfType<LightLayer>() ?? []],
            Denoise = result.GetValue(_denoise),
            Noise = _noise.Value(result),
            Adaptive = result.GetValue(_adaptive),
            HasSamples = _overrides.HasSamples(result),
            Quiet = result.GetValue(_quiet),
            Json = result.GetValue(_json),
            OverrideWords = [.. _overrides.Words(result)],
            CommandText = Shell.Command(result.Tokens.Select(t => t.Value)),
        };
        return Contradiction(request) is { } complaint ? throw new CommandException(ExitStatus.Usage, complaint) : request;
    }

    private static string? Contradiction(RenderRequest request) => request switch
    {
        { Outputs.Count: 0, Pixel: null, Json: false } => "where to? Give -o FILE (or --json alone for the numbers, or --pixel x,y)",
        { Outputs.Count: > 0, Pixel: not null } => "--pixel prints numbers and writes no image: leave -o out",
        { Crop: not null, Pixel: not null } => "--pixel and --crop cannot go together",
        { Aovs.Count: > 0, Pixel: not null } or { Layers.Count: > 0, Pixel: not null } => "--pixel prints numbers and writes no image: leave --aov out",
        { Denoise: true, Pixel: not null } => "--pixel prints numbers and writes no image: leave --denoise out",
        { Denoise: true, Outputs.Count: 0 } => "--denoise writes an image: where to? Give -o FILE",
        { Aovs.Count: > 0, Outputs.Count: 0 } or { Layers.Count: > 0, Outputs.Count: 0 } => "--aov writes images: where to? Give -o FILE",
        { Pixel: not null } and ({ Noise: not null } or { Adaptive: true }) => "--pixel renders the samples that it is told to: leave --noise and --adaptive out",
        { Adaptive: true, Crop: not null } => "--adaptive shares samples out over the whole picture: leave --crop out",
        { Adaptive: true, Denoise: true } => "--denoise compares two halves of equal samples, which --adaptive has not: leave one of them out",
        { Adaptive: true, Layers.Count: > 0 } => "layers of light are of equal samples, which --adaptive has not: leave one of them out",
        { Sample: not null, Pixel: null } => "--sample needs --pixel",
        _ => null,
    };
}
