using System.Diagnostics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Study;

namespace RayTracer.Session;

/// <summary>The report's own times beside this machine's: measured once, with a few samples, when they are first asked for.</summary>
/// <param name="folder">The folder of the scenes that come with the program; null where there is none.</param>
public sealed class ReportTimes(string? folder) : ISessionPart<ReportTimes>, IDisposable
{
    private const int MeasuredSamples = 4;
    private readonly Lock _lock = new();
    private readonly CancellationTokenSource _end = new();
    private Task<ReportTime[]>? _measured;

    /// <summary>On how many threads is measured.</summary>
    public static int Threads => Environment.ProcessorCount;

    /// <inheritdoc/>
    public static ReportTimes Of(StudioSession session) => new(session.Scenes);

    /// <summary>Measures, if that has not been done yet.</summary>
    /// <exception cref="SessionException">The report's scenes are not there.</exception>
    /// <exception cref="OperationCanceledException">The session ends.</exception>
    public Task<ReportTime[]> Measure()
    {
        lock (_lock)
        {
            return _measured = _measured is null or { IsFaulted: true } ? Task.Run(() => ReportScene.All.SelectMany(Of).ToArray(), _end.Token)
                : _measured;
        }
    }

    /// <summary>Ends measuring, and waits until nothing is rendered any more.</summary>
    public void Dispose()
    {
        _end.Cancel();
        if (_lock.Read(() => _measured) is { } measured)
        {
            Task.WaitAny(measured);
        }
    }

    private IEnumerable<ReportTime> Of(ReportScene report)
    {
        string path = Path.Combine(folder ?? "", "report", report.File);
        SceneLoadResult loaded = SceneLoader.Load(
            path, s => s with { Render = s.Render with { Width = report.Size, Height = report.Size, SamplesPerPixel = MeasuredSamples } });
        Scene scene = loaded.Scene ?? throw new SessionException($"The report's scene '{path}' cannot be loaded.", SessionFault.Missing);
        long start = Stopwatch.GetTimestamp();
        RenderStatistics statistics = new RTracer(scene, new() { Threads = Threads }).Render(new Film(report.Size, report.Size), cancellation: _end.Token);
        _end.Token.ThrowIfCancellationRequested();
        double perPath = Stopwatch.GetElapsedTime(start).TotalSeconds / statistics.Paths;
        return report.Pictures.Select(p => new ReportTime(
            report.Number, $"{report.Figure} {p.Letter}", report.Size, p.SamplesPerPixel, p.Seconds, perPath * report.Paths(p)));
    }
}

/// <summary>A time of the report beside this machine's.</summary>
/// <param name="Scene">Number of the scene.</param>
/// <param name="Figure">The figure that shows it, and the picture's letter in it.</param>
/// <param name="Width">Width and height in pixels.</param>
/// <param name="Samples">Samples in each pixel.</param>
/// <param name="ReportSeconds">The time on the report's machine, in seconds.</param>
/// <param name="Seconds">The time on this one, in seconds: measured with fewer samples, and multiplied.</param>
public sealed record ReportTime(int Scene, string Figure, int Width, int Samples, double ReportSeconds, double Seconds)
{
    /// <summary>The speed of this machine as a multiple.</summary>
    public double Factor => ReportSeconds / Seconds;
}
