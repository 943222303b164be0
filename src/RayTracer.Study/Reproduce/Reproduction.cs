using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Scenes;

namespace RayTracer.Study;

/// <summary>Renders and measures what the report's section 6.3 shows, and writes pictures, chart and pages into a folder.</summary>
/// <param name="plan">The sizes of pictures.</param>
/// <param name="folder">The folder to write to; made if it is missing.</param>
/// <param name="output">Takes each result.</param>
/// <param name="watch">Takes what the renderings report.</param>
internal sealed class Reproduction(ReproductionPlan plan, string folder, TextWriter output, IJobWatch watch)
{
    private const int WarmUpSamples = 16;
    private const int ShortRounds = 8;
    private const double ShortSeconds = 0.3;
    private static readonly (int Width, int Height)[] s_frames = [(100, 100), (800, 600)];
    private readonly Machine _machine = Machine.Now();
    private readonly OutputFolder _files = new(folder, output);
    private readonly Dictionary<(ReportScene Scene, int Samples, int Threads), Measurement> _best = [];
    private readonly List<ReproducedScene> _scenes = [];

    /// <summary>Does everything.</summary>
    /// <exception cref="JobException">The folder cannot be used, or the scenes are not there.</exception>
    /// <exception cref="ImageWriteException">A file cannot be written.</exception>
    /// <exception cref="OperationCanceledException">It was stopped: pictures may be there, but no pages.</exception>
    public void Run(CancellationToken cancellation)
    {
        PrepareFolder();
        _scenes.AddRange(ReportScene.All.Select(Read));
        for (int round = 0; round < plan.Rounds; round++)
        {
            _scenes.ForEach(scene => MeasureScene(scene.Scene, isFirst: round == 0, cancellation));
        }

        _scenes.ForEach(Collect);
        _scenes.ForEach(scene => scene.Frames.AddRange(s_frames.Select(size => MeasureFrames(scene.Scene, size.Width, size.Height, cancellation))));
        _files.Write(ReproductionPage.ChartFile, GrowthChart.Draw(_scenes));
        _files.WritePages(ReproductionPage.Title, new ReproductionPage(plan, _scenes, _machine).Write);
    }

    private void PrepareFolder()
    {
        _files.Prepare(ReproductionPage.ChartFile);
        foreach (string picture in ReportScene.All.SelectMany(s => s.Pictures.Select(s.PictureFile)))
        {
            JobFiles.Check(_files[picture]);
        }
    }

    private ReproducedScene Read(ReportScene report)
    {
        SceneLoadResult loaded = new RenderJob { Scene = ReportScenes.PathOf(report) }.Load();
        watch.Read(loaded.Diagnostics);
        return loaded is { Scene: not null, Description: { } scene }
            ? new(report, scene.Shapes.Count, scene.Lights.Count, scene.Render.Width, scene.Render.Height)
            : throw new JobException($"{ReportScenes.PathOf(report)} has errors");
    }

    private void MeasureScene(ReportScene report, bool isFirst, CancellationToken cancellation)
    {
        int threads = Environment.ProcessorCount;
        if (isFirst)
        {
            // The first rendering also compiles the program; its time does not count.
            Measure(report, WarmUpSamples, threads, null, cancellation);
            _best.Remove((report, WarmUpSamples, threads));
        }

        foreach (ReportPicture picture in report.Pictures)
        {
            int samples = plan.Samples(picture);
            string file = report.PictureFile(picture);
            Measure(report, samples, threads, isFirst ? file : null, cancellation);
            Measure(report, samples, 1, null, cancellation);

            // Of what is short, anything else that the machine does is a large share: the best of several counts.
            for (int i = 1; i < ShortRounds && All(report, samples).Seconds < ShortSeconds; i++)
            {
                Measure(report, samples, threads, null, cancellation);
                Measure(report, samples, 1, null, cancellation);
            }

            double seconds = All(report, samples).Seconds;
            output.WriteLine($"{file}: {plan.Size(report)}×{plan.Size(report)} pixels, {samples} samples each, best time {seconds:F3} s");
        }

        foreach (int samples in plan.ChartSamples.Except(report.Pictures.Select(plan.Samples)))
        {
            Measure(report, samples, threads, null, cancellation);
        }
    }

    private Measurement All(ReportScene report, int samples) => _best[(report, samples, Environment.ProcessorCount)];

    private void Collect(ReproducedScene scene)
    {
        foreach (ReportPicture picture in scene.Scene.Pictures)
        {
            int samples = plan.Samples(picture);
            scene.Pictures.Add(new(scene.Scene, picture, All(scene.Scene, samples), _best[(scene.Scene, samples, 1)]));
        }

        scene.Growth.AddRange(plan.ChartSamples.Select(samples => All(scene.Scene, samples)));
    }

    private FrameRate MeasureFrames(ReportScene report, int width, int height, CancellationToken cancellation)
    {
        Scene scene = new RenderJob { Scene = ReportScenes.PathOf(report) }
            .With([$"render.width={width}", $"render.height={height}", "render.samplesPerPixel=1", "render.sampler=jittered"]).Load().Scene!;

        // The first time, the compiler takes part of the processors; it does not count.
        FramesPerSecond(scene, Environment.ProcessorCount, cancellation);
        (double all, double rays) = FramesPerSecond(scene, Environment.ProcessorCount, cancellation);
        (double one, _) = FramesPerSecond(scene, 1, cancellation);
        output.WriteLine($"scene {report.Number}, {width}×{height} pixels: {all:F1} pictures a second");
        return new(report, width, height, all, one, rays);
    }

    private (double Frames, double Rays) FramesPerSecond(Scene scene, int threads, CancellationToken cancellation)
    {
        int frames = 0;
        long rays = 0;
        long start = Stopwatch.GetTimestamp();
        double seconds;
        do
        {
            rays += new RTracer(scene, new() { Threads = threads }).Render(null, cancellation).Statistics.Rays;
            cancellation.ThrowIfCancellationRequested();
            frames++;
            seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        }
        while (seconds < plan.FrameSeconds);

        return (frames / seconds, rays / seconds);
    }

    private void Measure(ReportScene report, int samples, int threads, string? file, CancellationToken cancellation)
    {
        int size = plan.Size(report);
        RenderJob job = new RenderJob
        {
            Scene = ReportScenes.PathOf(report),
            Threads = threads,
            Outputs = file is null ? [] : [_files[file]],
            IsOfSequence = true,
        }.With([$"render.width={size}", $"render.height={size}", $"render.samplesPerPixel={samples}", "render.sampler=jittered"]);
        JobResult result = new JobRun(job, watch)
            .Run(cancellation) ?? throw new JobException($"{job.Scene} has changed and cannot be read any more");
        if (result.Statistics.Cancelled)
        {
            throw new OperationCanceledException(cancellation);
        }

        if (!result.IsWritten)
        {
            throw new ImageWriteException($"The pictures cannot be written to '{folder}'.");
        }

        if (file is not null)
        {
            result.WarnOfClamped(watch);
        }

        Measurement measured = new(report, size, samples, threads, result.Seconds, result.Statistics.Rays);
        _best[(report, samples, threads)] = _best.TryGetValue((report, samples, threads), out Measurement? best)
            && best.Seconds <= measured.Seconds ? best : measured;
    }
}
