using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Jobs;
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
    private readonly MovingView _moving = new();
    private readonly MovingPlan _movingPlan = new();
    private readonly Dictionary<(int Width, int Height), Film> _previewFilms = [];
    private readonly MapPictures _maps = new();
    private readonly DenoisedPicture _denoised = new();
    private readonly LightLayers _lights = new();
    private readonly LightLayers _previewLights = new();
    private readonly PublishPace _pace = new();
    private readonly FilmAside _aside = new();
    private SlicePlan _plan = new(default, 0);
    private Textbook.Renderer? _textbook;
    private long _rays;
    private double _seconds;
    private double _secondsBefore;
    private double _rendered;
    private long _badSamples;
    private double? _noise;
    private long _noiseAt;
    private ViewMap? _map;
    private (ViewMap? Map, string? Text) _legend;
    private bool _isFiltered;
    private bool _isStale;
    private object? _lightFactors;
    private object? _previewFactors;
    private int _samplesBefore;
    private bool _isFromFile;
    private bool _hasSamples;

    /// <summary>The picture, between steps.</summary>
    public Film? Film { get; private set; }

    /// <summary>The scene that it shows; null before the first.</summary>
    public ViewportScene? Shown { get; private set; }

    /// <summary>The record of its convergence.</summary>
    public ConvergenceLog Log { get; } = new();

    /// <summary>One more than the last sample of each pixel.</summary>
    public int Samples => _plan.Samples;

    /// <summary>The samples that some pixels have and others lack; null where all have the same samples.</summary>
    public Slice? Rest => _plan.Rest;

    /// <summary>Returns whether there is something to do for a scene.</summary>
    public bool HasWork(ViewportScene wanted) =>
        wanted.Picture != Shown?.Picture || wanted.Settings.Map != _map || !ReferenceEquals(wanted.Settings.LightFactors, _lightFactors) || wanted.Settings.FiltersMotion != _isFiltered || _previews.Scale > 1 || _movingPlan.HasNext || _maps.Needs(wanted) || NeedsDenoising(wanted)
        || (wanted.Settings.Mode == RenderMode.Running && _plan.Samples < wanted.Samples) || (_isStale && frames.IsWatched);

    /// <summary>
    /// Returns whether the next step must be completed whatever happens: else somebody who moves fast would never see anything.
    /// </summary>
    public bool IsUrgent(ViewportScene wanted) => wanted.Picture != Shown?.Picture || _previews.IsFirst || _movingPlan.IsFirst;

    /// <summary>Makes a step.</summary>
    /// <param name="wanted">The scene to show.</param>
    /// <param name="cancellation">Ends the step, if it is not urgent; the picture is of no use then.</param>
    public void Step(ViewportScene wanted, CancellationToken cancellation)
    {
        if (wanted.Picture != Shown?.Picture)
        {
            Begin(wanted);
        }

        if (wanted.Samples != Shown!.Samples)
        {
            _plan = _plan.WithSamples(wanted.Samples);
        }

        Shown = wanted;
        if (wanted.Settings.FiltersMotion != _isFiltered)
        {
            Switch(wanted);
        }

        if (_plan.Samples == 0 && !_movingPlan.HasNext && _previews.Scale <= 1 && !ReferenceEquals(_previewFactors, wanted.Settings.LightFactors))
        {
            BeginPreviews(wanted);
        }

        if (_isFromFile)
        {
            _isFromFile = false;
            Show(wanted, isMilestone: true, CancellationToken.None);
        }
        else if (_movingPlan.HasNext)
        {
            Move(wanted, _movingPlan.IsFirst ? CancellationToken.None : cancellation);
        }
        else if (_previews.Scale > 1)
        {
            Preview(wanted, _previews.IsFirst ? CancellationToken.None : cancellation);
        }
        else if (_maps.Needs(wanted))
        {
            _maps.Step(wanted, Film!, cancellation);
            Show(wanted, isMilestone: true, cancellation);
        }
        else if (NeedsDenoising(wanted))
        {
            _denoised.Step(wanted, _plan.Samples, cancellation);
            Show(wanted, isMilestone: true, cancellation);
        }
        else if (wanted.Settings.Mode == RenderMode.Running && !_plan.IsDone)
        {
            Render(wanted, cancellation);
        }
        else
        {
            Show(wanted, isMilestone: true, cancellation);
        }
    }

    /// <summary>The progress of the picture.</summary>
    public RenderStatus Status(ViewportScene wanted)
    {
        double perSample = _rendered > 0 ? _seconds / _rendered : 0;
        bool isDone = wanted.Picture == Shown?.Picture && _plan.Samples >= wanted.Samples;
        return new()
        {
            Status = isDone ? "done" : wanted.Settings.Mode switch { RenderMode.Paused => "paused", RenderMode.Stopped => "stopped", _ => "rendering" },
            Width = wanted.Scene.Render.Width,
            Height = wanted.Scene.Render.Height,
            Samples = _plan.Samples,
            SamplesTotal = wanted.Samples,
            RaysPerSecond = _seconds > 0 ? _rays / _seconds : 0,
            Seconds = _secondsBefore + _seconds,
            SecondsLeft = perSample > 0 ? Math.Max(0, wanted.Samples - _samplesBefore - _rendered) * perSample : null,
            Noise = _noise,
            IsPreview = _plan.Samples == 0,
            BadSamples = _badSamples,
            Legend = _legend.Map == wanted.Settings.Map ? _legend.Text : null,
        };
    }

    private void Begin(ViewportScene wanted)
    {
        frames.Begin(wanted.Good.Document);
        RenderDescription render = wanted.Scene.Render;
        (int width, int height) = (render.Width, render.Height);
        Film? begun = wanted.Start?.Take();
        _textbook = wanted.ReadTextbook();
        IReadOnlyList<FilmPlane> planes = FilmPlane.Needed(render.Integrator, noise: _textbook is null);
        if (Film?.Width == width && Film.Height == height && Film.Planes.SequenceEqual(planes))
        {
            // Thirty megabytes, at each step of a camera that moves.
            if (_hasSamples)
            {
                Film.Clear();
            }
        }
        else
        {
            Film = null;
            _maps.Clear();
            _denoised.Clear();
            _previewFilms.Clear();
            Film = begun ?? FilmBudget.Create(width, height, planes);
        }

        Film = begun ?? Film;
        _lights.Begin(wanted, Film!);

        // Light that is kept apart has not been set aside.
        bool isResumed = begun is null && _lights.Film is null && _textbook is null && _aside.TryResume(wanted, Film!);
        _hasSamples = begun is not null || isResumed;
        Shown = wanted;
        _samplesBefore = isResumed ? _aside.Samples : begun is null ? wanted.First : wanted.Start!.Held.End;
        _plan = new SlicePlan(wanted.Area, wanted.Samples, _textbook is not null || render.Integrator.Has(IntegratorTraits.TracesLight)).From(_samplesBefore);
        _isFromFile = _samplesBefore > wanted.First;
        BeginPreviews(wanted);

        Log.Clear();
        (_rays, _seconds, _rendered, _badSamples, _noise) = (0, 0, 0, 0, _isFromFile ? NoiseEstimate.Of(Film, wanted.Area) : null);
        _secondsBefore = isResumed ? _aside.Seconds : 0;
    }

    private void BeginPreviews(ViewportScene wanted)
    {
        _previewFactors = wanted.Settings.LightFactors;
        bool areWanted = wanted.Settings.Map.IsLight && !_isFromFile;
        _previews.End();
        _movingPlan.End();
        if (areWanted && wanted.Settings.FiltersMotion)
        {
            _movingPlan.Begin();
        }
        else if (areWanted)
        {
            _previews.Begin((long)wanted.Scene.Render.Width * wanted.Scene.Render.Height);
        }
    }

    // The picture that is there is shown in the other way.
    private void Switch(ViewportScene wanted)
    {
        _isFiltered = wanted.Settings.FiltersMotion;
        _isStale = true;
        if (_isFiltered && !_movingPlan.HasMade && wanted.Settings.Map.IsLight)
        {
            _movingPlan.Begin();
        }
    }

    private void Move(ViewportScene wanted, CancellationToken cancellation)
    {
        if (!_moving.Next(wanted, _preview, cancellation))
        {
            return;
        }

        _movingPlan.Add();
        _previewFactors = wanted.Settings.LightFactors;
        if (frames.IsWatched)
        {
            Publish(wanted, isPreview: true, picture => picture.CopyFrom(_preview));
        }

        _isStale |= !frames.IsWatched;
    }

    private void Preview(ViewportScene wanted, CancellationToken cancellation)
    {
        RenderDescription render = wanted.Scene.Render;
        int scale = _previews.Scale;
        RenderDescription coarse = render with
        {
            Width = Math.Max(1, render.Width / scale),
            Height = Math.Max(1, render.Height / scale),
            SamplesPerPixel = 1,
            MaxDiffuseDepth = Math.Min(render.MaxDiffuseDepth, PreviewDepth),

            // Light from the lamps takes more samples than a preview has.
            Integrator = render.Integrator.Has(IntegratorTraits.TracesLight) ? Integrator.Path : render.Integrator,
        };
        Scene scene = wanted.Scene.WithView(wanted.Camera, coarse, new((_, _) => new(1, 1))) ?? throw new InvalidOperationException("A preview cannot be rendered.");
        long start = Stopwatch.GetTimestamp();
        Film film = PreviewFilm(coarse);
        _previewLights.Begin(wanted with { Scene = scene }, film);
        RenderStatistics statistics = new RTracer(scene, new() { Threads = wanted.Settings.Threads, Layers = _previewLights.Film }).Render(film, null, cancellation);
        if (statistics.Cancelled)
        {
            return;
        }

        _previews.Add((long)coarse.Width * coarse.Height, Stopwatch.GetElapsedTime(start).TotalSeconds, (long)render.Width * render.Height);
        _preview.CopyFrom(film);
        _previewLights.Paint(wanted, _preview);
        _previewFactors = wanted.Settings.LightFactors;
        if (frames.IsWatched)
        {
            Publish(wanted, isPreview: true, picture => picture.CopyFrom(_preview));
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

        film = new(coarse.Width, coarse.Height, FilmPlane.Needed(coarse.Integrator));
        _previewFilms.Add((coarse.Width, coarse.Height), film);
        return film;
    }

    private void Render(ViewportScene wanted, CancellationToken cancellation)
    {
        Slice slice = _plan.Next(_seconds, _rendered > 0 ? _seconds / _rendered : 0);
        long start = Stopwatch.GetTimestamp();
        _hasSamples = true;
        RenderOptions options = new() { Threads = wanted.Settings.Threads, Crop = slice.Area, Samples = slice.Samples, Layers = _lights.Film };
        RenderStatistics statistics = _textbook is null ? new RTracer(wanted.Scene, options).Render(Film!, null, cancellation)
            : new TextbookRender(_textbook, options).Render(Film!, null, cancellation);
        if (statistics.Cancelled)
        {
            return;
        }

        _seconds += Stopwatch.GetElapsedTime(start).TotalSeconds;
        _rendered += (double)slice.Samples.Count * slice.Area.Height / wanted.Area.Height;
        _rays += statistics.Rays;
        _badSamples += statistics.NonFiniteSamples;
        bool wasFirst = _plan.Samples == 0;
        _plan.Add(slice);
        if (!_plan.IsUneven)
        {
            Log.Add(Film!, wanted.Area, _plan.Samples);
            if (_lights.Film is null && _textbook is null)
            {
                _aside.Keep(wanted, Film!, _plan.Samples, _secondsBefore + _seconds);
            }
        }

        if (!_plan.IsUneven && (Stopwatch.GetElapsedTime(_noiseAt) > NoiseEvery || _plan.IsDone))
        {
            _noise = NoiseEstimate.Of(Film!, wanted.Area);
            _noiseAt = Stopwatch.GetTimestamp();
        }

        Show(wanted, (wasFirst && !_plan.IsUneven) || _plan.IsDone, cancellation);
    }

    // Shows what there is, if anybody looks and it is time to; else it is remembered that there is something to show.
    private void Show(ViewportScene wanted, bool isMilestone, CancellationToken cancellation)
    {
        (_map, _lightFactors) = (wanted.Settings.Map, wanted.Settings.LightFactors);
        if (!frames.IsWatched || cancellation.IsCancellationRequested || !(isMilestone || _pace.IsTime))
        {
            _isStale = true;
            return;
        }

        _isStale = false;
        if (!wanted.Settings.Map.IsLight)
        {
            if (_maps.Picture(wanted, Film!) is { } map)
            {
                _legend = (_map, map.Legend);
                Publish(wanted, isPreview: false, picture => picture.CopyFrom(map));
            }

            return;
        }

        IImageRows? denoised = wanted.Settings.Map == ViewMap.Denoised ? _denoised.Of(wanted) : null;
        Publish(wanted, _plan.Samples == 0, picture =>
        {
            PicturePainter.Paint(Film!, _preview, picture);
            _lights.Paint(wanted, picture);
            if (wanted.Settings.FiltersMotion && ReferenceEquals(_previewFactors, wanted.Settings.LightFactors) && _textbook is null && _movingPlan.ShareAfter(_plan.Samples, wanted.Samples) is > 0 and var share)
            {
                PicturePainter.Blend(_preview, share, picture);
            }

            if (denoised is not null)
            {
                PicturePainter.Cover(denoised, wanted.Area, picture);
            }
        });
    }

    /// <summary>The numbers of some pixels in the map that is shown, row by row.</summary>
    /// <param name="shown">What is shown.</param>
    /// <param name="part">The pixels.</param>
    /// <exception cref="SessionException">There are no such pixels, or too many of them, or they have no numbers yet.</exception>
    public IReadOnlyList<PixelReading> Readings(ViewportScene shown, Tile part)
    {
        const int most = 4096;
        Film film = Film!;
        bool isInside = part.X >= 0 && part.Y >= 0 && part.Width > 0 && part.Height > 0 && part.Width <= film.Width - part.X && part.Height <= film.Height - part.Y;
        if (!isInside || part.Pixels > most)
        {
            throw new SessionException($"The picture has {film.Width}×{film.Height} pixels, of which {most} at most are read.", SessionFault.Missing);
        }

        string letters = shown.Settings.Map.Image?.Letters ?? "RGB";
        double[] row = new double[film.Width * letters.Length];
        List<PixelReading> readings = [];
        for (int y = part.Y; y < part.Y + part.Height; y++)
        {
            ReadRow(shown, y, row);
            readings.AddRange(Enumerable.Range(part.X, part.Width).Select(x => new PixelReading(
                x, y, letters, [.. row.Skip(x * letters.Length).Take(letters.Length).Select(v => double.IsFinite(v) ? v : (double?)null)])));
        }

        return readings;
    }

    private void ReadRow(ViewportScene shown, int y, double[] row)
    {
        if (shown.Settings.Map.Image is not null)
        {
            _maps.ReadRow(shown, Film!, y, row);
            return;
        }

        if (_plan is { Samples: 0, IsUneven: false })
        {
            // What is seen has not come from the film: its pixels are not black.
            Array.Fill(row, double.NaN);
            return;
        }

        float[] light = new float[row.Length];
        ((shown.Settings.Map == ViewMap.Denoised ? _denoised.Of(shown) : null) ?? Film!).ReadRow(y, light);
        Array.ConvertAll(light, l => (double)l).CopyTo(row, 0);
    }

    // A paused picture is not rendered a second time behind the user's back.
    private bool NeedsDenoising(ViewportScene wanted) =>
        wanted.Picture == Shown?.Picture && wanted.Settings.Mode != RenderMode.Paused && _denoised.Needs(wanted, _plan.Samples);

    private void Publish(ViewportScene wanted, bool isPreview, Action<LinearPicture> draw)
    {
        (int width, int height) = (wanted.Scene.Render.Width, wanted.Scene.Render.Height);
        FrameInfo info = new(width, height, _plan.Samples, isPreview, _plan.IsDone && !NeedsDenoising(wanted), wanted.Settings.Map.IsLight);
        _pace.Make(() => frames.Publish(info, draw));
    }
}
