using System.Diagnostics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>
/// Renders the newest scene on separate threads. The caller never waits: what is being rendered for an older picture ends by
/// itself after a few milliseconds, but its first preview, which is always made and shown.
/// </summary>
public sealed class RenderLoop : IDisposable
{
    private static readonly TimeSpan StatusEvery = TimeSpan.FromMilliseconds(100);
    private readonly object _gate = new();
    private readonly Queue<Action> _visits = new();
    private readonly FrameBoard _frames;
    private readonly FilmWork _work;
    private readonly Thread _thread;
    private CancellationTokenSource _interrupt = new();
    private ViewportScene? _wanted;
    private RenderStatus _status = new();
    private long _failed = -1;
    private long _statusAt;
    private bool _isDisposed;

    /// <summary>Starts the loop; it waits for a scene.</summary>
    /// <param name="frames">The place where frames hang.</param>
    public RenderLoop(FrameBoard frames)
    {
        _frames = frames;
        _work = new(frames);
        frames.Wanted += Wake;
        _thread = new(Run) { IsBackground = true, Name = "render" };
        _thread.Start();
    }

    /// <summary>Raised after <see cref="Status"/> has changed, by the loop's thread.</summary>
    public event Action? StatusChanged;

    /// <summary>Raised when a picture cannot be rendered, with a sentence that says why.</summary>
    public event Action<string>? Failed;

    /// <summary>The progress of the newest picture.</summary>
    public RenderStatus Status => Volatile.Read(ref _status);

    /// <summary>Renders something from now on, instead of all before.</summary>
    /// <param name="wanted">The scene; null for nothing.</param>
    public void Show(ViewportScene? wanted)
    {
        lock (_gate)
        {
            bool isOther = wanted?.Picture != _wanted?.Picture;
            _wanted = wanted;
            if (isOther)
            {
                _interrupt.Cancel();
                _interrupt = new();
            }

            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>
    /// Has the loop's thread look at the picture between two steps, when it is of one scene: at once, or after a part of a second.
    /// </summary>
    /// <param name="read">Reads the film, its scene and its number of samples; should not take long.</param>
    /// <exception cref="SessionException">There is no picture.</exception>
    public Task<T> ReadFilm<T>(Func<Film, ViewportScene, int, T> read)
    {
        TaskCompletionSource<T> done = new(TaskCreationOptions.RunContinuationsAsynchronously);
        lock (_gate)
        {
            _visits.Enqueue(() => Visit(read, done));
            Monitor.PulseAll(_gate);
        }

        return done.Task;
    }

    /// <summary>
    /// The samples that some pixels of the film have and others lack, to be read within <see cref="ReadFilm{T}"/>; null where all have the
    /// same samples.
    /// </summary>
    internal Slice? Rest => _work.Rest;

    /// <summary>The error of the picture against its samples.</summary>
    public Task<Convergence> Convergence() => ReadFilm((film, wanted, samples) => _work.Log.Errors(film, wanted.Area, samples));

    /// <summary>The numbers of some pixels, as they are shown, row by row.</summary>
    /// <param name="part">The pixels.</param>
    /// <exception cref="SessionException">There are no such pixels, or too many of them, or no picture yet.</exception>
    public Task<IReadOnlyList<PixelReading>> Pixels(Tile part) => ReadFilm((_, shown, _) => _work.Readings(shown, part));

    /// <inheritdoc/>
    public void Dispose()
    {
        lock (_gate)
        {
            _isDisposed = true;
            _interrupt.Cancel();
            Monitor.PulseAll(_gate);
        }

        _thread.Join();
        _frames.Wanted -= Wake;
        while (_visits.TryDequeue(out Action? visit))
        {
            visit();
        }
    }

    private void Wake()
    {
        lock (_gate)
        {
            Monitor.PulseAll(_gate);
        }
    }

    private void Run()
    {
        while (Next(out Action? visit, out ViewportScene? wanted, out CancellationToken interrupt))
        {
            if (visit is not null)
            {
                visit();
            }
            else if (wanted is null)
            {
                Report(new(), isNews: true);
            }
            else
            {
                Step(wanted, interrupt);
            }
        }
    }

    // Waits for something to do; false at the end.
    private bool Next(out Action? visit, out ViewportScene? wanted, out CancellationToken interrupt)
    {
        lock (_gate)
        {
            while (!_isDisposed && _visits.Count == 0 && !HasWork())
            {
                Monitor.Wait(_gate);
            }

            _visits.TryDequeue(out visit);
            wanted = _wanted;
            interrupt = _interrupt.Token;
            return !_isDisposed;
        }
    }

    private bool HasWork() => _wanted is null
        ? _status.Status != "idle"
        : _wanted.Picture != _failed && (_work.HasWork(_wanted) || _work.Status(_wanted).Status != _status.Status);

    private void Step(ViewportScene wanted, CancellationToken interrupt)
    {
        try
        {
            bool isUrgent = _work.IsUrgent(wanted);
            if (_work.HasWork(wanted))
            {
                _work.Step(wanted, interrupt);
            }

            RenderStatus status = _work.Status(wanted);
            Report(status, isUrgent || status.Status != _status.Status || Stopwatch.GetElapsedTime(_statusAt) >= StatusEvery);
        }
        catch (Exception e) when (e is not StackOverflowException)
        {
            _failed = wanted.Picture;
            Report(_work.Status(wanted) with { Status = "stopped" }, isNews: true);
            Failed?.Invoke((e.InnerException ?? e).Message);
        }
    }

    private void Report(RenderStatus status, bool isNews)
    {
        Volatile.Write(ref _status, status);
        if (isNews)
        {
            _statusAt = Stopwatch.GetTimestamp();
            StatusChanged?.Invoke();
        }
    }

    private void Visit<T>(Func<Film, ViewportScene, int, T> read, TaskCompletionSource<T> done)
    {
        try
        {
            if (_isDisposed || _work is not { Film: { } film, Shown: { } wanted })
            {
                throw new SessionException("There is no picture yet.", SessionFault.Missing);
            }

            done.SetResult(read(film, wanted, _work.Samples));
        }
        catch (Exception e)
        {
            done.SetException(e);
        }
    }
}
