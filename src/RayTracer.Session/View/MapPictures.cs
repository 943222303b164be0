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
    public bool Needs(RenderOrder order) =>
        order.Map.Image is FirstHitImage && (_of != (order.Picture, order.Map) || _samples < Goal(order));

    /// <summary>Traces some of these rays.</summary>
    /// <param name="order">What is wanted.</param>
    /// <param name="size">A film of the picture's size.</param>
    /// <param name="cancellation">Ends the work, but for the first sample, which shows something; the map starts from scratch then.</param>
    public void Step(RenderOrder order, Film size, CancellationToken cancellation)
    {
        if (_of != (order.Picture, order.Map))
        {
            (_of, _samples) = ((order.Picture, order.Map), 0);
            Prepare(size, order.Map.Image!);
        }

        int next = Math.Min(Goal(order), Math.Max(1, _samples * 4));
        try
        {
            RenderOptions options = new() { Threads = order.Threads, Crop = order.Region, Samples = new(_samples, next) };
            new FirstHitPass(order.Scene, options).Render(_film!, _samples == 0 ? CancellationToken.None : cancellation);
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
    public IImageRows? Picture(RenderOrder order, Film film) => order.Map.Image switch
    {
        FilmImage image => new AovPicture(new(film, [image]), image),
        { } image when _of == (order.Picture, order.Map) && _samples > 0 => new AovPicture(_film!, image),
        _ => null,
    };

    private static int Goal(RenderOrder order) => Math.Min(order.Samples, MostSamples);
}
