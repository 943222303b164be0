using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>Starts paths.</summary>
internal abstract unsafe class PathSource
{
    /// <summary>Keys of the random numbers of the paths' pixels, by their number in the tile.</summary>
    public abstract uint* PixelKeys { get; }

    /// <summary>The pixels' numbers in the picture, row by row, by their number in the tile.</summary>
    public abstract uint* PixelNumbers { get; }

    /// <summary>The number of paths.</summary>
    public abstract int Total { get; }

    /// <summary>The rays of the pixels, where samples share them (<see cref="Splitting"/>); null where each new path is that of a sample.</summary>
    public virtual SampleRange? Rays => null;

    /// <summary>Adds new paths to a stream, as long as there are any.</summary>
    /// <param name="stream">The stream.</param>
    /// <param name="room">How many paths it may have then.</param>
    public abstract void Fill(PathStream stream, int room);
}

/// <summary>Starts the paths of a tile: pixel by pixel, all samples of a pixel in a row.</summary>
/// <param name="scene">The scene.</param>
/// <param name="maxPixels">The most pixels of a tile.</param>
/// <param name="splits">True if samples that share a ray are followed together up to what it meets.</param>
internal sealed unsafe class RayGenerator(Scene scene, int maxPixels, bool splits = false) : PathSource
{
    private readonly PinnedBuffer<float> _x = new(maxPixels);
    private readonly PinnedBuffer<float> _y = new(maxPixels);
    private readonly PinnedBuffer<uint> _key = new(maxPixels);
    private readonly PinnedBuffer<uint> _number = new(maxPixels);
    private readonly PinnedBuffer<StartW> _start = new(1);
    private readonly Splitting? _splitting = splits ? scene.Splitting : null;
    private SampleRange _samples;
    private SampleRange? _rays;
    private int _issued;
    private int _total;

    /// <inheritdoc/>
    public override SampleRange? Rays => _rays;

    /// <inheritdoc/>
    public override uint* PixelKeys => _key.Pointer;

    /// <inheritdoc/>
    public override uint* PixelNumbers => _number.Pointer;

    /// <inheritdoc/>
    public override int Total => _total;

    /// <summary>Prepares for a tile.</summary>
    public void Begin(in Tile tile, SampleRange samples)
    {
        Begin(tile.Pixels, samples);
        uint seed = (uint)scene.Render.Seed;
        for (int row = 0, i = 0; row < tile.Height; row++, i += tile.Width)
        {
            (int y, uint first) = (tile.Y + row, (uint)(((tile.Y + row) * scene.Render.Width) + tile.X));
            for (int x = 0; x < tile.Width; x += FloatW.Count)
            {
                // What is written beside a row belongs to the next.
                UIntW number = UIntW.Iota + (first + (uint)x);
                (FloatW.Iota + (tile.X + x)).Store(_x.Pointer + i + x);
                ((FloatW)y).Store(_y.Pointer + i + x);
                number.Store(_number.Pointer + i + x);
                Hash.PixelKey(seed, number).Store(_key.Pointer + i + x);
            }
        }
    }

    /// <summary>Prepares for single pixels.</summary>
    /// <param name="pixels">Their numbers in the picture, row by row.</param>
    /// <param name="samples">Which samples of each.</param>
    /// <param name="seed">Selects the random numbers, in the place of the scene's seed.</param>
    public void Begin(ReadOnlySpan<int> pixels, SampleRange samples, uint seed)
    {
        Begin(pixels.Length, samples);
        for (int i = 0; i < pixels.Length; i++)
        {
            (int y, int x) = int.DivRem(pixels[i], scene.Render.Width);
            _x.Pointer[i] = x;
            _y.Pointer[i] = y;
            _number.Pointer[i] = (uint)pixels[i];
            _key.Pointer[i] = Hash.PixelKey(seed, (uint)pixels[i]);
        }
    }

    /// <inheritdoc/>
    public override void Fill(PathStream stream, int room)
    {
        ref StartW start = ref *_start.Pointer;
        start.Throughput = Rgb.White;
        start.State = PathState.CountsEmission;
        Sampler sampler = scene.Splitting?.Sampler ?? scene.Sampler;
        while (_issued < _total && stream.Count < room)
        {
            int count = Math.Min(Math.Min(FloatW.Count, _total - _issued), room - stream.Count);
            start.Path = UIntW.Iota + (uint)_issued;
            PathNumber.Split(start.Path, _rays ?? _samples, out UIntW pixel, out start.Sample);
            pixel = MaskW.First(count).Select(pixel, 0u);
            start.Key = UIntW.Gather(_key.Pointer, pixel);
            if (_rays is null && scene.Splitting is not null)
            {
                start.Sample = scene.Splitting.RayOf(start.Sample);
            }

            sampler.Begin(start.Key, start.Sample, Dimensions.Pixel, out start.Points);
            sampler.Pair(start.Points, 0, out start.X, out start.Y);
            scene.Filter?.Place(ref start.X, ref start.Y);
            scene.Camera.GenerateRays(
                FloatW.Gather(_x.Pointer, pixel) + start.X, FloatW.Gather(_y.Pointer, pixel) + start.Y, sampler, start.Key, start.Sample, out start.Origin, out start.Direction);
            uint lanes = MaskW.First(count).Bits;
            if (scene.IsTimed || scene.Camera.IsPlaced)
            {
                Place(stream, lanes, start.Key, start.Sample, ref start.Origin, ref start.Direction);
            }

            if (scene.TracksInteriors)
            {
                stream.SetMedia(lanes, scene.CameraInteriors, 0f);
            }

            stream.Append(lanes, start.Origin, start.Direction, start.Throughput, start.Radiance, start.Path, start.State);
            _issued += count;
        }
    }

    /// <summary>
    /// Returns the weights that the pixel filter gives the radiance of samples; ask only where it <see cref="PixelFilter.HasWeights"/>.
    /// </summary>
    /// <param name="scene">The scene.</param>
    /// <param name="key">Keys of the pixels.</param>
    /// <param name="sample">Numbers of the samples.</param>
    public static FloatW Weight(Scene scene, in UIntW key, in UIntW sample)
    {
        Sampler sampler = scene.Splitting?.Sampler ?? scene.Sampler;
        sampler.Begin(key, scene.Splitting is { } splitting ? splitting.RayOf(sample) : sample, Dimensions.Pixel, out SamplePoints points);
        sampler.Pair(points, 0, out FloatW u, out FloatW v);
        return scene.Filter!.Weight(u, v);
    }

    private void Begin(int pixels, SampleRange samples)
    {
        _samples = samples;
        _rays = _splitting is null ? null : new(_splitting.RayOf(samples.First), _splitting.RayOf(samples.End - 1) + 1);
        _issued = 0;
        _total = pixels * (_rays ?? samples).Count;
    }

    // Gives paths their times, and takes the camera to where it is then.
    private void Place(PathStream stream, uint lanes, in UIntW key, in UIntW sample, ref Vec3W origin, ref Vec3W direction)
    {
        FloatW time = scene.Render.Shutter.X;
        if (scene.IsTimed)
        {
            time = scene.Time(key, sample);
            stream.SetTime(lanes, time);
        }

        if (scene.Camera.IsPlaced)
        {
            scene.Camera.Place(time, ref origin, ref direction);
        }
    }

    // How paths start; the radiance stays black.
    private struct StartW
    {
        public UIntW Path;
        public UIntW Sample;
        public UIntW Key;
        public SamplePoints Points;
        public FloatW X, Y;
        public Vec3W Origin;
        public Vec3W Direction;
        public RgbW Throughput;
        public RgbW Radiance;
        public UIntW State;
    }
}

/// <summary>A path's number in its tile: pixel · samples + sample.</summary>
internal static class PathNumber
{
    /// <summary>Finds pixel (in the tile) and sample (in the picture) of a path.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Split(UIntW path, SampleRange samples, out UIntW pixel, out UIntW sample)
    {
        // Numbers stay below 2²³, so the half keeps rounding from crossing a whole number.
        pixel = ((path.ToFloat() + 0.5f) * (1f / samples.Count)).ToIntInRange();
        sample = path - (pixel * (uint)samples.Count) + (uint)samples.First;
    }
}
