using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using W = RayTracer.Jobs.OptionWords;

namespace RayTracer.Jobs;

/// <summary>The files that keep the value of an option.</summary>
public enum JobOptionUse
{
    /// <summary>None: it changes no picture.</summary>
    None,

    /// <summary>Pictures.</summary>
    Pictures,

    /// <summary>Films, and pictures.</summary>
    Films,
}

/// <summary>A value of a job by a name, for command lines and files.</summary>
/// <param name="Name">Its name, with two dashes; without them, it is the path among settings.</param>
/// <param name="Form">The form of its value; null for a flag.</param>
/// <param name="Description">Its meaning.</param>
/// <param name="Put">Puts a value into a job; throws <see cref="FormatException"/> with what was expected.</param>
/// <param name="Text">The value in a job; null where it is as without the option.</param>
public sealed record JobOption(
    string Name, string? Form, string Description, Func<RenderJob, string, RenderJob> Put, Func<RenderJob, string?> Text)
{
    /// <summary>The files that keep it.</summary>
    public JobOptionUse Use { get; init; }

    /// <summary>The setting of the scene that it is short for; null for none.</summary>
    public string? Setting { get; init; }

    /// <summary>True if it may be given several times.</summary>
    public bool IsRepeated { get; init; }

    /// <summary>The feature of the formats that it is for; null for all.</summary>
    public ImageFeatures? Feature { get; init; }
}

/// <summary>All options of jobs, in one table.</summary>
public static class JobOptions
{
    private const string UpPath = "camera.up";
    private static readonly string[] s_axes = ["x", "y", "z"];
    private static readonly string[] s_ups = ["[1,0,0]", "[0,1,0]", "[0,0,1]"];
    private const string Strategies = "strategies";
    private static readonly object[] s_aovs = [.. AuxiliaryImage.Known.All, .. Enum.GetValues<LightPathAov>(), Strategies];
    private static readonly string[] s_aovNames = [.. s_aovs.Select(
        a => a is AuxiliaryImage image ? image.Name : $"{a}".ToLowerInvariant())];

    /// <summary>A value of the scene.</summary>
    public static JobOption Set { get; } = new(
        "--set",
        "PATH=VALUE",
        "Puts a value in the place of the scene's, with the same checks: --set camera.fieldOfView=35, --set shapes[2].radius=1, "
            + "--set materials.glass.color=red. May be given several times.",
        (j, w) => j with { Settings = [.. j.Settings, SceneSetting.Parse(w)] },
        _ => null)
    { IsRepeated = true };

    // Its place is the camera's; a model that is shown by itself stands on its ground so.
    private static JobOption Up { get; } = new(
        "--up",
        "x|y|z",
        "The axis that is up in the picture; of a model file without a camera, the whole view. Replaces the scene's.",
        (j, w) => j with { Settings = [.. j.Settings, SceneSetting.Parse($"{UpPath}={W.Choice(w, s_axes, s_ups)}")] },
        j => j.Settings.LastOrDefault(s => s.Path == UpPath) is { } up && Array.IndexOf(s_ups, up.Value) is >= 0 and int i ? s_axes[i] : null)
    { Setting = UpPath };

    /// <summary>Those that replace what the scene says.</summary>
    public static IReadOnlyList<JobOption> OfScenes { get; } =
    [
        Side("--width", "width"), Side("--height", "height"),
        new("--scale", "X%", "The size of the picture as a share of the scene's: 50%.", (j, w) => j with { Scale = W.Percentage(w) }, j =>
            j.Scale is { } scale ? Invariant($"{scale * 100}%") : null),
        Short("--spp", "samplesPerPixel"), Short("--seed", "seed"),
        Short("--sampler", "sampler"), Short("--integrator", "integrator"),
        Short("--max-depth", "maxDepth"), Short("--max-diffuse-depth", "maxDiffuseDepth"), Short("--max-specular-depth", "maxSpecularDepth"),
        Up, Set,
    ];

    /// <summary>The type of the picture's numbers.</summary>
    public static JobOption ExrType { get; } = new("--exr-type", "half|float", $"{ImageFormat.Names(ImageFeatures.PixelType)}: the type of the picture's numbers; half without it (convert: float).",
        (j, w) => Written(j, o => o with { ExrPixelType = W.Choice(w, ["half", "float"], [ExrPixelType.Half, ExrPixelType.Float]) }), j => j.Writing.ExrPixelType == ExrPixelType.Half ? null : "float")
    { Use = JobOptionUse.Pictures, Feature = ImageFeatures.PixelType };

    /// <summary>Those of how pictures look.</summary>
    public static IReadOnlyList<JobOption> OfLooks { get; } =
    [
        new("--exposure", "X|auto|limited", $"{ImageFormat.Names(ImageFeatures.Display)}: stops by which the picture is made brighter (each doubles the light); "
            + "auto: as its brightness asks for; limited: 0, or darker if it would be a white sheet. Replaces the scene's.",
            (j, w) => Written(j, o => o with { Exposure = W.Exposure(w) }),
            j => j.Writing.Exposure?.ToString()) { Use = JobOptionUse.Pictures, Feature = ImageFeatures.Display },
        new("--tonemap", string.Join('|', W.Of<ToneMap>()), $"{ImageFormat.Names(ImageFeatures.Display)}: how bright light becomes what a screen can show; "
            + "clamp cuts it off. Replaces the scene's.",
            (j, w) => Written(j, o => o with { ToneMap = W.Choice(w, W.Of<ToneMap>(), Enum.GetValues<ToneMap>()) }),
            j => j.Writing.ToneMap?.ToString().ToLowerInvariant()) { Use = JobOptionUse.Pictures, Feature = ImageFeatures.Display },
        new("--bit-depth", "8|16", $"{ImageFormat.Names(ImageFeatures.BitDepth)}: bits a channel; 8 without it.", (j, w) => Written(
            j, o => o with { BitDepth = W.Choice(w, ["8", "16"], [8, 16]) }),
            j => Text(j.Writing.BitDepth, 8)) { Use = JobOptionUse.Pictures, Feature = ImageFeatures.BitDepth },
        new("--quality", "N", $"{ImageFormat.Names(ImageFeatures.Quality)}: smallest file to best picture; {JpegWriter.StandardQuality} without it.",
            (j, w) => Written(j, o => o with { JpegQuality = (int)W.Integer(w, 1, 100) }), j =>
                Text(j.Writing.JpegQuality, JpegWriter.StandardQuality))
        { Use = JobOptionUse.Pictures, Feature = ImageFeatures.Quality },
        new("--chroma", string.Join('|', W.Of<JpegChroma>()), $"{ImageFormat.Names(ImageFeatures.Chroma)}: colours of every pixel or every four; full from 90 on without it.",
            (j, w) => Written(j, o => o with { JpegChroma = W.Choice(w, W.Of<JpegChroma>(), Enum.GetValues<JpegChroma>()) }), j =>
                j.Writing.JpegChroma?.ToString().ToLowerInvariant())
        { Use = JobOptionUse.Pictures, Feature = ImageFeatures.Chroma },
        ExrType,
    ];

    /// <summary>The option that images carry the film; of verbs that have it.</summary>
    public static JobOption ExrFilm { get; } = new("--exr-film", null, "OpenEXR: the image carries the film itself, which resume adds samples to, as to .rtfilm.",
        (j, _) => Written(j, o => o with { ExrFilm = true }), j => Flag(j.Writing.ExrFilm))
    { Use = JobOptionUse.Pictures };

    /// <summary>The option that pictures lack what is behind everything; of verbs that have the film.</summary>
    public static JobOption Transparent { get; } = new(
        "--transparent", null, $"{ImageFormat.Names(ImageFeatures.Alpha)}: what is behind everything is left out, and alpha says how much of each pixel is seen.",
        (j, _) => Written(j, o => o with { Transparent = true }), j => Flag(j.Writing.Transparent))
    { Use = JobOptionUse.Pictures, Feature = ImageFeatures.Alpha };

    /// <summary>The option that films keep what a denoiser compares.</summary>
    public static JobOption Halves { get; } = new(
        "--halves", null, "Films keep two halves of the samples apart, for the verb denoise and for resume --denoise. Implied by --denoise.",
        (j, _) => j with { Halves = true }, j => Flag(j.KeepsHalves))
    { Use = JobOptionUse.Pictures };

    /// <summary>The number of threads.</summary>
    public static JobOption Threads { get; } = new("--threads", "N", "Number of threads; without it, one for each core.", (j, w) => j with { Threads = (int)W.Integer(w, 1, 1024) }, _ => null);

    /// <summary>The part of the picture.</summary>
    public static JobOption Crop { get; } = new("--crop", "x,y,w,h", "Renders only this rectangle of pixels; the rest of the image stays black.",
        (j, w) => j with { Crop = W.Integers(w, "x,y,w,h") is [var x, var y, var width, var height] ? new(x, y, width, height) : null },
        j => j.Crop is { } c ? $"{c.X},{c.Y},{c.Width},{c.Height}" : null)
    { Use = JobOptionUse.Pictures };

    /// <summary>The frames.</summary>
    public static JobOption Frames { get; } = new("--frames", "N|A..B|A..B:STEP",
        "Renders these frames of the animation, both included, each to its own file: -o frame-####.png. Frames that are there already are left as they are.",
        (j, w) => j with { Frames = FrameRange.Parse(w) }, j => j.Frames?.ToString())
    { Use = JobOptionUse.Films };

    /// <summary>Those of rendering for long.</summary>
    public static IReadOnlyList<JobOption> OfLongRenders { get; } =
    [
        new("--time", "TIME", "Stops after the pass over the picture under way at this time: 90s, 10m, 1.5h, 1h30m. At most --spp samples are taken (65,536 without it).",
            (j, w) => j with { Time = W.Duration(w) }, j =>
                j.Time is { } time ? Invariant($"{time.TotalSeconds}s") : null) { Use = JobOptionUse.Pictures },
        new("--checkpoint", "FILE", "Writes the film to this file (.rtfilm) now and then, for resume.", (j, w) => j with { Checkpoint = w }, j => j.Checkpoint),
        new("--checkpoint-interval", "TIME", "The time between checkpoints; 30s without it. Longer where writing would take more than 1 % of the time.",
            (j, w) => j with { CheckpointInterval = W.Duration(w, allowsZero: true) }, _ => null),
    ];

    /// <summary>The file that keeps what was learned.</summary>
    public static JobOption GuideFile { get; } = new("--guide-file", "FILE", "With --guide: reads what was learned from this file, or writes it there where the file does not exist.",
        (j, w) => j with { GuideFile = w }, j => j.GuideFile);

    /// <summary>Those of guiding.</summary>
    public static IReadOnlyList<JobOption> OfGuiding { get; } =
    [
        new("--guide", null, "Learns where light comes from before the picture, and sends paths there: for light that comes through gaps and around corners. With the path integrator.",
            (j, _) => j with { Guide = true }, j => Flag(j.Guide)) { Use = JobOptionUse.Films },
        GuideFile,
    ];

    private static JobOption OfEdition { get; } = new("--edition", string.Join('|', Edition.Words),
        "Which edition renders: the fast one; or the one to be read (docs/textbook.md), with the scene's integrator or one of its own. It has fewer features, and its bits depend on the system.",
        (j, w) => j with { Edition = W.Choice(w, Edition.Words, [null, .. Edition.Words.Skip(1)]) }, j => j.Edition)
    { Use = JobOptionUse.Films };

    /// <summary>All that <c>render</c> has.</summary>
    public static IReadOnlyList<JobOption> All { get; } =
    [
        .. OfScenes,
        Threads, .. OfLooks, Transparent, ExrFilm, Crop,
        new("--pixel", "x,y", "Renders only this pixel and prints its radiance.", (j, w) => j with { Pixel = W.Integers(w, "x,y") is [var x, var y] ? (x, y) : null },
            j => j.Pixel is { } p ? $"{p.X},{p.Y}" : null),
        new("--sample", "N", "With --pixel: renders only this sample, from 0.", (j, w) => j with { Sample = (int)W.Integer(w, 0, int.MaxValue - 1) }, j => Text(j.Sample, null)),
        new("--aov", string.Join(',', s_aovNames), $"Writes auxiliary images too: of what is known of pixels ({AuxiliaryImage.Known.All[0].Name} to {AuxiliaryImage.Known.All[^1].Name}), or parts of the light "
            + "(emission to lights, which is one for each light; strategies: by each way to make paths from both ends). As layers of .exr files, else in files beside them (out.depth.png). One or more, with commas between them.", PutAovs, AovText) { Use = JobOptionUse.Pictures },
        new("--denoise", null, "Writes a denoised picture too: as a layer of .exr files, else in a file beside them (out.denoised.png).",
            (j, _) => j with { Denoise = true }, j => Flag(j.Denoise)) { Use = JobOptionUse.Pictures },
        Halves,
        new("--noise", "X%", "Stops at this estimated relative error of the picture, or at the number of samples given by --spp (65,536 without it). The estimate is cautious: "
            + "stratified samplers (sobol) come out better.", (j, w) =>
                j with { Noise = W.Fraction(w) }, j => Text(j.Noise, null)) { Use = JobOptionUse.Films },
        new("--adaptive", null, "Spends samples where the error is: --spp is the mean then. With --noise, only as many as that takes.",
            (j, _) => j with { Adaptive = true }, j => Flag(j.Adaptive)) { Use = JobOptionUse.Pictures },
        .. OfGuiding, OfEdition,
        new("--samples", "A..B", "Renders only these samples of each pixel, both included, from 0. With -o part.rtfilm, for merge.",
            (j, w) =>
                j with { Samples = W.Samples(w) }, j => j.Samples is { } s ? FilmHeader.Text(s) : null) { Use = JobOptionUse.Pictures },
        new("--part", "I/N", "Renders only the I-th, from 1, of N equal shares of the samples. With -o part.rtfilm, for merge.",
            (j, w) => j with { Part = W.Part(w) }, j =>
                j.Part is var (number, count) ? $"{number}/{count}" : null) { Use = JobOptionUse.Pictures },
        Frames,
        new("--fps", "X", "With --frames and -o FILE.png or FILE.apng, which make an animated PNG: frames shown a second; without it, the scene's framesPerSecond.",
            (j, w) => j with { FramesPerSecond = W.Number(w, 0.01, 1000) }, j => Text(j.FramesPerSecond, null)),
        .. OfLongRenders,
        new("--resume", null, "Resumes the film of --checkpoint, if it is there: it must be of this very picture. If it is not there, begins from scratch. So the same command can be "
            + "given again.", (j, _) => j with { Resume = true }, j => Flag(j.Resume)),
        new("--overwrite", null, "Begins from scratch where the file of --checkpoint holds a film of this very picture, which is lost. One of another picture stays.",
            (j, _) => j with { Overwrite = true }, j => Flag(j.Overwrite)),
    ];

    /// <summary>The option of a name; null where there is none.</summary>
    public static JobOption? Find(string name) => All.FirstOrDefault(o => o.Name == name);

    /// <summary>A job with one more setting.</summary>
    /// <param name="job">The job.</param>
    /// <param name="setting">The name of an option without its dashes, or a path of the scene, an equals sign, and the value.</param>
    /// <exception cref="FormatException">It is none.</exception>
    public static RenderJob Put(RenderJob job, string setting) =>
        setting.Split('=', 2) is [var path, var value] && Find($"--{path}") is { Use: not JobOptionUse.None } option
        ? option.Put(job, value)
        : job with { Settings = [.. job.Settings, SceneSetting.Parse(setting)] };

    /// <summary>The values of a job that files of some kind keep, besides the scene's settings.</summary>
    internal static IEnumerable<string> Kept(RenderJob job, JobOptionUse use) =>
        All.Where(o => o.Use == use && o.Text(job) is not null).Select(o => $"{o.Name[2..]}={o.Text(job)}");

    /// <summary>A setting of the scene as an option with its value.</summary>
    internal static string Given(SceneSetting setting) => string.Join(' ', Words(setting));

    /// <summary>The words of a command line that make a job of its scene.</summary>
    internal static IEnumerable<string> Words(RenderJob job) => job.Settings.SelectMany(Words)
        .Concat(All.Where(o => (o.Use != JobOptionUse.None || o.Name is "--pixel" or "--sample") && o.Text(job) is not null)
            .SelectMany(o => o.Form is null ? [o.Name] : new[] { o.Name, o.Text(job)! }));

    private static string[] Words(SceneSetting setting) =>
        OfScenes.FirstOrDefault(o => o.Setting == setting.Path) is { } option
            && option.Text(new() { Scene = "", Settings = [setting] }) is { } value ? [option.Name, value] : ["--set", setting.Text];

    private static JobOption Short(string name, string key)
    {
        RecordParameter parameter = RecordType.Of(typeof(RenderDescription)).Find(key)!;
        string path = $"render.{key}";
        string Value(string word) => parameter.Choices.Count > 0 ? W.Choice(word, parameter.Choices, parameter.Choices)
            : !long.TryParse(word, out long value) ? throw new FormatException($"expected a whole number, not {Quotation.Of(word)}")
            : parameter.RangeComplaint(value) is { } complaint ? throw new FormatException(complaint)
            : Invariant($"{value}");
        return new(name, parameter.Choices.Count > 0 ? string.Join('|', parameter.Choices) : "N", $"{parameter.Summary} Replaces the scene's.",
            (j, w) => j with { Settings = [.. j.Settings, SceneSetting.Parse($"{path}={Value(w)}")] }, j =>
                j.Settings.LastOrDefault(s => s.Path == path)?.Value)
        { Setting = path };
    }

    // Of one alone follows the other.
    private static JobOption Side(string name, string key)
    {
        JobOption side = Short(name, key);
        string description = $"{side.Description} Alone, it keeps the aspect ratio.";
        return side with { Description = description, Put = (j, w) => side.Put(j, w) with { KeepsAspect = true } };
    }

    private static RenderJob PutAovs(RenderJob job, string list)
    {
        object[] kinds = [.. list.Split(',').Select(word => Array.IndexOf(s_aovNames, word) is >= 0 and int i ? s_aovs[i]
            : throw new FormatException($"unknown image {Quotation.Of(word)}{Spelling.DidYouMean(word, s_aovNames)}, expected some of {string.Join(", ", s_aovNames)}"))];
        return job with { Aovs = [.. kinds.OfType<AuxiliaryImage>()], Layers = [.. kinds.OfType<LightPathAov>()], Strategies = kinds.Contains(Strategies) };
    }

    private static string? AovText(RenderJob job) =>
        job.Aovs.Cast<object>().Concat(job.Layers.Cast<object>()).Concat(job.Strategies ? [Strategies] : []).Select(a => s_aovNames[Array.IndexOf(s_aovs, a)])
            .ToArray() is { Length: > 0 } names ? string.Join(',', names) : null;

    private static RenderJob Written(RenderJob job, Func<ImageWriteOptions, ImageWriteOptions> change) =>
        job with { Writing = change(job.Writing) };

    private static string? Flag(bool isOn) => isOn ? "true" : null;

    private static string? Text<T>(T value, T standard) => Equals(value, standard) ? null : Invariant($"{value}");

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
