using System.Numerics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>
/// The picture without most of its noise. It takes two halves of the samples, which the film does not
/// keep apart: they are rendered once more, whenever the film has twice as many as they. Then both become the first half, so that in all it
/// takes about as long as the film. Where the light of lamps is kept apart, it is of the halves, too: factors on it change what is denoised.
/// </summary>
public sealed class DenoisedPicture
{
    // Half of the memory that there is: the film has a part of its own.
    private const int Part = 2;

    private readonly LightLayers[] _lights = [new(), new()];
    private HalfRender[]? _halves;
    private object? _factors;
    private Picture? _picture;
    private int _samples;
    private long _of = -1;

    /// <summary>Returns whether there is something to do before it can be shown as well as the film's samples allow.</summary>
    /// <param name="wanted">The scene to show.</param>
    /// <param name="samples">Samples in each pixel of the film.</param>
    public bool Needs(ViewportScene wanted, int samples) => wanted.Settings.Map == ViewMap.Denoised
        && (Next(wanted, samples) > (_of == wanted.Picture ? _samples : 0) || (_of == wanted.Picture && !ReferenceEquals(_factors, wanted.Settings.LightFactors)))
        && Bytes(wanted.Scene.Render) < GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / Part;

    /// <summary>Renders halves with more samples, and denoises them.</summary>
    /// <param name="wanted">The scene to show.</param>
    /// <param name="samples">Samples in each pixel of the film.</param>
    /// <param name="cancellation">Ends the work; the halves start from scratch then.</param>
    public void Step(ViewportScene wanted, int samples, CancellationToken cancellation)
    {
        int next = Next(wanted, samples);
        bool isOwn = _of == wanted.Picture;
        bool isRendered = isOwn && next <= _samples;
        bool isTwice = isOwn && next == 2 * _samples && wanted.Settings.LightFactors is null;
        _of = -1;
        (HalfRender first, HalfRender second) = Halves(wanted.Scene.Render);
        try
        {
            if (isRendered)
            {
                next = _samples;
            }
            else if (isTwice)
            {
                first.Film.Merge(second.Film);
                HalfRender.Pass(wanted.Scene, Options(wanted, new(next / 4, next / 2))).Render(first.Features, cancellation);
            }
            else
            {
                Render(wanted, first, _lights[0], new(0, next / 2), cancellation);
            }

            if (!isRendered)
            {
                Render(wanted, second, _lights[1], new(next / 2, next), cancellation);
            }

            _picture = Denoiser.Denoise(Planes(wanted, first, _lights[0]), Planes(wanted, second, _lights[1]), wanted.Settings.Threads, null, cancellation).Picture;
            (_samples, _of, _factors) = (next, wanted.Picture, wanted.Settings.LightFactors);
        }
        catch (OperationCanceledException)
        {
            // Another picture is wanted.
        }
    }

    /// <summary>The picture; null where there is none of that one yet.</summary>
    public IImageRows? Of(ViewportScene wanted) => _of == wanted.Picture ? _picture : null;

    /// <summary>Memory is given back.</summary>
    public void Clear() => (_halves, _picture, _of) = (null, null, -1);

    // Powers of two, and in the end all; 0 where there are no halves.
    private static int Next(ViewportScene wanted, int samples)
    {
        int next = samples >= wanted.Samples ? wanted.Samples : (int)(BitOperations.RoundUpToPowerOf2((uint)samples + 1) / 2);
        return next < 2 ? 0 : next;
    }

    private static long Bytes(RenderDescription render) =>
        Denoising.Bytes(render.Width, render.Height, PlanesOf(render));

    private static IReadOnlyList<FilmPlane> PlanesOf(RenderDescription render) => FilmPlane.Needed(render.Integrator, noise: true);

    private static HalfPlanes Planes(ViewportScene wanted, HalfRender half, LightLayers lights)
    {
        HalfPlanes planes = HalfPlanes.Of(half);
        lights.Mix(wanted, (y, more) =>
        {
            for (int i = 0; i < more.Length; i++)
            {
                planes.Color[i % 3][i / 3, y] += more[i];
            }
        }, half.Film.Height);
        planes.Extend();
        return planes;
    }

    private static void Render(ViewportScene wanted, HalfRender half, LightLayers lights, SampleRange samples, CancellationToken cancellation)
    {
        half.Film.Clear();
        half.Features.Clear();
        lights.Begin(wanted, half.Film);
        RenderOptions options = new() { Threads = wanted.Settings.Threads, Crop = wanted.Settings.Region, Samples = samples, Layers = lights.Film };
        new RTracer(wanted.Scene, options).Render(half.Film, null, cancellation);
        HalfRender.Pass(wanted.Scene, Options(wanted, samples)).Render(half.Features, cancellation);
    }

    private static RenderOptions Options(ViewportScene wanted, SampleRange samples) =>
        new() { Threads = wanted.Settings.Threads, Crop = wanted.Settings.Region, Samples = samples };

    private (HalfRender First, HalfRender Second) Halves(RenderDescription render)
    {
        if (_halves is not [{ Film: var film }, _] || (film.Width, film.Height) != (render.Width, render.Height) || !film.Planes.SequenceEqual(PlanesOf(render)))
        {
            Clear();
            _halves = [HalfRender.Create(render.Width, render.Height, PlanesOf(render)), HalfRender.Create(render.Width, render.Height, PlanesOf(render))];
        }

        return (_halves[0], _halves[1]);
    }
}
