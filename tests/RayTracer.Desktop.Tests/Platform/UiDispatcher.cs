using Avalonia.Threading;

namespace RayTracer.Desktop.Tests;

/// <summary>Wakes the thread of the window when there is something to do.</summary>
internal sealed class UiDispatcher(Thread thread) : IDispatcherImpl, IDisposable
{
    private readonly AutoResetEvent _work = new(false);

    // Nobody listens: the thread looks for its work itself, and nothing here depends on timers.
    public event Action? Signaled
    {
        add { }
        remove { }
    }

    public event Action? Timer
    {
        add { }
        remove { }
    }

    public bool CurrentThreadIsLoopThread => Thread.CurrentThread == thread;

    public long Now => Environment.TickCount64;

    public void Signal() => _work.Set();

    public void UpdateTimer(long? dueTimeInMs)
    {
    }

    /// <summary>Waits until there is something to do, or a moment has gone by.</summary>
    public void Wait() => _work.WaitOne(TimeSpan.FromMilliseconds(10));

    public void Dispose() => _work.Dispose();
}
