using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>
/// The pictures while something moves: few samples, with what the pictures before have gathered, and filtered. The film knows nothing of it. All on the
/// render loop's thread; its memory is used again.
/// </summary>
internal sealed unsafe class MovingView
{
    /// <summary>The fewest samples of a picture, where the picture has as many pixels.</summary>
    public const int LeastSamples = 400 * 300;

    // After an edit the light may be other everywhere: so many pictures before it count.
    private const float AfterEdit = 3;

    // A square, as jittered samples need; after so many pictures they come again.
    private const int Samples = 1024;
    private const float DarkestAlbedo = 0.04f;

    // Samples lie where pixels have their middles: elsewhere, edges would be ragged.
    private static readonly FilterDescription s_middle = new() { Radius = 0.01f };
    private static readonly int[] s_steps = [1, 3];
    private readonly MovingThings _things = new();
    private readonly LightLayers _lights = new();
    private readonly LinearPicture _mixed = new();
    private MovingHistory[] _histories = [];
    private MovingPlanes[] _planes = [];
    private Film? _film;
    private object? _factors;
    private MovingCamera? _camera;
    private MovingCamera? _before;
    private MovingHistory _now = null!;
    private int _pictures;

    /// <summary>Processor time of the last picture's parts, for measurements: tracing and filter.</summary>
    public (TimeSpan Tracing, TimeSpan Filter) Cost { get; private set; }

    /// <summary>The size of the pictures for one of a size: as many samples as are wanted, and no more than pixels.</summary>
    public static (int Width, int Height) SizeFor(int width, int height)
    {
        int scale = 1;
        while ((long)(width / (scale + 1)) * (height / (scale + 1)) >= LeastSamples)
        {
            scale++;
        }

        return (Math.Max(1, width / scale), Math.Max(1, height / scale));
    }

    private void Forget() => _before = _camera = null;

    /// <summary>Makes the next picture.</summary>
    /// <param name="wanted">The scene.</param>
    /// <param name="to">Takes it, with the size of <see cref="SizeFor"/>.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <returns>False if it was cancelled.</returns>
    public bool Next(ViewportScene wanted, LinearPicture to, CancellationToken cancellation)
    {
        TimeSpan start = Environment.CpuUsage.TotalTime;
        RenderDescription render = wanted.Scene.Render;
        (int width, int height) = SizeFor(render.Width, render.Height);
        Prepare(width, height);
        SceneChange change = _things.Turn(wanted);
        if (change == SceneChange.Other)
        {
            Forget();
        }

        if (!Trace(wanted, width, height, _pictures % Samples, cancellation))
        {
            return false;
        }

        TimeSpan traced = Environment.CpuUsage.TotalTime;
        bool isOtherLight = change == SceneChange.Edited || !ReferenceEquals(_factors, wanted.Settings.LightFactors);
        _factors = wanted.Settings.LightFactors;
        MovingPlanes light = Filter(wanted, isOtherLight ? AfterEdit : float.PositiveInfinity);
        Write(light, to);
        _pictures++;
        Cost = (traced - start, Environment.CpuUsage.TotalTime - traced);
        return true;
    }

    private void Prepare(int width, int height)
    {
        PaddedRows rows = new(width, height);
        if (_planes is [{ Rows: var before }, ..] && before == rows)
        {
            return;
        }

        _planes = [new(rows), new(rows)];
        _histories = [new(rows), new(rows)];
        Forget();
    }

    // Light from the lamps takes more samples than there are.
    private static Integrator Traced(RenderDescription render) => render.Integrator.Has(IntegratorTraits.TracesLight) ? Integrator.Path : render.Integrator;

    private bool Trace(ViewportScene wanted, int width, int height, int sample, CancellationToken cancellation)
    {
        RenderDescription render = wanted.Scene.Render with { Width = width, Height = height, SamplesPerPixel = Samples, Splitting = 1, Filter = s_middle, Integrator = Traced(wanted.Scene.Render) };
        Scene scene = wanted.Scene.WithView(wanted.Camera, render, new((_, _) => new(1, 1))) ?? throw new InvalidOperationException("The moving view cannot be rendered.");
        _now = _histories[_pictures % 2];
        SeenPlanes seen = _now.Guides.Seen;
        if (!new SeenPass(scene, wanted.Settings.Threads).Take(seen, sample, cancellation) || !Mix(wanted with { Scene = scene }, seen, sample, cancellation))
        {
            return false;
        }

        (_before, _camera) = (_camera, CameraOf(wanted, width, height));
        seen.Eye = _camera?.Eye ?? wanted.Camera.Position;
        return true;
    }

    // While the mixer has factors on lights, the light is that of a film of the same sample, which keeps lights apart. False if it was cancelled.
    private bool Mix(ViewportScene wanted, SeenPlanes seen, int sample, CancellationToken cancellation)
    {
        if (wanted.Settings.LightFactors is not { Count: > 0 })
        {
            _film = null;
            return true;
        }

        (int width, int height) = (seen.Rows.Width, seen.Rows.Height);
        _film = _film is { } before && (before.Width, before.Height) == (width, height) ? before : new(width, height);
        _film.Clear();
        _lights.Begin(wanted, _film);
        RenderOptions options = new() { Threads = wanted.Settings.Threads, Samples = new(sample, sample + 1), Layers = _lights.Film };
        if (new RTracer(wanted.Scene, options).Render(_film, null, cancellation).Cancelled)
        {
            return false;
        }

        _mixed.CopyFrom(_film);
        _lights.Paint(wanted, _mixed);
        for (int y = 0; y < height; y++)
        {
            Span<float> row = _mixed.Row(y);
            for (int x = 0; x < width; x++)
            {
                seen.TakeLight(seen.Rows.At(x, y), row[3 * x], row[(3 * x) + 1], row[(3 * x) + 2]);
            }
        }

        return true;
    }

    // Where the picture is bent, or something else moves the camera, nothing is carried over.
    private static MovingCamera? CameraOf(ViewportScene wanted, int width, int height) =>
        wanted.Camera.Projection.IsStraight && !wanted.Scene.Camera.IsPlaced ? new(CameraFrame.Of(wanted), width, height) : null;

    private MovingPlanes Filter(ViewportScene wanted, float most)
    {
        int threads = wanted.Settings.Threads;
        (MovingPlanes light, MovingPlanes other) = (_planes[0], _planes[1]);
        MovingRows.ForEach(light.Rows.Height, threads, y => Divide(wanted, light, y));
        MovingHistory before = _histories[(_pictures + 1) % 2];
        EarlierPlace where = new(_before, _camera, _things.Moves());
        MovingRows.ForEach((light.Rows.Height + MovingHistory.Block - 1) / MovingHistory.Block, threads, block => _now.Mix(before, light, where, block, most));
        foreach (int step in s_steps)
        {
            EdgeFilter.Smooth(light, _now.Guides, step, other, threads);
            (light, other) = (other, light);
            if (step == s_steps[0])
            {
                _now.Keep(light);
            }
        }

        return light;
    }

    // Light without the colours of the things, and what the filter goes by.
    private void Divide(ViewportScene wanted, MovingPlanes light, int y)
    {
        MovingGuides guides = _now.Guides;
        (SeenPlanes seen, int start) = (guides.Seen, light.Rows.At(0, y));
        for (int at = start; at < start + light.Rows.Width; at++)
        {
            guides.Things[at] = (uint)_things.Of(wanted, seen.Surface[at]);
        }

        for (int at = start; at < start + light.Rows.Width; at += FloatW.Count)
        {
            (Vec3W color, Vec3W albedo, Vec3W away) = (seen.Light(at), seen.Albedo(at), seen.Point(at) - seen.Eye);
            light[at] = new(color.X / FloatW.Max(albedo.X, DarkestAlbedo), color.Y / FloatW.Max(albedo.Y, DarkestAlbedo), color.Z / FloatW.Max(albedo.Z, DarkestAlbedo));
            new FloatW(Vector.Log2((Vec3W.Dot(away, away) + 1e-12f).V) * 0.5f).Store(guides.Depth + at);
        }
    }

    private void Write(MovingPlanes light, LinearPicture to)
    {
        PaddedRows rows = light.Rows;
        to.Resize(rows.Width, rows.Height);
        float* own = stackalloc float[3 * FloatW.Count];
        for (int y = 0; y < rows.Height; y++)
        {
            Span<float> row = to.Row(y);
            for (int x = 0; x < rows.Width; x += FloatW.Count)
            {
                int at = rows.At(x, y);
                (RgbW color, Vec3W albedo) = (light[at], _now.Guides.Seen.Albedo(at));
                (color.R * FloatW.Max(albedo.X, DarkestAlbedo)).Store(own);
                (color.G * FloatW.Max(albedo.Y, DarkestAlbedo)).Store(own + FloatW.Count);
                (color.B * FloatW.Max(albedo.Z, DarkestAlbedo)).Store(own + (2 * FloatW.Count));
                for (int lane = 0; lane < Math.Min(FloatW.Count, rows.Width - x); lane++)
                {
                    (row[3 * (x + lane)], row[(3 * (x + lane)) + 1], row[(3 * (x + lane)) + 2]) = (own[lane], own[FloatW.Count + lane], own[(2 * FloatW.Count) + lane]);
                }
            }
        }
    }
}
