using System.Diagnostics;
using System.Globalization;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Names of gestures: all edits of one are one step to undo.</summary>
internal sealed class Gesture
{
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);
    private static int _count;
    private string _name = "";
    private long _last;

    /// <summary>A new one.</summary>
    public static string New() => string.Create(CultureInfo.InvariantCulture, $"desktop-{Interlocked.Increment(ref _count)}");

    /// <summary>The name for a change that has no natural end, such as a turn of the wheel: the same until there is a pause.</summary>
    public string Burst()
    {
        if (_name.Length == 0 || Stopwatch.GetElapsedTime(_last) > Pause)
        {
            _name = New();
        }

        _last = Stopwatch.GetTimestamp();
        return _name;
    }
}
