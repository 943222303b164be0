namespace RayTracer.Studio;

/// <summary>
/// Knows by the requests that wait for news whether any window is open, and says when none has been for long enough, and nothing is
/// being worked on that a window has started.
/// </summary>
internal sealed class WindowWatch : IDisposable
{
    private readonly Lock _lock = new();
    private readonly GraceTimes _grace;
    private readonly ITimer _timer;
    private readonly Func<bool> _isBusy;
    private int _open;
    private bool _saidFarewell;
    private bool _isOverdue;

    /// <summary>Begins to wait for the first window.</summary>
    /// <param name="grace">The times to wait.</param>
    /// <param name="time">The clock.</param>
    /// <param name="isBusy">Returns whether there is work that must not end with its window.</param>
    /// <param name="ended">Called when it has been long enough.</param>
    public WindowWatch(GraceTimes grace, TimeProvider time, Func<bool> isBusy, Action ended)
    {
        (_grace, _isBusy) = (grace, isBusy);
        _timer = time.CreateTimer(_ => End(ended), null, grace.AtStart, Timeout.InfiniteTimeSpan);
    }

    /// <summary>Counts a request that waits, until what is returned is disposed of.</summary>
    public IDisposable Enter()
    {
        lock (_lock)
        {
            _open++;
            _saidFarewell = _isOverdue = false;
            _timer.Change(Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        }

        return new Visit(this);
    }

    /// <summary>A window says that it goes.</summary>
    public void Farewell()
    {
        lock (_lock)
        {
            _saidFarewell = true;
            if (_open == 0)
            {
                _timer.Change(_grace.AfterFarewell, Timeout.InfiniteTimeSpan);
            }
        }
    }

    /// <summary>Some work has ended: if no window came back for its result, the last one was waited for long enough before.</summary>
    public void WorkChanged()
    {
        lock (_lock)
        {
            if (_isOverdue && !_isBusy())
            {
                _isOverdue = false;
                _timer.Change(_grace.WithoutWindow, Timeout.InfiniteTimeSpan);
            }
        }
    }

    /// <inheritdoc/>
    public void Dispose() => _timer.Dispose();

    private void End(Action ended)
    {
        lock (_lock)
        {
            _isOverdue = _open == 0 && _isBusy();
            if (_open > 0 || _isOverdue)
            {
                return;
            }
        }

        ended();
    }

    private void Leave()
    {
        lock (_lock)
        {
            if (--_open == 0)
            {
                _timer.Change(_saidFarewell ? _grace.AfterFarewell : _grace.WithoutWindow, Timeout.InfiniteTimeSpan);
            }
        }
    }

    private sealed class Visit(WindowWatch watch) : IDisposable
    {
        private bool _hasLeft;

        public void Dispose()
        {
            if (!Interlocked.Exchange(ref _hasLeft, true))
            {
                watch.Leave();
            }
        }
    }
}

/// <summary>The times for which the server waits for a window before it ends.</summary>
/// <param name="AtStart">For the first one.</param>
/// <param name="WithoutWindow">For another one, after the last has gone.</param>
/// <param name="AfterFarewell">For another one, after the last has said that it goes.</param>
internal sealed record GraceTimes(TimeSpan AtStart, TimeSpan WithoutWindow, TimeSpan AfterFarewell)
{
    /// <summary>The times for users.</summary>
    public static GraceTimes Default { get; } = new(TimeSpan.FromSeconds(60), TimeSpan.FromSeconds(10), TimeSpan.FromSeconds(3));
}
