using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>
/// The work on one picture after the other, step by step; all on the render loop's thread. Films and pictures are used again.
/// </summary>
/// <param name="frames">The place where frames hang.</param>
internal sealed class FilmWork(FrameBoard frames)
{
    private const int PreviewDepth = 1;
    private static readonly TimeSpan NoiseEvery = TimeSpan.FromSeconds(1);
    private readonly PreviewPlan _previews = new();
    private readonly LinearPicture _preview = new();
    private readonly Dictionary<(int Width, int Height), Film> _previewFilms = [];
    private readonly MapPictures _maps = new();
    private readonly DenoisedPicture _denoised = new();
    private readonly PublishPace _pace = new();
    private SlicePlan _plan = new(default, 0);
    private long _rays;
    private double _seconds;
    private double _rendered;
    private long _badSamples;
    private double? _noise;
    private long _noiseAt;
    private ViewMap? _shown;
    private bool _isStale;
    private int _samplesBefore;
    private bool _isFromFile;

    /// <summary>The picture, between steps.</summary>
    public Film? Film { get; private set; }

    /// <summary>The order that it is of; null before the first.</summary>
    public RenderOrder? Order { get; private set; }

    /// <summary>The record of its convergence.</summary>
    public ConvergenceLog Log { get; } = new();

    /// <summary>One more than the last sample of each pixel.</summary>
    public int Samples => _plan.Samples;

    /// <summary>The samples that some pixels have and others lack; null where all have the same samples.</summary>
    public Slice? Rest => _plan.Rest;

    /// <summary>Returns whether there is something to do for an order.</summary>
    public bool HasWork(RenderOrder order) =>
        order.Picture != Order?.Picture || order.Map != _shown || _previews.Scale > 1 || _maps.Needs(order) || NeedsDenoising(order)
        || (order.Mode == RenderMode.Running && _plan.Samples < order.Samples) || (_isStale && frames.IsWatched);

    /// <summary>
    /// Returns whether the next step must be completed whatever happens: else somebody who moves fast would never see anything.
    /// </summary>
    public bool IsUrgent(RenderOrder order) => order.Picture != Order?.Picture || _previews.IsFirst;

    /// <summary>Makes a step.</summary>
    /// <param name="order">What is wanted.</param>
    /// <param name="cancellation">Ends the step, if it is not urgent; the picture is of no use then.</param>
    public void Step(RenderOrder order, CancellationToken cancellation)
    {
        if (order.Picture != Order?.Picture)
        {
            Begin(order);
        }

        if (order.Samples != Order!.Samples)
        {
            _plan = _plan.WithSamples(order.Samples);
        }

        Order = order;
        if (_isFromFile)
        {
            _isFromFile = false;
            Show(order, isMilestone: true, CancellationToken.None);
        }
        else if (_previews.Scale > 1)
        {
            Preview(order, _previews.IsFirst ? CancellationToken.None : cancellation);
        }
        else if (_maps.Needs(order))
        {
            _maps.Step(order, Film!, cancellation);
            Show(order, isMilestone: true, cancellation);
        }
        else if (NeedsDenoising(order))
        {
            _denoised.Step(order, _plan.Samples, cancellation);
            Show(order, isMilestone: true, cancellation);
        }
        else if (order.Mode == RenderMode.Running && !_plan.IsDone)
        {
            Render(order, cancellation);
        }
        else
        {
            Show(order, isMilestone: true, cancellation);
        }
    }

    /// <summary>The progress of the picture.</summary>
    public RenderStatus Status(RenderOrder order)
    {
        double perSample = _rendered > 0 ? _seconds / _rendered : 0;
        bool isDone = order.Picture == Order?.Picture && _plan.Samples >= order.Samples;
        return new()
        {
            Status = isDone ? "done" : order.Mode switch { RenderMode.Paused => "paused", RenderMode.Stopped => "stopped", _ => "rendering" },
            Width = order.Scene.Render.Width,
            Height = order.Scene.Render.Height,
            Samples = _plan.Samples,
            SamplesTotal = order.Samples,
            RaysPerSecond = _seconds > 0 ? _rays / _seconds : 0,
            Seconds = _seconds,
            SecondsLeft = perSample > 0 ? Math.Max(0, order.Samples - _samplesBefore - _rendered) * perSample : null,
            Noise = _noise,
            Threads = order.Threads,
            Map = order.Map,
            Region = order.Region,
            IsPreview = _plan.Samples == 0,
            BadSamples = _badSamples,
        };
    }

    private void Begin(RenderOrder order)
    {
        (int width, int height) = (order.Scene.Render.Width, order.Scene.Render.Height);
        Film? begun = order.Start?.Take();
        if (Film?.Width == width && Film.Height == height)
        {
            Film.Clear();
        }
        else
        {
            Film = null;
            _maps.Clear();
            _denoised.Clear();
            _previewFilms.Clear();
            Film = begun ?? FilmBudget.Create(width, height);
        }

        Film = begun ?? Film;
        Order = order;
        _samplesBefore = begun is null ? order.First : order.Start!.Held.End;
        _plan = new SlicePlan(order.Area, order.Samples).From(_samplesBefore);
        _isFromFile = _samplesBefore > order.First;
        if (order.Map.IsLight && !_isFromFile)
        {
            _previews.Begin((long)width * height);
        }
        else
        {
            _previews.End();
        }

        Log.Clear();
        (_rays, _seconds, _rendered, _badSamples, _noise) = (0, 0, 0, 0, _isFromFile ? NoiseEstimate.Of(Film, order.Area) : null);
    }

    private void Preview(RenderOrder order, CancellationToken cancellation)
    {
        RenderDescription render = order.Scene.Render;
        int scale = _previews.Scale;
        RenderDescription coarse = render with
        {
            Width = Math.Max(1, render.Width / scale),
            Height = Math.Max(1, render.Height / scale),
            SamplesPerPixel = 1,
            MaxDiffuseDepth = Math.Min(render.MaxDiffuseDepth, PreviewDepth),
        };
        Scene scene = order.Scene.WithView(order.Camera, coarse, new((_, _) => new(1, 1))) ?? throw new InvalidOperationException("A preview cannot be rendered.");
        long start = Stopwatch.GetTimestamp();
        Film film = PreviewFilm(coarse);
        RenderStatistics statistics = new RTracer(scene, new() { Threads = order.Threads }).Render(film, null, cancellation);
        if (statistics.Cancelled)
        {
            return;
        }

        _previews.Add((long)coarse.Width * coarse.Height, Stopwatch.GetElapsedTime(start).TotalSeconds, (long)render.Width * render.Height);
        _preview.CopyFrom(film);
        if (frames.IsWatched)
        {
            Publish(order, isPreview: true, picture => picture.CopyFrom(_preview));
        }

        _isStale |= !frames.IsWatched;
    }

    // One for each size: a moving hand would leave hundreds of megabytes behind.
    private Film PreviewFilm(RenderDescription coarse)
    {
        if (_previewFilms.TryGetValue((coarse.Width, coarse.Height), out Film? film))
        {
            film.Clear();
            return film;
        }

        film = new(coarse.Width, coarse.Height);
        _previewFilms.Add((coarse.Width, coarse.Height), film);
        return film;
    }

    private void Render(RenderOrder order, CancellationToken cancellation)
    {
        Slice slice = _plan.Next(_seconds, _rendered > 0 ? _seconds / _rendered : 0);
        long start = Stopwatch.GetTimestamp();
        RenderOptions options = new() { Threads = order.Threads, Crop = slice.Area, Samples = slice.Samples };
        RenderStatistics statistics = new RTracer(order.Scene, options).Render(Film!, null, cancellation);
        if (statistics.Cancelled)
        {
            return;
        }

        _seconds += Stopwatch.GetElapsedTime(start).TotalSeconds;
        _rendered += (double)slice.Samples.Count * slice.Area.Height / order.Area.Height;
        _rays += statistics.Rays;
        _badSamples += statistics.NonFiniteSamples;
        bool wasFirst = _plan.Samples == 0;
        _plan.Add(slice);
        if (!_plan.IsUneven)
        {
            Log.Add(Film!, order.Area, _plan.Samples);
        }

        if (!_plan.IsUneven && (Stopwatch.GetElapsedTime(_noiseAt) > NoiseEvery || _plan.IsDone))
        {
            _noise = NoiseEstimate.Of(Film!, order.Area);
            _noiseAt = Stopwatch.GetTimestamp();
        }

        Show(order, (wasFirst && !_plan.IsUneven) || _plan.IsDone, cancellation);
    }

    // Shows what there is, if anybody looks and it is time to; else it is remembered that there is something to show.
    private void Show(RenderOrder order, bool isMilestone, CancellationToken cancellation)
    {
        _shown = order.Map;
        if (!frames.IsWatched || cancellation.IsCancellationRequested || !(isMilestone || _pace.IsTime))
        {
            _isStale = true;
            return;
        }

        _isStale = false;
        if (!order.Map.IsLight)
        {
            if (_maps.Picture(order, Film!) is { } map)
            {
                Publish(order, isPreview: false, picture => picture.CopyFrom(map));
            }

            return;
        }

        IImageRows? denoised = order.Map == ViewMap.Denoised ? _denoised.Of(order) : null;
        Publish(order, _plan.Samples == 0, picture =>
        {
            PicturePainter.Paint(Film!, _preview, picture);
            if (denoised is not null)
            {
                PicturePainter.Cover(denoised, order.Area, picture);
            }
        });
    }

    // A paused picture is not rendered a second time behind the user's back.
    private bool NeedsDenoising(RenderOrder order) =>
        order.Picture == Order?.Picture && order.Mode != RenderMode.Paused && _denoised.Needs(order, _plan.Samples);

    private void Publish(RenderOrder order, bool isPreview, Action<LinearPicture> draw)
    {
        (int width, int height) = (order.Scene.Render.Width, order.Scene.Render.Height);
        FrameInfo info = new(width, height, _plan.Samples, isPreview, _plan.IsDone && !NeedsDenoising(order), order.Map.IsLight);
        _pace.Make(() => frames.Publish(info, draw));
    }
}

/// <summary>Keeps what frames cost the renderer to a small share of its time.</summary>
public sealed class PublishPace
{
    // One part in so many of the time.
    private const int Share = 12;
    private long _last = -1;
    private TimeSpan _cost;

    /// <summary>Returns whether it is time for a frame.</summary>
    public bool IsTime => _last < 0 || Stopwatch.GetElapsedTime(_last) >= _cost * (Share - 1);

    /// <summary>Makes a frame, and takes down what that costs.</summary>
    public void Make(Action frame)
    {
        long start = Stopwatch.GetTimestamp();
        frame();
        _last = Stopwatch.GetTimestamp();
        _cost = Stopwatch.GetElapsedTime(start, _last);
    }
}

/// <summary>The estimate of a picture's remaining noise.</summary>
public static class NoiseEstimate
{
    private const int MostPixels = 1 << 15;

    /// <summary>
    /// Standard error of the pixels' luminance, mean over some pixels, relative to their mean luminance; null where it is not known.
    /// </summary>
    /// <param name="film">The picture.</param>
    /// <param name="area">Its pixels that have samples.</param>
    public static double? Of(Film film, Tile area)
    {
        int step = Math.Max(1, (int)Math.Ceiling(Math.Sqrt((double)area.Pixels / MostPixels)));
        (double error, double light) = (0, 0);
        for (int y = area.Y; y < area.Y + area.Height; y += step)
        {
            for (int x = area.X; x < area.X + area.Width; x += step)
            {
                uint count = film.SampleCount(x, y);
                if (count < 2)
                {
                    return null;
                }

                error += Math.Sqrt(film.SampleVariance(x, y) / count);
                light += film.Mean(x, y).Luminance;
            }
        }

        return light > 0 ? error / light : null;
    }
}
