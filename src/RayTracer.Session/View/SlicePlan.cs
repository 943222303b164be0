using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>
/// Cuts the work on a picture into slices: short ones at first, so that much is seen and a change of mind costs little, then longer ones,
/// which waste less. Where a single sample of every pixel takes long, slices are strips of the picture. Whatever the cut, the film comes to
/// the same bits.
/// </summary>
/// <param name="area">The pixels to render.</param>
/// <param name="samples">Samples that each pixel gets.</param>
/// <param name="isWhole">True if a slice is always of all pixels: where each would trace the light of the whole picture.</param>
public sealed class SlicePlan(Tile area, int samples, bool isWhole = false)
{
    private const double ShortestSeconds = 0.1;
    private const double LongestSeconds = 0.5;
    private const int MostSamples = 64;
    private const int StripGrain = 16;
    private int _rows;
    private int _samplesOfRows = 1;

    /// <summary>Samples in every pixel.</summary>
    public int Samples { get; private set; }

    /// <summary>The samples that some pixels have and others lack; null where all have the same samples.</summary>
    public Slice? Rest =>
        IsUneven ? new(new(area.X, area.Y + _rows, area.Width, area.Height - _rows), new(Samples, Samples + _samplesOfRows)) : null;

    /// <summary>Returns whether some pixels have more samples than others.</summary>
    public bool IsUneven => _rows > 0;

    /// <summary>Returns whether there is nothing left to do.</summary>
    public bool IsDone => Samples >= samples;

    /// <summary>The next slice.</summary>
    /// <param name="seconds">Seconds spent on the picture so far.</param>
    /// <param name="secondsPerSample">Seconds that one sample of every pixel takes; 0 where that is not known.</param>
    public Slice Next(double seconds, double secondsPerSample)
    {
        double target = Math.Clamp(seconds / 4, ShortestSeconds, LongestSeconds);
        if (!IsUneven)
        {
            _samplesOfRows = secondsPerSample > 0 ? (int)Math.Clamp(target / secondsPerSample, 1, MostSamples) : 1;

            // Stops at powers of two, where pictures are compared with the last one.
            int untilPower = (int)System.Numerics.BitOperations.RoundUpToPowerOf2((uint)Samples + 1) - Samples;
            _samplesOfRows = Math.Min(_samplesOfRows, Math.Min(untilPower, samples - Samples));
        }

        double passSeconds = secondsPerSample * _samplesOfRows;
        int rows = !isWhole && passSeconds > 2 * LongestSeconds ? (int)Math.Ceiling(area.Height * LongestSeconds / passSeconds / StripGrain) * StripGrain : area.Height;
        rows = Math.Min(rows, area.Height - _rows);
        return new(new(area.X, area.Y + _rows, area.Width, rows), new(Samples, Samples + _samplesOfRows));
    }

    /// <summary>A slice has been rendered.</summary>
    public void Add(Slice slice)
    {
        _rows += slice.Area.Height;
        if (_rows >= area.Height)
        {
            _rows = 0;
            Samples = slice.Samples.End;
        }
    }

    /// <summary>The same work where pixels have samples already.</summary>
    public SlicePlan From(int done) => new(area, samples, isWhole) { Samples = done };

    /// <summary>The same work with another number of samples in the end.</summary>
    public SlicePlan WithSamples(int total) => new(area, total, isWhole) { Samples = Samples, _rows = _rows, _samplesOfRows = _samplesOfRows };
}

/// <summary>A part of the work on a picture, between two looks at what the user wants.</summary>
/// <param name="Area">The pixels.</param>
/// <param name="Samples">The samples.</param>
public readonly record struct Slice(Tile Area, SampleRange Samples);
