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

    /// <summary>The progress of the rendering, 0 to 1.</summary>
    private protected double Fraction => Latest is { PathsTotal: > 0 } latest ? latest.Fraction : 0;

    /// <summary>The speed of the rendering, and the time that it will take.</summary>
    private protected string Pace
    {
        get
        {
            RenderProgress latest = Latest;
            double seconds = _watch.Elapsed.TotalSeconds;
            string left = latest.PathsDone == 0 ? "?" : Duration(seconds * (1 - latest.Fraction) / latest.Fraction);
            return latest.Rays > 0 ? $"{latest.Rays / seconds / 1e6:F1} M rays/s, {left} left" : $"{left} left";
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
    public static ProgressDisplay Start(Streams streams) =>
        Start(streams.HasTerminal ? new ProgressBar(streams.Error) : new ProgressLines(streams.Error));

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
            if (value.PathsDone > _latest.PathsDone)
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

    private static string Duration(double seconds) =>
        seconds < 60 ? $"{seconds:F0} s" : seconds < 3600 ? $"{seconds / 60:F0} min" : $"{seconds / 3600:F1} h";
}
