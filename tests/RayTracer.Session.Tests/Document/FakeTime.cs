namespace RayTracer.Session.Tests;

/// <summary>A clock whose timers go off when a test says so.</summary>
internal sealed class FakeTime : TimeProvider
{
    private readonly List<FakeTimer> _timers = [];
    private TimeSpan _now;

    /// <summary>Lets time go by, and those timers go off that are due by then.</summary>
    public void Pass(TimeSpan time)
    {
        _now += time;
        foreach (FakeTimer timer in _timers.Where(t => t.IsSet && t.Due <= _now).ToArray())
        {
            timer.GoOff();
        }
    }

    /// <summary>Lets all timers go off that have been set.</summary>
    public void Ring()
    {
        foreach (FakeTimer timer in _timers.Where(t => t.IsSet).ToArray())
        {
            timer.GoOff();
        }
    }

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
    {
        FakeTimer timer = new(this, () => callback(state));
        timer.Change(dueTime, period);
        _timers.Add(timer);
        return timer;
    }

    private sealed class FakeTimer(FakeTime time, Action ring) : ITimer
    {
        private TimeSpan _period;

        public bool IsSet { get; private set; }

        public TimeSpan Due { get; private set; }

        public void GoOff()
        {
            Change(_period, _period);
            ring();
        }

        public bool Change(TimeSpan dueTime, TimeSpan period)
        {
            (IsSet, Due, _period) = (dueTime != Timeout.InfiniteTimeSpan, time._now + dueTime, period);
            return true;
        }

        public void Dispose() => IsSet = false;

        public ValueTask DisposeAsync() => ValueTask.CompletedTask;
    }
}
