using System.CommandLine;
using System.Text;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>
/// <c>raytracer convert FROM TO</c>: writes a scene, of Mitsuba or pbrt or a model, in the native format; and images and films as images.
/// </summary>
internal sealed class ConvertVerb
{
    private readonly Argument<string> _from = new("FROM") { Description = "The file to read: a scene of Mitsuba (.xml) or pbrt (.pbrt), a native one (.json) or a model; or an image or a film." };
    private readonly Argument<string> _to = new("TO") { Description = "The file to write: a native scene (.json), an image, or a film (.rtfilm) if the input holds one.", Arity = ArgumentArity.ZeroOrOne };
    private readonly Option<string?> _output = new("-o", "--output") { HelpName = "FILE", Description = "The file to write, instead of TO." };
    private readonly ParsedOption<long?> _width = OptionValues.Integer("--width", "Images: scales down to this width; without --height, the aspect ratio is kept.", 1, int.MaxValue);
    private readonly ParsedOption<long?> _height = OptionValues.Integer("--height", "Images: the same, rows.", 1, int.MaxValue);
    private readonly JobOptionSet _settings;
    private readonly WritingOptions _writing;
    private readonly VerboseOption _verbose;

    private ConvertVerb(Command command)
    {
        command.Arguments.Add(_from);
        command.Arguments.Add(_to);
        _writing = new();
        command.AddOptions([_output, .. ForImages]);

        _settings = new(command, [JobOptions.Set]);
        _verbose = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        ConvertVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    private IEnumerable<Option> ForImages => [.. _writing.Looks, _writing.ExrFilm, _width, _height];

    private int Run(ParseResult result, Streams streams)
    {
        (string from, string to) = (result.GetValue(_from)!, Target(result));
        bool isScene = Path.GetExtension(to).Equals(".json", StringComparison.OrdinalIgnoreCase);
        if (isScene ? ImageFile.IsImage(from) : IsSceneName(from))
        {
            throw new CommandException(ExitStatus.Usage, isScene
                ? $"{Quotation.Of(from)} is an image, and no scene can be made from it"
                : $"scenes are written as .json files, not as {Quotation.Of(to)} (\"raytracer render\" makes images of them)");
        }

        foreach (Option option in ForImages.Where(o => isScene && result.GetResult(o) is { Implicit: false }))
        {
            throw new CommandException(
                ExitStatus.Usage, $"{option.Name} is for images: a scene's values are set as in --set render.width=800");
        }

        StageTimes stages = _verbose.Times(result, streams);
        int status = isScene ? ConvertScene(from, to, _settings.Given(result).Settings, stages, streams)
            : ConvertImage(from, to, result, stages, streams);
        stages.EndAll();
        return status;
    }

    private string Target(ParseResult result) => (result.GetValue(_to), result.GetValue(_output)) switch
    {
        (null, null) => throw new CommandException(ExitStatus.Usage, "where to? Give the file to write after the one to read"),
        ({ } to, { } output) =>
            throw new CommandException(ExitStatus.Usage, $"{Quotation.Of(to)} and -o {Quotation.Of(output)}: there is one file to write"),
        (var to, var output) => to ?? output!,
    };

    private static int ConvertScene(string path, string target, IReadOnlyList<SceneSetting> settings, StageTimes stages, Streams streams)
    {
        SceneLoadResult result = SceneFile.Load(path, stages, settings: settings);
        streams.Read(result.Diagnostics);
        if (result.Scene is null)
        {
            return SceneFile.FailureStatus(path);
        }

        // The names of files in the scene are meant from where it was.
        string text = SceneWriter.Write(WithIntegrator(path, settings, result.Description!), name => Moved(name, Folder(path), Folder(target)));
        AtomicFile.Write(target, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
        stages.End("write");
        return ExitStatus.Fine;
    }

    // A scene that names no integrator, but uses what only the report's has, names that one afterwards.
    private static SceneDescription WithIntegrator(string path, IReadOnlyList<SceneSetting> settings, SceneDescription scene) =>
        Path.GetExtension(path).Equals(".json", StringComparison.OrdinalIgnoreCase) && UnseenParts.AreForReport(scene)
            && SceneReader.Read(path, settings).Root?.Find("render")?.Find("integrator") is null
            ? scene with { Render = scene.Render with { Integrator = Integrator.Report } } : scene;

    private int ConvertImage(string path, string target, ParseResult result, StageTimes stages, Streams streams)
    {
        if (_settings.Given(result).Settings is [var setting, ..])
        {
            throw new CommandException(ExitStatus.Usage, $"--set {setting.Text}: images have no settings");
        }

        JobFiles.CheckFilm(target);
        _writing.WarnOfUnused(result, [target], streams);
        ImageWriteOptions writing = _writing.Writing(result, [target]);

        // Unless something else is wanted, nothing is lost.
        writing = _writing.Has(result, JobOptions.ExrType) ? writing : writing with { ExrPixelType = ExrPixelType.Float };
        if (writing.TakesFilm(target))
        {
            return ConvertFilm(path, target, writing, result, stages);
        }

        UnfinishedFilms.Check([target]);
        (IImageRows image, IReadOnlyList<KeyValuePair<string, string>> texts, IReadOnlyList<ExrLayerChannel> layers) = Read(path);
        writing = writing.OfImage(path, texts);
        stages.End(JobStage.Load);
        (int width, int height) = Size(image, (int?)_width.Value(result), (int?)_height.Value(result));
        bool isWhole = (width, height) == (image.Width, image.Height);
        if (layers.Count > 0 && !isWhole && ImageFormat.Has(target, ImageFeatures.Layers))
        {
            streams.Warn($"'{target}' lacks the layers {LayersOf(layers)} of '{path}': only the picture is scaled down");
        }

        ImageFile.Write(target, isWhole ? image : ScaledRows.Shrink(image, width, height), writing with { Metadata = isWhole ? Texts(texts, writing) : [], ExrLayers = isWhole ? layers : [] });
        stages.End("write");
        return ExitStatus.Fine;
    }

    // Those that it had, and how light is shown now.
    private static IReadOnlyList<KeyValuePair<string, string>> Texts(
        IReadOnlyList<KeyValuePair<string, string>> texts, ImageWriteOptions writing) => PictureTone.Text(writing) is { } tone
        ? [.. texts.Where(t => t.Key != PictureTone.Key), new(PictureTone.Key, tone)] : texts;

    private int ConvertFilm(string path, string target, ImageWriteOptions writing, ParseResult result, StageTimes stages)
    {
        if (new[] { _width, _height }.FirstOrDefault(o => result.GetResult(o) is { Implicit: false }) is { } scaled)
        {
            throw new CommandException(ExitStatus.Usage, $"{scaled.Name} is for images: a film cannot be scaled");
        }

        (FilmHeader header, Film film) = CarriedFilm.Read(path);
        UnfinishedFilms.Check([target], replacement: header);
        stages.End(JobStage.Load);
        JobFiles.WriteFilm(
            target, film, header, writing with { Metadata = PictureTexts.Of(header, film.ComputeHash()), ExrLayers = LayersBeside(path) });
        stages.End("write");
        return ExitStatus.Fine;
    }

    // The layers of an image that carries its film, but for those that are the film.
    private static IReadOnlyList<ExrLayerChannel> LayersBeside(string path) =>
        FilmExr.IsNamed(path) ? [.. ImageFile.ReadAll(path).Layers.Where(l => !FilmExr.IsOfFilm(l.Name))] : [];

    // What stands before the last point.
    private static string LayersOf(IEnumerable<ExrLayerChannel> channels) =>
        string.Join(", ", channels.Select(c => c.Name.LastIndexOf('.') is > 0 and var point ? c.Name[..point] : c.Name).Distinct());

    private static (IImageRows Image, IReadOnlyList<KeyValuePair<string, string>> Texts, IReadOnlyList<ExrLayerChannel> Layers) Read(string path)
    {
        if (CarriedFilm.Is(path))
        {
            (FilmHeader header, Film film) = CarriedFilm.Read(path);
            return header.Samples.Count > 0 ? (film, PictureTexts.Of(header, film.ComputeHash()), LayersBeside(path))
                : throw new CommandException(ExitStatus.InputOutput, $"'{path}' holds no samples yet");
        }

        (Picture picture, IReadOnlyList<KeyValuePair<string, string>> texts, IReadOnlyList<ExrLayerChannel> layers) = ImageFile.ReadAll(path);

        // What other programs wrote into a file stays there: it may be long, and no text of ours.
        return (picture, [.. texts.Where(t => PictureTexts.Keys.Contains(t.Key))], layers);
    }

    private static (int Width, int Height) Size(IImageRows image, int? width, int? height)
    {
        int w = width ?? (height is { } h ? Scaled(image.Width, h, image.Height) : image.Width);
        int rows = height ?? (width is { } columns ? Scaled(image.Height, columns, image.Width) : image.Height);
        return w <= image.Width && rows <= image.Height ? (w, rows)
            : throw new CommandException(
                ExitStatus.Usage, $"the image of {image.Width}×{image.Height} pixels can only be scaled down, not to {w}×{rows}");
    }

    private static int Scaled(int length, int part, int whole) =>
        (int)Math.Clamp(Math.Round((double)length * part / whole), 1, int.MaxValue);

    private static bool IsSceneName(string path) =>
        Path.GetExtension(path).ToLowerInvariant() is ".json" || SceneFormat.Of(path) is not null || ModelFile.IsModel(path);

    private static string Moved(string name, string from, string to) =>
        Path.IsPathRooted(name) || !File.Exists(Path.Combine(from, name)) ? name
        : Path.GetRelativePath(to, Path.GetFullPath(Path.Combine(from, name))).Replace('\\', '/');

    private static string Folder(string path) => Path.GetDirectoryName(Path.GetFullPath(path)) ?? "";
}
