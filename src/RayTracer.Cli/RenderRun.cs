using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>Renders one scene as it was asked for.</summary>
/// <param name="request">What was asked for.</param>
/// <param name="overrides">Puts the options of the command line into the scene.</param>
/// <param name="streams">Where to write.</param>
internal sealed class RenderRun(RenderRequest request, Func<SceneDescription, SceneDescription> overrides, Streams streams)
{
    private readonly Stopwatch _total = Stopwatch.StartNew();
    private readonly NoiseRequest _noise = new(request);

    /// <summary>Loads, renders, writes and reports.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public int Run()
    {
        AovOutputs aovs = new(request);
        foreach (string output in request.Outputs.Concat(aovs.Files))
        {
            ImageOutputs.Check(output);
        }

        using StopSignals signals = new(streams);
        if (SceneFile.Load(request.ScenePath, streams, s => _noise.Widen(overrides(s))) is not { } scene)
        {
            return SceneFile.FailureStatus(request.ScenePath);
        }

        RenderOptions options = Options(scene.Render);
        Film film = FilmFor(scene.Render);
        AovFilm auxiliary = new(film, request.Aovs);
        Denoising? denoising = request.Denoise ? Denoising.Create(scene) : null;
        RenderOutcome outcome = Render(scene, auxiliary, film, options, denoising, signals.Token);
        if (request.Pixel is not null)
        {
            PixelReport.Write(request, outcome, streams);
            return signals.Status;
        }

        IReadOnlyList<string> written = film.TotalSamples > 0 ? Write(outcome, aovs, auxiliary, denoising) : [];
        if (film.TotalSamples == 0 && request.Outputs.Count > 0 && signals.Status == 0)
        {
            streams.Fail("no sample came to a finite number, so there is no picture to write");
        }

        RenderReport report = new(request, outcome, written, _total.Elapsed.TotalSeconds);
        report.Write(streams);
        return signals.Status != 0 ? signals.Status
            : written.Count < request.Outputs.Count + aovs.Files.Count ? ExitStatus.InputOutput
            : _noise.IsReached(outcome.Plan) ? ExitStatus.Fine : ExitStatus.Noisy;
    }

    private RenderOutcome Render(Scene scene, AovFilm auxiliary, Film film, RenderOptions options, Denoising? denoising, CancellationToken cancellation)
    {
        using ProgressDisplay? display = request.Quiet || request.Pixel is not null ? null : ProgressDisplay.Start(streams);
        long start = Stopwatch.GetTimestamp();
        SamplePlan? plan = null;
        RenderStatistics statistics;
        try
        {
            plan = _noise.Plan(scene, options, display, cancellation);
            if (plan is not null)
            {
                options = options with { Samples = new(0, (int)double.Round((double)plan.TotalSamples / plan.Area.Pixels)) };
            }

            // First, so that they are whole even where the picture is stopped early.
            new FirstHitPass(scene, options).Render(auxiliary, cancellation);
            statistics = denoising?.Render(film, options, display, cancellation)
                ?? (request.Adaptive ? new PlannedRender(scene, options, plan!).Render(film, display, cancellation) : new RTracer(scene, options).Render(film, display, cancellation));
        }
        catch (OperationCanceledException)
        {
            // There is no picture yet.
            statistics = new() { Cancelled = true };
        }

        return new(scene, film, statistics, options.Threads, Stopwatch.GetElapsedTime(start).TotalSeconds) { Plan = plan };
    }

    private RenderOptions Options(RenderDescription render)
    {
        if (request.Pixel is { } p && (p[0] >= render.Width || p[1] >= render.Height))
        {
            throw Misplaced($"--pixel {p[0]},{p[1]}", render);
        }

        if (request.Crop is { } c && (c[2] < 1 || c[3] < 1 || c[0] > render.Width - c[2] || c[1] > render.Height - c[3]))
        {
            throw Misplaced($"--crop {string.Join(',', c)}", render);
        }

        if (request.Sample >= render.SamplesPerPixel)
        {
            throw new CommandException(ExitStatus.Usage, $"--sample {request.Sample}: the pixels have samples 0 to {render.SamplesPerPixel - 1} only");
        }

        return new()
        {
            Threads = request.Threads,
            Crop = request.Pixel is [var x, var y] ? new(x, y, 1, 1) : request.Crop is [var left, var top, var width, var height] ? new(left, top, width, height) : null,
            Samples = request.Sample is { } sample ? new((int)sample, (int)sample + 1) : null,
        };
    }

    private static CommandException Misplaced(string option, RenderDescription render) =>
        new(ExitStatus.Usage, $"{option}: does not lie within the picture of {render.Width}×{render.Height} pixels");

    private Film FilmFor(RenderDescription render)
    {
        long bytes = FilmMemory.Bytes(render.Width, render.Height) + AovFilm.Bytes(request.Aovs, render.Width, render.Height)
            + (request.Denoise ? Denoising.Bytes(render.Width, render.Height) : 0);
        long available = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        bool fits = bytes <= available && (long)render.Width * render.Height <= Film.MaxPixels;
        return fits ? new(render.Width, render.Height) : throw new CommandException(
            ExitStatus.InputOutput, $"a film of {render.Width}×{render.Height} pixels takes {FilmMemory.Text(bytes)} of memory, more than can be had ({FilmMemory.Text(available)})");
    }

    private IReadOnlyList<string> Write(RenderOutcome outcome, AovOutputs aovs, AovFilm auxiliary, Denoising? denoising)
    {
        KeyValuePair<string, string>[] texts =
        [
            new("Software", CommandLine.Version),
            new("Command", request.CommandText),
            new("Scene", Path.GetFileName(request.ScenePath)),
            new("Samples", $"{outcome.SamplesText}{(outcome.Statistics.Cancelled ? $", unfinished: {outcome.Statistics.Paths} paths" : "")}"),
            new("FilmHash", outcome.Hash),
        ];
        ImageWriteOptions writing = request.Writing with { Metadata = texts };
        Picture? denoised = denoising?.Denoise(request.Threads);
        IReadOnlyList<ExrLayerChannel> layers = [.. AovFiles.Layers(auxiliary), .. denoised is null ? [] : DenoisedFiles.Layers(denoised)];
        IReadOnlyList<string> pictures = ImageOutputs.Write(request.Outputs, outcome.Film, writing with { ExrLayers = layers }, streams);
        return [.. pictures, .. aovs.Write(auxiliary, denoised, writing, streams)];
    }
}

/// <summary>What a rendering came to.</summary>
/// <param name="Scene">What was rendered.</param>
/// <param name="Film">The picture.</param>
/// <param name="Statistics">What was done for it.</param>
/// <param name="Threads">On how many threads.</param>
/// <param name="Seconds">How long that took.</param>
internal sealed record RenderOutcome(Scene Scene, Film Film, RenderStatistics Statistics, int Threads, double Seconds)
{
    private string? _hash;

    /// <summary>The film's hash.</summary>
    public string Hash => _hash ??= Film.ComputeHash();

    /// <summary>How the numbers of samples were decided; null where they were given.</summary>
    public SamplePlan? Plan { get; init; }

    /// <summary>How many samples the pixels have.</summary>
    public string SamplesText => Plan is null ? $"{Scene.Render.SamplesPerPixel}"
        : Plan.Fewest == Plan.Most ? $"{Plan.Most}"
        : $"{Plan.Fewest} to {Plan.Most} (mean {MeanSamples:F1})";

    /// <summary>How many samples a pixel has on average.</summary>
    public double MeanSamples => Plan is null ? Scene.Render.SamplesPerPixel : (double)Plan.TotalSamples / Plan.Area.Pixels;

    /// <summary>Rays a second.</summary>
    public double RaysPerSecond => Seconds > 0 ? Statistics.Rays / Seconds : 0;
}
