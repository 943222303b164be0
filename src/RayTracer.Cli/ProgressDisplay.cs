using System.Diagnostics;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>
/// Shows from its own thread how far a rendering is; the rendering threads only leave a number here. Ends when disposed of.
/// </summary>
internal abstract class ProgressDisplay : IProgress<RenderProgress>, IDisposable
{
    private readonly Lock _lock = new();
    private readonly Stopwatch _watch = Stopwatch.StartNew();
    private readonly ManualResetEventSlim _ended = new();
    private readonly Thread _thread;
    private RenderProgress _latest;

    private protected ProgressDisplay() => _thread = new(Show) { IsBackground = true };

    /// <summary>The time at which the rendering ends at the latest; null for none.</summary>
    public TimeSpan? Limit { get; init; }

    /// <summary>The progress of the rendering, 0 to 1; 0 where it is not known.</summary>
    private protected double Fraction => double.Clamp(double.Max(Known(Latest), _watch.Elapsed / Limit ?? 0), 0, 1);

    /// <summary>The speed of the rendering, and the time until the last sample or the limit, whichever comes first; without it where it is not known.</summary>
    private protected string Pace
    {
        get
        {
            RenderProgress latest = Latest;
            double seconds = _watch.Elapsed.TotalSeconds;
            double last = Known(latest) is > 0 and var fraction ? seconds * (1 - fraction) / fraction : double.PositiveInfinity;
            double left = double.Min(last, Limit is { } limit ? double.Max(0, limit.TotalSeconds - seconds) : double.PositiveInfinity);
            string speed = latest.Rays > 0 ? $", {latest.Rays / seconds / 1e6:F1} M rays/s" : "";
            return double.IsFinite(left) ? $"{speed}, {Duration(left)} left" : speed;
        }
    }

    private RenderProgress Latest
    {
        get
        {
            lock (_lock)
            {
                return _latest;
            }
        }
    }

    /// <summary>Begins to show progress: as a bar on a terminal, else in lines.</summary>
    public static ProgressDisplay Start(Streams streams, TimeSpan? limit = null) =>
        Start(streams.HasTerminal ? new ProgressBar(streams.Error) { Limit = limit } : new ProgressLines(streams.Error) { Limit = limit });

    /// <summary>Begins to show progress in another way.</summary>
    public static ProgressDisplay Start(ProgressDisplay display)
    {
        display._thread.Start();
        return display;
    }

    /// <inheritdoc/>
    public void Report(RenderProgress value)
    {
        lock (_lock)
        {
            // What the samples that decide foretell changes.
            if (value.PathsDone > _latest.PathsDone || value.PathsTotal != _latest.PathsTotal)
            {
                _latest = value;
            }
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (_thread.IsAlive)
        {
            _ended.Set();
            _thread.Join();
            _ended.Dispose();
        }
    }

    /// <summary>Shows progress until <see cref="Wait"/> says that the rendering has ended.</summary>
    private protected abstract void Show();

    /// <summary>Waits; true if the rendering has ended.</summary>
    private protected bool Wait(int milliseconds) => _ended.Wait(milliseconds);

    private static double Known(RenderProgress progress) => progress.PathsTotal > 0 ? progress.Fraction : 0;

    private static string Duration(double seconds) =>
        seconds < 60 ? $"{seconds:F0} s" : seconds < 3600 ? $"{seconds / 60:F0} min" : $"{seconds / 3600:F1} h";
}
