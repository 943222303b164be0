using System.Numerics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>
/// The picture without most of its noise. It takes two halves of the samples, which the film does not
/// keep apart: they are rendered once more, whenever the film has twice as many as they. Then both become the first half, so that in all it
/// takes about as long as the film.
/// </summary>
public sealed class DenoisedPicture
{
    // Half of the memory that there is: the film has a part of its own.
    private const int Part = 2;

    private HalfRender[]? _halves;
    private Picture? _picture;
    private int _samples;
    private long _of = -1;

    /// <summary>Returns whether there is something to do before it can be shown as well as the film's samples allow.</summary>
    /// <param name="order">What is wanted.</param>
    /// <param name="samples">Samples in each pixel of the film.</param>
    public bool Needs(RenderOrder order, int samples) => order.Map == ViewMap.Denoised && Next(order, samples) > (_of == order.Picture ? _samples : 0)
        && Bytes(order.Scene.Render) < GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / Part;

    /// <summary>Renders halves with more samples, and denoises them.</summary>
    /// <param name="order">What is wanted.</param>
    /// <param name="samples">Samples in each pixel of the film.</param>
    /// <param name="cancellation">Ends the work; the halves start from scratch then.</param>
    public void Step(RenderOrder order, int samples, CancellationToken cancellation)
    {
        int next = Next(order, samples);
        bool isTwice = _of == order.Picture && next == 2 * _samples;
        _of = -1;
        (HalfRender first, HalfRender second) = Halves(order.Scene.Render);
        try
        {
            if (isTwice)
            {
                first.Film.Merge(second.Film);
                new FirstHitPass(order.Scene, Options(order, new(next / 4, next / 2))).Render(first.Features, cancellation);
            }
            else
            {
                Render(order, first, new(0, next / 2), cancellation);
            }

            Render(order, second, new(next / 2, next), cancellation);
            _picture = Denoiser.Denoise(first, second, order.Threads, null, cancellation).Picture;
            (_samples, _of) = (next, order.Picture);
        }
        catch (OperationCanceledException)
        {
            // Another picture is wanted.
        }
    }

    /// <summary>The picture; null where there is none of an order yet.</summary>
    public IImageRows? Of(RenderOrder order) => _of == order.Picture ? _picture : null;

    /// <summary>Memory is given back.</summary>
    public void Clear() => (_halves, _picture, _of) = (null, null, -1);

    // Powers of two, and in the end all; 0 where there are no halves.
    private static int Next(RenderOrder order, int samples)
    {
        int next = samples >= order.Samples ? order.Samples : (int)(BitOperations.RoundUpToPowerOf2((uint)samples + 1) / 2);
        return next < 2 ? 0 : next;
    }

    private static long Bytes(RenderDescription render) =>
        (((2L * Film.BytesPerPixel) + Denoiser.BytesPerPixel) * render.Width * render.Height) + (2 * AovFilm.Bytes(HalfRender.Kinds, render.Width, render.Height));

    private static void Render(RenderOrder order, HalfRender half, SampleRange samples, CancellationToken cancellation)
    {
        half.Film.Clear();
        half.Features.Clear();
        new RTracer(order.Scene, Options(order, samples)).Render(half.Film, null, cancellation);
        new FirstHitPass(order.Scene, Options(order, samples)).Render(half.Features, cancellation);
    }

    private static RenderOptions Options(RenderOrder order, SampleRange samples) =>
        new() { Threads = order.Threads, Crop = order.Region, Samples = samples };

    private (HalfRender First, HalfRender Second) Halves(RenderDescription render)
    {
        if (_halves is not [{ Film: var film }, _] || (film.Width, film.Height) != (render.Width, render.Height))
        {
            Clear();
            _halves = [HalfRender.Create(render.Width, render.Height), HalfRender.Create(render.Width, render.Height)];
        }

        return (_halves[0], _halves[1]);
    }
}
