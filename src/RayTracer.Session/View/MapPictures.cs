using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>What is known of a picture besides its light, as colours to look at.</summary>
public sealed class MapPictures
{
    // Means of more change nothing that eyes see.
    private const int MostSamples = 16;
    private AovFilm? _film;
    private Film? _size;
    private int _samples;
    private (long Picture, ViewMap Map) _of;

    /// <summary>The image of a map that needs rays of its own; null for the others.</summary>
    public static Aov? ImageOf(ViewMap map) => map switch
    {
        ViewMap.BvhCost => Aov.BvhCost,
        ViewMap.Depth => Aov.Depth,
        ViewMap.Normal => Aov.Normal,
        ViewMap.Albedo => Aov.Albedo,
        ViewMap.Uv => Aov.Uv,
        ViewMap.Primitive => Aov.Primitive,
        _ => null,
    };

    /// <summary>Whether rays must be traced before a map can be shown as well as it will be.</summary>
    public bool Needs(RenderOrder order) => ImageOf(order.Map) is not null && (_of != (order.Picture, order.Map) || _samples < Goal(order));

    /// <summary>Traces some of these rays.</summary>
    /// <param name="order">What is wanted.</param>
    /// <param name="size">A film of the picture's size.</param>
    /// <param name="cancellation">Ends the work, but for the first sample, which shows something; the map begins anew then.</param>
    public void Step(RenderOrder order, Film size, CancellationToken cancellation)
    {
        if (_of != (order.Picture, order.Map))
        {
            (_of, _samples) = ((order.Picture, order.Map), 0);
            Prepare(size, ImageOf(order.Map)!.Value);
        }

        int next = Math.Min(Goal(order), Math.Max(1, _samples * 4));
        try
        {
            new FirstHitPass(order.Scene, new() { Threads = order.Threads, Crop = order.Region, Samples = new(_samples, next) }).Render(_film!, _samples == 0 ? CancellationToken.None : cancellation);
            _samples = next;
        }
        catch (OperationCanceledException)
        {
            _of = default;
        }
    }

    // Large images are made seldom: the runtime would let many of them lie about before it collects them.
    private void Prepare(Film size, Aov kind)
    {
        if (_film is not null && _size == size && _film.Has(kind))
        {
            _film.Clear();
            return;
        }

        _film = null;
        GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: false);
        (_film, _size) = (new(size, [kind]), size);
    }

    /// <summary>Memory is given back.</summary>
    public void Clear() => (_film, _size, _of) = (null, null, default);

    /// <summary>The picture of a map; null where it cannot be shown yet.</summary>
    public IImageRows? Picture(RenderOrder order, Film film) => order.Map switch
    {
        ViewMap.Samples => new AovPicture(new(film, [Aov.Samples]), Aov.Samples),
        ViewMap.Variance => new ErrorPicture(film),
        _ => _of == (order.Picture, order.Map) && _samples > 0 ? new AovPicture(_film!, ImageOf(order.Map)!.Value) : null,
    };

    private static int Goal(RenderOrder order) => Math.Min(order.Samples, MostSamples);

    // The standard error of each pixel, with the brightest hundredth cut off, which would leave nothing but black to the others.
    private sealed class ErrorPicture : IImageRows
    {
        private const double BrightShare = 0.99;
        private readonly Film _film;
        private readonly float _top;

        public ErrorPicture(Film film)
        {
            _film = film;
            float[] all = new float[(long)film.Width * film.Height];
            for (int y = 0; y < Height; y++)
            {
                for (int x = 0; x < Width; x++)
                {
                    all[((long)y * Width) + x] = Error(x, y);
                }
            }

            Array.Sort(all);
            _top = Math.Max(all[(long)(BrightShare * (all.Length - 1))], float.Epsilon);
        }

        public int Width => _film.Width;

        public int Height => _film.Height;

        public void ReadRow(int y, Span<float> rgb)
        {
            for (int x = 0; x < Width; x++)
            {
                Rgb color = HeatMap.Color(Error(x, y) / _top);
                (rgb[3 * x], rgb[(3 * x) + 1], rgb[(3 * x) + 2]) = (Decode(color.R), Decode(color.G), Decode(color.B));
            }
        }

        private float Error(int x, int y) => _film.SampleCount(x, y) is var n and > 0 ? float.Sqrt(_film.SampleVariance(x, y) / n) : 0;

        private static float Decode(float display) => (float)SrgbCurve.Decode(display);
    }
}
