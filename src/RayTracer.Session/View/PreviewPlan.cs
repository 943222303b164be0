namespace RayTracer.Session;

/// <summary>
/// The coarse pictures that are seen first: one that is made at once and always to its end, then finer ones. How coarse the first one is
/// depends on how long the last ones took.
/// </summary>
public sealed class PreviewPlan
{
    private const double FirstSeconds = 0.012;
    private const double QuickPassSeconds = 0.3;
    private const int Finest = 2;
    private const int Usual = 8;
    private const int Coarsest = 64;
    private double _secondsPerPixel;
    private int _scale;

    /// <summary>Starts again, with the first one.</summary>
    /// <param name="pixels">Number of pixels of the whole picture.</param>
    public void Begin(long pixels)
    {
        IsFirst = true;
        _scale = Finest;
        while (_scale < Coarsest && (_secondsPerPixel > 0 ? pixels / ((double)_scale * _scale) * _secondsPerPixel > FirstSeconds : _scale < Usual))
        {
            _scale *= 2;
        }
    }

    /// <summary>Returns whether the next one is the first, which must be completed.</summary>
    public bool IsFirst { get; private set; }

    /// <summary>The number of pixels across and down that become one in the next one; 1 where none remains.</summary>
    public int Scale => _scale;

    /// <summary>The next one has been made.</summary>
    /// <param name="pixels">Its number of pixels.</param>
    /// <param name="seconds">The time that it took.</param>
    /// <param name="allPixels">Number of pixels of the whole picture.</param>
    public void Add(long pixels, double seconds, long allPixels)
    {
        // Slowly, for a moment's load of the machine says little.
        double now = seconds / pixels;
        _secondsPerPixel = _secondsPerPixel > 0 ? (0.75 * _secondsPerPixel) + (0.25 * now) : now;
        IsFirst = false;
        _scale /= 2;
        if (_scale < Finest || (_scale == Finest && allPixels * _secondsPerPixel < QuickPassSeconds))
        {
            _scale = 1;
        }
    }

    /// <summary>No more of them.</summary>
    public void End() => (IsFirst, _scale) = (false, 1);
}
