using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>
/// Writes the film to a file now and then. The old file stays until the new one is whole; the interval stretches so that writing takes less than a
/// hundredth of the time, but for the first, of which nobody knows what it will take.
/// </summary>
/// <param name="path">The file.</param>
/// <param name="interval">The shortest time between two of them.</param>
/// <param name="streams">Takes complaints.</param>
internal sealed class Checkpoints(string path, TimeSpan interval, Streams streams)
{
    private const int LargestShare = 100;
    private readonly long _start = Stopwatch.GetTimestamp();
    private long _last = Stopwatch.GetTimestamp();
    private TimeSpan _cost;

    /// <summary>Whether the latest could not be written.</summary>
    public bool HasFailed { get; private set; }

    /// <summary>How many were written.</summary>
    public int Count { get; private set; }

    /// <summary>How long that took in all.</summary>
    public TimeSpan Spent { get; private set; }

    /// <summary>Writes one if it is time for it.</summary>
    public void Offer(Film film, FilmHeader header)
    {
        // There must be time for this one and for that at the end.
        if (Stopwatch.GetElapsedTime(_last) >= interval && Stopwatch.GetElapsedTime(_start) >= (Spent + (2 * _cost)) * LargestShare)
        {
            Write(film, header);
        }
    }

    /// <summary>Writes one.</summary>
    public void Write(Film film, FilmHeader header)
    {
        long start = Stopwatch.GetTimestamp();
        try
        {
            ImageOutputs.WriteFilm(path, film, header);
            HasFailed = false;
        }
        catch (ImageWriteException e)
        {
            // The rendering goes on: there may be room again at the next.
            streams.Fail(e.Message.TrimEnd('.'));
            HasFailed = true;
        }

        _last = Stopwatch.GetTimestamp();
        _cost = Stopwatch.GetElapsedTime(start);
        Count++;
        Spent += _cost;
    }
}
