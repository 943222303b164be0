using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>
/// Writes the film to a file now and then. The old file stays until the new one is whole; the interval stretches so that writing takes less
/// than a
/// hundredth of the time, but for the first, whose cost is unknown. A film of other samples that comes there meanwhile is not replaced.
/// </summary>
/// <param name="path">The file.</param>
/// <param name="interval">The shortest time between two of them.</param>
/// <param name="watch">Takes failures.</param>
public sealed class Checkpoints(string path, TimeSpan interval, IJobWatch watch)
{
    // Less than a hundredth, with some room for a disk that is slower the next time.
    private const int LargestShare = 125;
    private readonly long _start = Stopwatch.GetTimestamp();
    private long _last = Stopwatch.GetTimestamp();
    private TimeSpan _cost;

    // What may be replaced: what was there before, and what was written since.
    private (string Content, SampleRange Wanted)? _known = There(path);

    /// <summary>True if the latest could not be written.</summary>
    public bool HasFailed { get; private set; }

    /// <summary>The number of those that were written.</summary>
    public int Count { get; private set; }

    /// <summary>The time that took in all, failures included.</summary>
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
            CheckThere(header);
            JobFiles.WriteFilm(path, film, header);
            _known = (header.Content, header.Wanted);
            HasFailed = false;
            Count++;
        }
        catch (ImageWriteException e)
        {
            // The rendering goes on: there may be room again at the next.
            watch.Fail(e.Message.TrimEnd('.'));
            HasFailed = true;
        }

        _last = Stopwatch.GetTimestamp();
        _cost = Stopwatch.GetElapsedTime(start);
        Spent += _cost;
    }

    private static (string Content, SampleRange Wanted)? There(string path)
    {
        try
        {
            return CarriedFilm.ReadHeader(path) is var header ? (header.Content, header.Wanted) : null;
        }
        catch (PictureException)
        {
            // No film.
            return null;
        }
    }

    private void CheckThere(FilmHeader header)
    {
        if (There(path) is { } there && there != _known && there != (header.Content, header.Wanted))
        {
            throw new ImageWriteException($"Cannot write '{path}': another rendering has written its film there meanwhile.");
        }
    }
}
