using System.Diagnostics;
using System.Text;
using System.Xml.Linq;
using RayTracer.Description;
using RayTracer.Imaging;
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
                if (!RunScene(scene, path, signals.Token))
                {
                    return SceneFile.FailureStatus(path);
                }
            }
        }
        catch (OperationCanceledException)
        {
            streams.Warn($"stopped; {_pictures} pictures are in {folder}, the pages were not written");
            return signals.Status;
        }

        WritePages();
        return ExitStatus.Fine;
    }

    private void PrepareFolder()
    {
        if (File.Exists(folder))
        {
            throw new CommandException(ExitStatus.InputOutput, $"{folder} is a file, but a folder is expected");
        }

        try
        {
            Directory.CreateDirectory(folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new CommandException(ExitStatus.InputOutput, $"the folder {folder} cannot be made: {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}");
        }

        foreach (ReportScene scene in ReportScene.All)
        {
            foreach (ReportPicture picture in scene.Pictures)
            {
                ImageOutputs.Check(InFolder(scene.PictureFile(picture)));
            }
        }

        Array.ForEach(["index.md", "index.html", ReproductionPage.ChartFile], name => AtomicFile.Check(InFolder(name)));
    }

    private static string ScenePath(ReportScene scene) => ReportScenes.Find().FirstOrDefault(p => Path.GetFileName(p) == scene.File)
        ?? throw new CommandException(ExitStatus.InputOutput, $"{scene.File} is missing in {ReportScenes.Folder}");

    private bool RunScene(ReportScene report, string path, CancellationToken cancellation)
    {
        SceneLoadResult loaded = SceneFile.Load(path);
        SceneFile.Show(loaded, streams);
        if (loaded.Scene is null)
        {
            return false;
        }

        SceneDescription description = loaded.Description!;
        ReproducedScene scene = new(report, description.Shapes.Count, description.Lights.Count, description.Render.Width, description.Render.Height);
        _scenes.Add(scene);

        // The first rendering also compiles the program; its time is not kept.
        Measure(report, path, WarmUpSamples, Environment.ProcessorCount, null, cancellation);
        foreach (ReportPicture picture in report.Pictures)
        {
            int samples = plan.Samples(picture);
            string file = report.PictureFile(picture);
            Measurement all = Measure(report, path, samples, Environment.ProcessorCount, file, cancellation);
            Measurement one = Measure(report, path, samples, 1, null, cancellation);
            scene.Pictures.Add(new(report, picture, all, one));
            streams.Output.WriteLine($"{file}: {all.Size}×{all.Size} pixels, {samples} samples each, {all.Seconds:F3} s ({one.Seconds:F3} s with one thread)");
        }

        foreach (int samples in plan.ChartSamples)
        {
            scene.Growth.Add(Measure(report, path, samples, Environment.ProcessorCount, null, cancellation));
        }

        return true;
    }

    private Measurement Measure(ReportScene report, string path, int samples, int threads, string? file, CancellationToken cancellation)
    {
        int size = plan.Size(report);
        Scene scene = SceneFile.Load(path, s => s with
        {
            Render = s.Render with { Width = size, Height = size, SamplesPerPixel = samples, Sampler = SamplerKind.Jittered },
        }).Scene ?? throw new CommandException(ExitStatus.InputOutput, $"{path} has changed and cannot be read any more");
        RTracer tracer = new(scene, new() { Threads = threads });
        (Film film, RenderStatistics statistics, double seconds) = Render(scene, tracer, cancellation);
        if (file is not null)
        {
            WritePicture(file, film, samples);
            RenderReport.WarnOfClamped(statistics, streams);
        }

        double best = seconds;
        double total = seconds;
        for (int run = 1; run < ReproductionPlan.MaxRepeats && total < plan.RepeatSeconds; run++)
        {
            (_, _, seconds) = Render(scene, tracer, cancellation);
            best = Math.Min(best, seconds);
            total += seconds;
        }

        return new(report, size, samples, threads, best, statistics.Rays);
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
        ImageFile.Write(InFolder(file), film, new() { Metadata = texts });
        _pictures++;
    }

    private void WritePages()
    {
        XDocument chart = GrowthChart.Draw(_scenes);
        AtomicFile.Write(InFolder(ReproductionPage.ChartFile), stream => chart.Save(stream));
        ReproductionPage page = new(plan, _scenes);
        WritePage(page, new MarkdownPage(ReproductionPage.Title), "index.md");
        WritePage(page, new HtmlPage(ReproductionPage.Title), "index.html");
    }

    private void WritePage(ReproductionPage page, PageWriter writer, string name)
    {
        page.Write(writer);
        AtomicFile.Write(InFolder(name), stream => stream.Write(Encoding.UTF8.GetBytes(writer.Finish())));
        streams.Output.WriteLine($"wrote {InFolder(name)}");
    }

    private string InFolder(string name) => Path.Combine(folder, name);
}
