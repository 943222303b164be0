using System.Buffers;

namespace RayTracer.Rendering;

/// <summary>
/// Some pixels of a film that is rendered in passes, and what the latest pass gave them: so that it can be taken back where the pass is not
/// completed. That is 32 bytes a pixel, 8 more where samples are so bright that 64 bits do not hold their squares, and 8 for each sum
/// of <see cref="FilmPlane.OfSamples"/>.
/// </summary>
/// <param name="area">The pixels.</param>
internal sealed class PassCell(Tile area)
{
    /// <summary>Memory of a pixel in bytes, where samples are not that bright.</summary>
    /// <param name="planes">The film's planes.</param>
    public static int BytesPerPixel(IReadOnlyList<FilmPlane> planes) =>
        (Film.SumsPerPixel + FilmPlane.OfSamples.Where(planes.Contains).Sum(p => p.Sums.Count)) * sizeof(long);

    private const int MostPooled = RTracer.LargestTile * RTracer.LargestTile * Film.SumsPerPixel;
    private readonly long[] _sums = Rent(area.Pixels * Film.SumsPerPixel);
    private long[]? _rest;
    private readonly long[]?[] _beside = new long[FilmPlane.OfSamples.Count][];
    private long _handed;

    /// <summary>The pixels.</summary>
    public Tile Area => area;

    /// <summary>The pixels that have been planned so far, those of all passes added up.</summary>
    public long Planned { get; set; }

    /// <summary>Returns whether of all passes so many pixels have been handed over.</summary>
    public bool Has(long pixels) => Volatile.Read(ref _handed) >= pixels;

    /// <summary>Counts pixels that have been handed over.</summary>
    public void Count(int pixels) => Interlocked.Add(ref _handed, pixels);

    /// <summary>Keeps what a pass gives to pixels in a row.</summary>
    public void Keep(int x, int y, ReadOnlySpan<long> sums, ReadOnlySpan<long> rest)
    {
        int first = First(x, y);
        sums.CopyTo(_sums.AsSpan(first * Film.SumsPerPixel));
        if (!rest.IsEmpty)
        {
            rest.CopyTo(Own(ref _rest, 1).AsSpan(first));
        }
        else if (_rest is { } kept)
        {
            Array.Clear(kept, first, sums.Length / Film.SumsPerPixel);
        }
    }

    /// <summary>Keeps what a pass gives to a plane of <see cref="FilmPlane.OfSamples"/> of pixels in a row.</summary>
    public void Keep(FilmPlane plane, int x, int y, ReadOnlySpan<long> sums) =>
        sums.CopyTo(Own(ref _beside[plane.IndexOfSamples], plane.Sums.Count).AsSpan(First(x, y) * plane.Sums.Count));

    /// <summary>Takes from a film what the latest pass gave to pixels in a row.</summary>
    /// <param name="film">The film.</param>
    /// <param name="run">Column, row and number of the pixels.</param>
    /// <param name="samples">The number of samples of each pixel.</param>
    /// <param name="isOfHalf">True if they are of <see cref="FilmPlane.Half"/>.</param>
    public void TakeBack(Film film, (int X, int Y, int Length) run, int samples, bool isOfHalf)
    {
        int first = First(run.X, run.Y);
        ReadOnlySpan<long> rest = _rest is { } kept ? kept.AsSpan(first, run.Length) : default;
        ReadOnlySpan<long> sums = _sums.AsSpan(first * Film.SumsPerPixel, run.Length * Film.SumsPerPixel);
        film.AddRow(run.X, run.Y, sums, rest, samples, isOfHalf, sign: -1);
        foreach (FilmPlane plane in FilmPlane.OfSamples)
        {
            if (_beside[plane.IndexOfSamples] is { } beside)
            {
                film.AddToPlane(plane, run.X, run.Y, beside.AsSpan(first * plane.Sums.Count, run.Length * plane.Sums.Count), sign: -1);
            }
        }
    }

    /// <summary>Gives the memory back.</summary>
    public void Free()
    {
        Return(_sums);
        if (_rest is { } rest)
        {
            Return(rest);
        }

        foreach (long[] beside in _beside.OfType<long[]>())
        {
            Return(beside);
        }
    }

    // Many small renderings, such as slices of a picture, shall not leave a picture's memory behind each. What the pool gives is a power of
    // two, which a tile's is, but a whole picture's is not.
    private static long[] Rent(int length) =>
        length <= MostPooled ? ArrayPool<long>.Shared.Rent(length) : GC.AllocateUninitializedArray<long>(length);

    private static void Return(long[] array)
    {
        if (array.Length <= MostPooled)
        {
            ArrayPool<long>.Shared.Return(array);
        }
    }

    private int First(int x, int y) => ((y - area.Y) * area.Width) + x - area.X;

    // Several threads may be the first.
    private long[] Own(ref long[]? kept, int perPixel)
    {
        if (kept is null)
        {
            long[] made = Rent(area.Pixels * perPixel);
            Array.Clear(made);
            if (Interlocked.CompareExchange(ref kept, made, null) is not null)
            {
                Return(made);
            }
        }

        return kept;
    }
}
