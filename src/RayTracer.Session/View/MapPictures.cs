using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>The auxiliary images of a picture, as colours to look at.</summary>
public sealed class MapPictures
{
    // Means of more change nothing that eyes see.
    private const int MostSamples = 16;
    private AovFilm? _film;
    private Film? _size;
    private int _samples;
    private (long Picture, ViewMap? Map) _of;

    /// <summary>Returns whether rays must be traced before a map can be shown as well as it will be.</summary>
    public bool Needs(ViewportScene wanted) =>
        wanted.Settings.Map.Image is not (null or FilmImage) && (_of != (wanted.Picture, wanted.Settings.Map) || _samples < Goal(wanted));

    /// <summary>Traces some of these rays.</summary>
    /// <param name="wanted">The scene to show.</param>
    /// <param name="size">A film of the picture's size.</param>
    /// <param name="cancellation">Ends the work, but for the first sample, which shows something; the map starts from scratch then.</param>
    public void Step(ViewportScene wanted, Film size, CancellationToken cancellation)
    {
        if (_of != (wanted.Picture, wanted.Settings.Map))
        {
            (_of, _samples) = ((wanted.Picture, wanted.Settings.Map), 0);
            Prepare(size, wanted.Settings.Map.Image!);
        }

        int next = Math.Min(Goal(wanted), Math.Max(1, _samples * 4));
        try
        {
            RenderOptions options = new() { Threads = wanted.Settings.Threads, Crop = wanted.Settings.Region, Samples = new(_samples, next) };
            new FirstHitPass(wanted.Scene, options).Render(_film!, _samples == 0 ? CancellationToken.None : cancellation);
            _samples = next;
        }
        catch (OperationCanceledException)
        {
            _of = default;
        }
    }

    // Large images are made seldom: the runtime would let many of them lie about before it collects them.
    private void Prepare(Film size, AuxiliaryImage image)
    {
        if (_film is not null && _size == size && _film.Has(image))
        {
            _film.Clear();
            return;
        }

        _film = null;
        GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: false);
        (_film, _size) = (new(size, [image]), size);
    }

    /// <summary>Memory is given back.</summary>
    public void Clear() => (_film, _size, _of) = (null, null, default);

    /// <summary>The picture of a map; null where it cannot be shown yet.</summary>
    public AovPicture? Picture(ViewportScene wanted, Film film) => Numbers(wanted, film) is { } numbers ? new(numbers, wanted.Settings.Map.Image!) : null;

    /// <summary>Reads a row of a map's numbers.</summary>
    /// <exception cref="SessionException">There are none yet.</exception>
    public void ReadRow(ViewportScene wanted, Film film, int y, Span<double> values) =>
        (Numbers(wanted, film) ?? throw new SessionException("There is no picture yet.", SessionFault.Missing)).ReadRow(wanted.Settings.Map.Image!, y, values);

    private AovFilm? Numbers(ViewportScene wanted, Film film) => wanted.Settings.Map.Image switch
    {
        FilmImage image => new(film, [image]),
        { } when _of == (wanted.Picture, wanted.Settings.Map) && _samples > 0 => _film,
        _ => null,
    };

    private static int Goal(ViewportScene wanted) => Math.Min(wanted.Samples, MostSamples);
}
