namespace RayTracer.Session.Tests;

/// <summary>A clock whose timers go off when a test says so.</summary>
internal sealed class FakeTime : TimeProvider
{
    private readonly List<FakeTimer> _timers = [];

    /// <summary>Lets all timers go off that have been set.</summary>
    public void Ring()
    {
        foreach (FakeTimer timer in _timers.Where(t => t.IsSet).ToArray())
        {
            timer.IsSet = false;
            timer.Ring();
        }
    }

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
    {
        FakeTimer timer = new(() => callback(state));
        _timers.Add(timer);
        return timer;
    }

    private sealed class FakeTimer(Action ring) : ITimer
    {
        public bool IsSet { get; set; }

        public void Ring() => ring();

        public bool Change(TimeSpan dueTime, TimeSpan period)
        {
            IsSet = dueTime != Timeout.InfiniteTimeSpan;
            return true;
        }

        public void Dispose() => IsSet = false;

        public ValueTask DisposeAsync() => ValueTask.CompletedTask;
    }
}
