using System.Diagnostics;

namespace RayTracer.Session;

/// <summary>Keeps what frames cost the renderer to a small share of its time.</summary>
public sealed class PublishPace
{
    // One part in so many of the time.
    private const int Share = 12;
    private long _last = -1;
    private TimeSpan _cost;

    /// <summary>Returns whether it is time for a frame.</summary>
    public bool IsTime => _last < 0 || Stopwatch.GetElapsedTime(_last) >= _cost * (Share - 1);

    /// <summary>Makes a frame, and takes down what that costs.</summary>
    public void Make(Action frame)
    {
        long start = Stopwatch.GetTimestamp();
        frame();
        _last = Stopwatch.GetTimestamp();
        _cost = Stopwatch.GetElapsedTime(start, _last);
    }
}
