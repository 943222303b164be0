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

    private readonly bool _isUnreadable = new FileInfo(path) is { Exists: true, Length: > 0 } && There(path) is null;

    // What may be replaced: what was there before, and what was written since.
    private FilmHeader? _known = There(path);

    /// <summary>True if the latest could not be written.</summary>
    public bool HasFailed { get; private set; }

    /// <summary>The number of those that were written.</summary>
    public int Count { get; private set; }

    /// <summary>The time that took in all, failures included.</summary>
    public TimeSpan Spent { get; private set; }

    /// <summary>Keeps a film that is there, and is not resumed, from being lost.</summary>
    /// <exception cref="JobException">There is one of another picture, or one of this that was not to be overwritten, or something else.</exception>
    internal void CheckLost(LoadedJob loaded)
    {
        if (_isUnreadable)
        {
            throw new JobException(JobFault.File, $"'{path}' holds no film that can be read: give another name, or delete it");
        }

        bool isOwn = (loaded.Job.Resumed ?? loaded.Job.Decision) is { Path: var own } && Path.GetFullPath(own) == Path.GetFullPath(path);
        if (isOwn || _known is not { } there)
        {
            return;
        }

        // That of a decision on the number of samples begins with the picture's.
        bool isOther = !loaded.Current(there).Content.StartsWith(loaded.NewHeader().Content, StringComparison.Ordinal);
        if (isOther || !loaded.Job.Overwrite)
        {
            string advice = isOther || loaded.Job.Resumed is not null ? "give another name, or delete it" : "--resume continues it, --overwrite begins from scratch";
            throw new JobException(JobFault.File, $"'{path}' holds samples {there.SamplesText} of {(isOther ? "another" : "this")} picture: {advice}");
        }
    }

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
            _known = header;
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

    private static (string Content, SampleRange Wanted)? Key(FilmHeader? header) => header is null ? null : (header.Content, header.Wanted);

    private static FilmHeader? There(string path)
    {
        try
        {
            return CarriedFilm.ReadHeader(path);
        }
        catch (PictureException)
        {
            // No film.
            return null;
        }
    }

    private void CheckThere(FilmHeader header)
    {
        if (Key(There(path)) is { } there && there != Key(_known) && there != Key(header))
        {
            throw new ImageWriteException($"Cannot write '{path}': another rendering has written its film there meanwhile.");
        }
    }
}
