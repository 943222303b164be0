using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Scenes;

namespace RayTracer.Cli.Reproduce;

/// <summary>Renders and measures what the report's section 6.3 shows, and writes pictures, chart and pages into a folder.</summary>
/// <param name="plan">How large the pictures are.</param>
/// <param name="folder">Where to; made if it is missing.</param>
/// <param name="commandText">The command, for the pictures' metadata.</param>
/// <param name="streams">Where to say how far it is.</param>
internal sealed class Reproduction(ReproductionPlan plan, string folder, string commandText, Streams streams)
{
    private const int WarmUpSamples = 16;
    private readonly OutputFolder _output = new(folder, streams);
    private readonly Dictionary<(ReportScene Scene, int Samples, int Threads), Measurement> _best = [];
    private readonly List<ReproducedScene> _scenes = [];
    private int _pictures;

    /// <summary>Does everything.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    /// <exception cref="CommandException">The folder cannot be used, or the scenes are not there.</exception>
    /// <exception cref="ImageWriteException">A file cannot be written.</exception>
    public int Run()
    {
        PrepareFolder();
        using StopSignals signals = new(streams);
        try
        {
            foreach (ReportScene scene in ReportScene.All)
            {
                string path = ScenePath(scene);
                if (!Load(scene, path))
                {
                    return SceneFile.FailureStatus(path);
                }
            }

            for (int round = 0; round < plan.Rounds; round++)
            {
                ReportScene.All.ToList().ForEach(scene => MeasureScene(scene, isFirst: round == 0, signals.Token));
            }
        }
        catch (OperationCanceledException)
        {
            streams.Warn($"stopped; {_pictures} pictures are in {folder}, the pages were not written");
            return signals.Status;
        }

        Collect();
        WritePages();
        return ExitStatus.Fine;
    }

    private void PrepareFolder()
    {
        _output.Prepare(ReproductionPage.ChartFile);
        foreach (ReportScene scene in ReportScene.All)
        {
            foreach (ReportPicture picture in scene.Pictures)
            {
                JobFiles.Check(_output[scene.PictureFile(picture)]);
            }
        }
    }

    private static string ScenePath(ReportScene scene) => ReportScenes.Find().FirstOrDefault(p => Path.GetFileName(p) == scene.File)
        ?? throw new CommandException(ExitStatus.InputOutput, $"{scene.File} is missing in {ReportScenes.Folder}");

    private bool Load(ReportScene report, string path)
    {
        SceneLoadResult loaded = SceneFile.Load(path);
        SceneFile.Show(loaded, streams);
        if (loaded.Scene is null)
        {
            return false;
        }

        SceneDescription description = loaded.Description!;
        _scenes.Add(new(report, description.Shapes.Count, description.Lights.Count, description.Render.Width, description.Render.Height));
        return true;
    }

    private void MeasureScene(ReportScene report, bool isFirst, CancellationToken cancellation)
    {
        if (isFirst)
        {
            // The first rendering also compiles the program; its time does not count.
            Measure(report, WarmUpSamples, Environment.ProcessorCount, null, cancellation);
            _best.Remove((report, WarmUpSamples, Environment.ProcessorCount));
        }

        foreach (ReportPicture picture in report.Pictures)
        {
            int samples = plan.Samples(picture);
            string file = report.PictureFile(picture);
            Measure(report, samples, Environment.ProcessorCount, isFirst ? file : null, cancellation);
            Measure(report, samples, 1, null, cancellation);
            streams.Output.WriteLine($"{file}: {plan.Size(report)}×{plan.Size(report)} pixels, {samples} samples each, best time {All(report, samples).Seconds:F3} s");
        }

        foreach (int samples in plan.ChartSamples.Except(report.Pictures.Select(plan.Samples)))
        {
            Measure(report, samples, Environment.ProcessorCount, null, cancellation);
        }
    }

    private Measurement All(ReportScene report, int samples) => _best[(report, samples, Environment.ProcessorCount)];

    private void Collect()
    {
        foreach (ReproducedScene scene in _scenes)
        {
            foreach (ReportPicture picture in scene.Scene.Pictures)
            {
                int samples = plan.Samples(picture);
                scene.Pictures.Add(new(scene.Scene, picture, All(scene.Scene, samples), _best[(scene.Scene, samples, 1)]));
            }

            scene.Growth.AddRange(plan.ChartSamples.Select(samples => All(scene.Scene, samples)));
        }
    }

    private void Measure(ReportScene report, int samples, int threads, string? file, CancellationToken cancellation)
    {
        int size = plan.Size(report);
        string path = ScenePath(report);
        Scene scene = SceneFile.Load(path, s => s with
        {
            Render = s.Render with { Width = size, Height = size, SamplesPerPixel = samples, Sampler = SamplerKind.Jittered },
        }).Scene ?? throw new CommandException(ExitStatus.InputOutput, $"{path} has changed and cannot be read any more");
        (Film film, RenderStatistics statistics, double seconds) = Render(scene, new(scene, new() { Threads = threads }), cancellation);
        if (file is not null)
        {
            WritePicture(file, film, samples);
            RenderReport.WarnOfClamped(statistics, streams);
        }

        if (!_best.TryGetValue((report, samples, threads), out Measurement? best) || seconds < best.Seconds)
        {
            _best[(report, samples, threads)] = new(report, size, samples, threads, seconds, statistics.Rays);
        }
    }

    private (Film Film, RenderStatistics Statistics, double Seconds) Render(Scene scene, RTracer tracer, CancellationToken cancellation)
    {
        Film film = new(scene.Render.Width, scene.Render.Height);
        using ProgressDisplay? display = streams.HasTerminal ? ProgressDisplay.Start(streams) : null;
        long start = Stopwatch.GetTimestamp();
        RenderStatistics statistics = tracer.Render(film, display, cancellation);
        double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        cancellation.ThrowIfCancellationRequested();
        return (film, statistics, seconds);
    }

    private void WritePicture(string file, Film film, int samples)
    {
        KeyValuePair<string, string>[] texts =
        [
            new("Software", CommandLine.Version),
            new("Command", commandText),
            new("Samples", $"{samples}"),
            new("FilmHash", film.ComputeHash()),
        ];
        ImageFile.Write(_output[file], film, new() { Metadata = texts });
        _pictures++;
    }

    private void WritePages()
    {
        _output.Write(ReproductionPage.ChartFile, GrowthChart.Draw(_scenes));
        ReproductionPage page = new(plan, _scenes);
        _output.WritePages(ReproductionPage.Title, page.Write);
    }
}
