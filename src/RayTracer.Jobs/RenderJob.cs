using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Jobs;

/// <summary>
/// A scene with settings, and the files to render it into. <see cref="JobOptions"/> has the words for each of its values.
/// </summary>
public sealed record RenderJob
{
    /// <summary>The path of the number of samples among the settings.</summary>
    public const string SamplesPath = "render.samplesPerPixel";

    private const string WidthPath = "render.width";
    private const string HeightPath = "render.height";
    private SizedScene? _sized;

    /// <summary>The scene's file, as its user named it.</summary>
    public required string Scene { get; init; }

    /// <summary>The scene's text, where it stands in no file yet; null to read the file.</summary>
    public string? Text { get; init; }

    /// <summary>The values that replace those of the scene.</summary>
    public IReadOnlyList<SceneSetting> Settings { get; init; } = [];

    /// <summary>The files to write.</summary>
    public IReadOnlyList<string> Outputs { get; init; } = [];

    /// <summary>The details of writing pictures; their texts are added later.</summary>
    public ImageWriteOptions Writing { get; init; } = new();

    /// <summary>The number of threads.</summary>
    public int Threads { get; init; } = Environment.ProcessorCount;

    /// <summary>The part of the picture to render; null for all.</summary>
    public Tile? Crop { get; init; }

    /// <summary>The only pixel to render; null for all.</summary>
    public (int X, int Y)? Pixel { get; init; }

    /// <summary>The only sample to render; null for all.</summary>
    public int? Sample { get; init; }

    /// <summary>The auxiliary images to write.</summary>
    public IReadOnlyList<AuxiliaryImage> Aovs { get; init; } = [];

    /// <summary>The layers of light to write.</summary>
    public IReadOnlyList<LightPathAov> Layers { get; init; } = [];

    /// <summary>True if what each way to make paths brings is written too.</summary>
    public bool Strategies { get; init; }

    /// <summary>True if a denoised picture is written too.</summary>
    public bool Denoise { get; init; }

    /// <summary>True if films in files keep two halves of the samples apart.</summary>
    public bool Halves { get; init; }

    /// <summary>True if films hold what is behind everything, whether pictures show it or not.</summary>
    public bool Alpha { get; init; }

    /// <summary>The relative error at which to stop; null to take all samples.</summary>
    public double? Noise { get; init; }

    /// <summary>True if samples are spent where the error is.</summary>
    public bool Adaptive { get; init; }

    /// <summary>The edition that renders: <c>textbook</c>, or <c>textbook:</c> with an integrator of its own; null for the fast one.</summary>
    public string? Edition { get; init; }

    /// <summary>True if paths are guided by what others learned before the picture.</summary>
    public bool Guide { get; init; }

    /// <summary>The file that keeps what was learned; null for none.</summary>
    public string? GuideFile { get; init; }

    /// <summary>The samples to render; null for all.</summary>
    public SampleRange? Samples { get; init; }

    /// <summary>The part to render of several equal parts of the samples, or of the frames, from 1; null for all.</summary>
    public (int Number, int Count)? Part { get; init; }

    /// <summary>The frames to render; null for the scene as it is written.</summary>
    public FrameRange? Frames { get; init; }

    /// <summary>The frames of an animated PNG that are shown a second; null for what the scene says.</summary>
    public double? FramesPerSecond { get; init; }

    /// <summary>After which time to stop; null for never.</summary>
    public TimeSpan? Time { get; init; }

    /// <summary>The file that the film is written to now and then; null for none.</summary>
    public string? Checkpoint { get; init; }

    /// <summary>The shortest time between two of them.</summary>
    public TimeSpan CheckpointInterval { get; init; } = TimeSpan.FromSeconds(30);

    /// <summary>True if the film of the checkpoint, where there is one, is resumed.</summary>
    public bool Resume { get; init; }

    /// <summary>True if the film of the checkpoint, where there is one of this picture, is replaced from scratch.</summary>
    public bool Overwrite { get; init; }

    /// <summary>The film that samples are added to; null for a new one.</summary>
    public HeldFilm? Resumed { get; init; }

    /// <summary>
    /// The film of what has been decided on the number of samples (<see cref="DecisionCheckpoint"/>); null to begin from scratch.
    /// </summary>
    public HeldFilm? Decision { get; init; }

    /// <summary>True if a film is given samples for some time, and counts as whole with as many as there will be.</summary>
    public bool IsOpenEnded { get; init; }

    /// <summary>True if the picture is one of several frames, which are not written before they are whole.</summary>
    public bool IsOfSequence { get; init; }

    /// <summary>The output that is a frame kept for an animated PNG, and has no images beside it; null where there is none.</summary>
    public string? Kept { get; init; }

    /// <summary>True where a width or height that is given alone keeps the scene's aspect ratio.</summary>
    public bool KeepsAspect { get; init; }

    /// <summary>The size of the picture as a share of the scene's; null where settings give it.</summary>
    public double? Scale { get; init; }

    /// <summary>The only frame to render; null for the scene as it is written.</summary>
    public int? Frame => Frames is { Count: 1 } frames ? frames.First : null;

    /// <summary>The number of samples that was given; null for the scene's.</summary>
    public int? GivenSamples =>
        Settings.LastOrDefault(s => s.Path == SamplesPath) is { } setting && int.TryParse(setting.Value, out int samples) ? samples : null;

    /// <summary>True if the film goes to a file, now or later.</summary>
    public bool KeepsFilm => Time is not null || HasFilmFile;

    /// <summary>True if there is a file that the film comes from or goes to.</summary>
    public bool HasFilmFile => Checkpoint is not null || Resumed is not null || Outputs.Any(Writing.TakesFilm);

    /// <summary>True if films in files hold halves of the samples: where asked for, or where they are compared.</summary>
    public bool KeepsHalves => Resumed?.Film.Planes.Contains(FilmPlane.Half) ?? (Halves || (Denoise && HasFilmFile));

    /// <summary>True if films hold what is behind everything.</summary>
    public bool KeepsAlpha => Resumed?.Film.Planes.Contains(FilmPlane.Alpha) ?? (Alpha || Writing.Transparent);

    /// <summary>The planes of films in files beside the picture.</summary>
    /// <param name="integrator">The integrator that computes it.</param>
    /// <param name="hasMattes">True where things of the scene stand for those of a photograph.</param>
    public IReadOnlyList<FilmPlane> Planes(Integrator integrator, bool hasMattes) =>
        Resumed?.Film.KeptPlanes ?? FilmPlane.Needed(integrator, KeepsHalves, alpha: KeepsAlpha, matte: KeepsAlpha && hasMattes);

    /// <summary>The settings that a film names: the scene's, the frame, and the noise that decided on the number of its samples.</summary>
    public IReadOnlyList<string> FilmSettings => [.. Settings.Select(s => s.Text), .. JobOptions.Kept(this, JobOptionUse.Films)];

    /// <summary>The settings that a picture names: all that decides what stands in it.</summary>
    public IReadOnlyList<string> PictureSettings => [.. FilmSettings, .. JobOptions.Kept(this, JobOptionUse.Pictures)];

    /// <summary>The command that renders it, as it is typed.</summary>
    public string Command =>
        Shell.Command(["render", Argument(Scene), .. JobOptions.Words(this), .. Outputs.SelectMany(o => new[] { "-o", Argument(o) })]);

    /// <summary>The job with more settings, which replace those of the same path.</summary>
    /// <param name="settings">Texts such as <c>render.seed=3</c> or <c>crop=0,0,8,8</c>.</param>
    /// <exception cref="FormatException">One of them is none.</exception>
    public RenderJob With(IEnumerable<string> settings) => settings.Aggregate(this, JobOptions.Put);

    /// <summary>The job with a number of samples for the whole picture, whatever decided on it before.</summary>
    public RenderJob WithSamples(int total) =>
        this with { Noise = null, Settings = [.. Settings.Where(s => s.Path != SamplesPath), SceneSetting.Parse($"{SamplesPath}={total}")] };

    /// <summary>The job with both sides of its picture as settings, where they follow from the scene's; it reads the scene for that, to be built without reading it again.</summary>
    /// <exception cref="JobException">The picture would be too large or too small.</exception>
    public RenderJob Sized()
    {
        SceneSetting[] given = [.. Settings.Where(s => s.Path is WidthPath or HeightPath)];
        bool isOpen = Scale is not null || (KeepsAspect && given.DistinctBy(s => s.Path).Count() == 1);
        RenderJob unsized = this with { Settings = [.. Settings.Except(given)], Scale = null, KeepsAspect = false };
        if (!isOpen || unsized.Read() is not { Description.Render: var render } read)
        {
            return this;
        }

        double scale = Scale ?? (double.Parse(given[^1].Value, CultureInfo.InvariantCulture) / (given[^1].Path == WidthPath ? render.Width : render.Height));
        RenderJob sized = unsized.With([Side(WidthPath, render.Width * scale), Side(HeightPath, render.Height * scale)]);
        return sized with { _sized = new(read, sized.Settings, Frame) };
    }

    /// <summary>The job with the film of its checkpoint, where there is one to resume.</summary>
    /// <exception cref="Textures.PictureException">It cannot be read.</exception>
    public RenderJob WithCheckpoint()
    {
        if (!Resume || !File.Exists(Checkpoint))
        {
            return this;
        }

        HeldFilm held = HeldFilm.Read(Checkpoint);
        return DecisionCheckpoint.Is(held.Header) ? this with { Decision = held } : this with { Resumed = held };
    }

    /// <summary>Reads the scene, and builds it.</summary>
    /// <param name="change">Changes the description before the scene is built; may be null.</param>
    /// <param name="readPicture">Reads pictures; null for <see cref="ImageFile.Read"/>.</param>
    public SceneLoadResult Load(Func<SceneDescription, SceneDescription>? change = null, Func<string, bool, Textures.Picture>? readPicture = null)
    {
        if (_sized?.Take(this) is not { } read)
        {
            return Read().Build(change, readPicture);
        }

        int Given(string path) => int.Parse(Settings.Last(s => s.Path == path).Value, CultureInfo.InvariantCulture);
        return read.Build(
            scene =>
            {
                SceneDescription sized = scene with { Render = scene.Render with { Width = Given(WidthPath), Height = Given(HeightPath) } };
                return change?.Invoke(sized) ?? sized;
            },
            readPicture);
    }

    /// <summary>The description of the scene, without building it; null where it has errors.</summary>
    public SceneDescription? Describe() => Read().Description;

    /// <summary>The command that follows one sample's path again.</summary>
    public string ReplayCommand(BadSample bad) =>
        (new RenderJob { Scene = Scene, Settings = Settings, Frames = Frames, Guide = Guide, Pixel = (bad.X, bad.Y), Sample = bad.Sample }).Command;

    private ReadScene Read() => Text is null ? SceneLoader.Read(Scene, Settings, Frame)
        : SceneLoader.ReadText(Text, Path.GetFileName(Scene), Path.GetDirectoryName(Scene)!, Settings, Frame);

    private static string Side(string path, double length)
    {
        long side = long.Max((long)double.Round(length), 1);
        return RecordType.Of(typeof(RenderDescription)).Find(path["render.".Length..])!.RangeComplaint(side) is { } complaint
            ? throw new JobException(JobFault.Request, $"{path} {complaint}") : string.Create(CultureInfo.InvariantCulture, $"{path}={side}");
    }

    // A name that looks like an option.
    private static string Argument(string word) => word is ['-', ..] ? $"./{word}" : word;

    // A scene that was read for its size, and is built once, without the settings of its sides: nothing keeps it after that.
    private sealed class SizedScene(ReadScene scene, IReadOnlyList<SceneSetting> settings, int? frame)
    {
        private ReadScene? _scene = scene;

        public ReadScene? Take(RenderJob job) =>
            job.Settings == settings && job.Frame == frame ? Interlocked.Exchange(ref _scene, null) : null;
    }
}
