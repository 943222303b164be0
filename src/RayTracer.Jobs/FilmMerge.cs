using System.Runtime.ExceptionServices;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>Films of different samples of one picture, to be added up. In any order, the bits are those of one render.</summary>
public sealed class FilmMerge
{
    private const int MostAtOnce = 4;
    private const int Locks = 64;
    private readonly (string Path, FilmHeader Header)[] _parts;

    private FilmMerge((string Path, FilmHeader Header)[] parts)
    {
        _parts = parts;
        Header = Together(parts);
    }

    /// <summary>The header of the films together.</summary>
    public FilmHeader Header { get; }

    /// <summary>The samples that none of them has, in words; null where there are none.</summary>
    public string? Missing => Gaps(Header) is { Length: > 0 } gaps ? $"samples {gaps} are missing of {Header.Total}" : null;

    /// <summary>Looks at films.</summary>
    /// <param name="paths">Their files, at least one.</param>
    /// <exception cref="JobException">They do not go together.</exception>
    /// <exception cref="PictureException">One cannot be read.</exception>
    public static FilmMerge Of(IEnumerable<string> paths) => new([.. paths.Select(p => (p, CarriedFilm.ReadHeader(p)))]);

    /// <summary>
    /// Films of which another one has a plane that they lack, so that the sum has none: each with the plane. Empty where there are none.
    /// </summary>
    public IReadOnlyList<(string Path, FilmPlane Plane)> Lost =>
        [.. _parts.SelectMany(p => p.Header.Planes).Except(Header.Planes).Distinct().Select(plane => (_parts.First(p => !p.Header.Planes.Contains(plane)).Path, plane))];

    /// <summary>
    /// Adds them up. Several at once: checksums take longer than a disk to read what they are of. More than a few only make the disk's way
    /// longer.
    /// </summary>
    /// <exception cref="PictureException">One cannot be read.</exception>
    public Film Add(IProgress<double>? progress = null, CancellationToken cancellation = default)
    {
        Film film = new(Header.Width, Header.Height, Header.Planes);
        Lock[] adding = [.. Enumerable.Range(0, Locks).Select(_ => new Lock())];
        int done = 0;
        try
        {
            Parallel.ForEach(_parts, new() { MaxDegreeOfParallelism = Math.Min(MostAtOnce, Environment.ProcessorCount), CancellationToken = cancellation }, part =>
            {
                FilmHeader header = CarriedFilm.AddTo(part.Path, film, adding);
                if (header.Content != part.Header.Content || !header.Samples.SequenceEqual(part.Header.Samples))
                {
                    throw new PictureException($"Cannot read the film '{part.Path}': it has changed meanwhile.");
                }

                progress?.Report((double)Interlocked.Increment(ref done) / _parts.Length);
            });
        }
        catch (AggregateException e)
        {
            ExceptionDispatchInfo.Throw(e.InnerExceptions[0]);
        }

        return film;
    }

    /// <summary>Ranges with one more, in their order, those that touch made one.</summary>
    public static IReadOnlyList<SampleRange> Join(IEnumerable<SampleRange> ranges, SampleRange more)
    {
        List<SampleRange> joined = [];
        foreach (SampleRange range in ranges.Append(more).OrderBy(r => r.First))
        {
            if (joined is [.., var last] && last.End == range.First)
            {
                joined[^1] = new(last.First, range.End);
            }
            else
            {
                joined.Add(range);
            }
        }

        return joined;
    }

    private static FilmHeader Together((string Path, FilmHeader Header)[] parts)
    {
        if (parts.Any(p => p.Header.Content != parts[0].Header.Content))
        {
            parts = [.. parts.Select(p => (p.Path, OldFilms.Current(p.Header, p.Path)))];
        }

        (string firstPath, FilmHeader first) = parts[0];
        if (Array.Find(parts, p => p.Header.Samples.Count == 0).Path is { } empty)
        {
            throw new JobException($"'{empty}' holds no samples yet");
        }

        foreach ((string path, FilmHeader header) in parts)
        {
            if (header.Content != first.Content || (header.Width, header.Height, header.Crop) != (first.Width, first.Height, first.Crop))
            {
                string? reason = Guidance.Unguided(header.Content) == Guidance.Unguided(first.Content) ? "one was rendered with --guide, or by another version's, and the other was not"
                    : Edition.Of(header.Content) != Edition.Of(first.Content) ? "one was rendered by another edition (--edition)" : null;
                throw new JobException(reason is not null ? $"'{path}' does not go with '{firstPath}': {reason}" : $"'{path}' is not of the same picture as '{firstPath}': the scene, a file that it names, its settings, a plug-in or the program differ");
            }
        }

        (SampleRange Range, string Path)[] ranges = [.. parts.SelectMany(p => p.Header.Samples.Select(r => (r, p.Path))).OrderBy(r => r.r.First).ThenBy(r => r.r.End)];
        for (int i = 1; i < ranges.Length; i++)
        {
            if (ranges[i].Range.First < ranges[i - 1].Range.End)
            {
                SampleRange twice = new(ranges[i].Range.First, Math.Min(ranges[i].Range.End, ranges[i - 1].Range.End));
                throw new JobException($"samples {FilmHeader.Text(twice)} are in both '{ranges[i - 1].Path}' and '{ranges[i].Path}'");
            }
        }

        int total = parts.Max(p => p.Header.Total);
        IEnumerable<SampleRange> joined = ranges.Aggregate(Enumerable.Empty<SampleRange>(), (all, r) => Join(all, r.Range));
        return first with
        {
            Samples = [.. joined],
            Total = total,
            Wanted = new(0, total),
            Software = Edition.Software(parts.Select(p => p.Header)),
            Planes = [.. first.Planes.Where(plane => parts.All(p => p.Header.Planes.Contains(plane)))],
        };
    }

    private static string Gaps(FilmHeader header)
    {
        List<string> gaps = [];
        int end = 0;
        foreach (SampleRange range in header.Samples.Append(new(header.Total, header.Total)))
        {
            if (range.First > end)
            {
                gaps.Add(FilmHeader.Text(new(end, range.First)));
            }

            end = Math.Max(end, range.End);
        }

        return string.Join(", ", gaps);
    }
}
