using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Puts the light of paths, one of each pixel, into planes, with what they see first: that need not be traced again, unless it is a mirror or clear glass. Each
/// thread has its own.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="planes">The planes; no other thread may use the pixels of its tiles.</param>
/// <param name="beyond">Knows what is seen through.</param>
internal sealed unsafe class SeenByPaths(Scene scene, SeenPlanes planes, SeenThrough beyond) : PathObserver
{
    // Of a path, whose number is that of its pixel in the tile.
    private const byte Unknown = 0;
    private const byte Seen = 1;
    private const byte SeesBeyond = 2;
    private readonly List<int> _rest = [];
    private byte[] _paths = [];
    private int[] _places = [];
    private Tile _tile;

    /// <inheritdoc/>
    public override bool SeesLights => false;

    /// <summary>Returns the numbers of the tile's pixels in the picture of which more is to be traced.</summary>
    public ReadOnlySpan<int> FindRest()
    {
        _rest.Clear();
        for (int path = 0; path < _tile.Pixels; path++)
        {
            if (_paths[path] != Seen)
            {
                (int x, int y) = _tile.Pixel(path);
                _rest.Add((y * planes.Rows.Width) + x);
            }
        }

        return CollectionsMarshal.AsSpan(_rest);
    }

    /// <inheritdoc/>
    public override void Begin(in Tile tile, SampleRange samples)
    {
        _tile = tile;
        Array.Resize(ref _paths, Math.Max(_paths.Length, tile.Pixels));
        Array.Resize(ref _places, _paths.Length);
        Array.Clear(_paths);
        for (int y = 0; y < tile.Height; y++)
        {
            Span<int> row = _places.AsSpan(y * tile.Width, tile.Width);
            int first = planes.Rows.At(tile.X, tile.Y + y);
            for (int x = 0; x < row.Length; x++)
            {
                row[x] = first + x;
            }
        }
    }

    /// <inheritdoc/>
    public override void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter, bool isByLobe)
    {
        uint first = New(stream, index, active);
        if (first == 0)
        {
            return;
        }

        uint clear = material.Traits.Specular == SpecularLobe.None ? 0 : beyond.IsClear(material, surface, out _).Bits & first;
        Mark(stream, index, clear, SeesBeyond);
        uint opaque = first & ~clear;
        if (opaque == 0)
        {
            return;
        }

        material.Albedo(surface, out RgbW albedo);
        float* seen = stackalloc float[SeenPlanes.Kinds * FloatW.Count];
        SeenPlanes.Put(surface.Point, surface.Facing, albedo, seen);
        uint* places = stackalloc uint[FloatW.Count];
        for (uint rest = opaque; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            int ray = (int)index[lane];
            places[lane] = (uint)Mark(stream, ray, Seen);
            planes.Surface[places[lane]] = SeenPlanes.SurfaceOf(scene, stream, ray);
        }

        planes.Take(places, seen, opaque);
    }

    /// <inheritdoc/>
    public override void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf) =>
        Mark(stream, index, New(stream, index, active), SeesBeyond);

    /// <inheritdoc/>
    public override void Crossed(PathStream stream, uint* index, in MaskW active, in SurfaceW surface) =>
        Mark(stream, index, New(stream, index, active), SeesBeyond);

    /// <inheritdoc/>
    public override void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
        for (uint rest = New(stream, index, lanes); rest != 0; rest &= rest - 1)
        {
            int ray = (int)index[BitOperations.TrailingZeroCount(rest)];
            planes.TakeNothing(
                Mark(stream, ray, Seen), new(stream.OriginX[ray], stream.OriginY[ray], stream.OriginZ[ray]),
                new(stream.DirectionX[ray], stream.DirectionY[ray], stream.DirectionZ[ray]));
        }
    }

    /// <inheritdoc/>
    public override void EndStep(FinishedPaths finished, PathStream next)
    {
        // Of a single sample, the weight of a pixel filter would only be noise.
        float* first = finished.Radiance;
        int stride = finished.Stride;
        float* light = stackalloc float[3 * FloatW.Count];
        for (int i = 0; i < finished.Count; i += FloatW.Count)
        {
            (FloatW red, FloatW green, FloatW blue) = (FloatW.Load(first + i), FloatW.Load(first + stride + i), FloatW.Load(first + (2 * stride) + i));
            MaskW isFinite = FloatW.Abs(red + green + blue) < float.PositiveInfinity;
            isFinite.Select(SampleAccumulator.Clamp(red), 0f).Store(light);
            isFinite.Select(SampleAccumulator.Clamp(green), 0f).Store(light + FloatW.Count);
            isFinite.Select(SampleAccumulator.Clamp(blue), 0f).Store(light + (2 * FloatW.Count));
            for (int lane = 0; lane < Math.Min(FloatW.Count, finished.Count - i); lane++)
            {
                planes.TakeLight(_places[finished.Path[i + lane]], light[lane], light[FloatW.Count + lane], light[(2 * FloatW.Count) + lane]);
            }
        }

        finished.Clear();
    }

    // The lanes whose paths have met nothing so far.
    private uint New(PathStream stream, uint* index, in MaskW lanes)
    {
        uint first = 0;
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            first |= _paths[stream.Path[index[lane]]] == Unknown ? 1u << lane : 0;
        }

        return first;
    }

    private void Mark(PathStream stream, uint* index, uint lanes, byte state)
    {
        for (uint rest = lanes; rest != 0; rest &= rest - 1)
        {
            Mark(stream, (int)index[BitOperations.TrailingZeroCount(rest)], state);
        }
    }

    // Returns the place of the pixel.
    private int Mark(PathStream stream, int ray, byte state)
    {
        uint path = stream.Path[ray];
        _paths[path] = state;
        return _places[path];
    }
}
