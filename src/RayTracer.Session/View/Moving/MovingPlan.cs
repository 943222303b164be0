using System.Diagnostics;

namespace RayTracer.Session;

/// <summary>
/// How many filtered pictures are made of one view: the first always to its end, then some more, so that it is calm when the film takes over; and how that
/// takes over, on the screen alone.
/// </summary>
internal sealed class MovingPlan
{
    private const int Most = 6;

    // Of the film's samples, a filtered picture is worth so many at first, and nothing when there are that many more.
    private const float Worth = 16;
    private const int Gone = 64;
    private static readonly TimeSpan s_longest = TimeSpan.FromMilliseconds(80);
    private long _began;
    private int _left;

    /// <summary>Returns whether there is another one to be made.</summary>
    public bool HasNext => _left > 0;

    /// <summary>Returns whether the next one is the first, which must be completed.</summary>
    public bool IsFirst => _left == Most;

    /// <summary>Returns whether there is one of this view.</summary>
    public bool HasMade { get; private set; }

    /// <summary>A view has changed.</summary>
    public void Begin() => (_left, _began, HasMade) = (Most, Stopwatch.GetTimestamp(), false);

    /// <summary>One has been made.</summary>
    public void Add()
    {
        _left = Stopwatch.GetElapsedTime(_began) < s_longest ? _left - 1 : 0;
        HasMade = true;
    }

    /// <summary>No more of them.</summary>
    public void End() => (_left, HasMade) = (0, false);

    /// <summary>The share of the last one in what is shown of a film.</summary>
    /// <param name="samples">The film's samples in each pixel.</param>
    /// <param name="total">How many it will have.</param>
    public float ShareAfter(int samples, int total)
    {
        int gone = Math.Min(Gone, total);
        if (!HasMade || samples >= gone)
        {
            return 0;
        }

        float worth = Worth * (1 - ((float)samples / gone));
        return worth / (worth + samples);
    }
}
