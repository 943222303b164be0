using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Acceleration;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Splits the light of the paths of a tile into layers, by what is added to each path and where it comes from; when the path ends, each
/// layer's sum goes to its film.
/// </summary>
internal sealed unsafe class LightContributions : PathObserver
{
    // Of a path: its vertices so far, the matt share of its first vertex (channel by channel), whether that is in a medium, and then the
    // layers' sums.
    private const int Vertices = 0;
    private const int Matt = 1;
    private const int InMedium = 4;
    private const int Sums = 5;
    private readonly LightPathAovFilm _film;
    private readonly EmitterLookup _lights;
    private readonly int _width;
    private readonly int _sky;
    private readonly int _ambient;
    private readonly int _media;
    private readonly int[] _layerOfLight;
    private readonly List<Share> _waiting = [];
    private PinnedBuffer<float> _numbers = new(0);
    private long _room;
    private Tile _tile;
    private readonly long _pictureWidth;

    // Of the packet that is shaded: the paths, what light of their vertices is multiplied by, and how much of the light that is asked for
    // is matt.
    private UIntW _path;
    private bool _hasFirst;
    private RgbW _weight;
    private RgbW _matt;

    public LightContributions(Scene scene, LightPathAovFilm film)
    {
        _film = film;
        _lights = new(scene);
        _layerOfLight = [.. Enumerable.Range(-1, _lights.Count + 1).Select(light => LightPathAovFilm.FirstLight + film.Groups.Of(light))];
        _sky = LightPathAovFilm.FirstLight + film.Groups.Sky;
        _ambient = LightPathAovFilm.FirstLight + film.Groups.Ambient;
        _media = LightPathAovFilm.FirstLight + film.Groups.Media;
        Layers = LightPathAovFilm.FirstLight + film.Groups.Names.Count;
        _width = Sums + (3 * Layers);
        _pictureWidth = scene.Render.Width;
    }

    private int Layers { get; }

    /// <inheritdoc/>
    public override void Begin(in Tile tile, SampleRange samples)
    {
        _tile = tile;
        _film.Begin(tile);
        _waiting.Clear();
        long needed = (long)tile.Pixels * samples.Count * _width;
        if (needed > _room)
        {
            _numbers = new(needed);
            _room = needed;
        }

        NativeMemory.Clear(_numbers.Pointer, (nuint)needed * sizeof(float));
    }

    /// <inheritdoc/>
    public override void BeginPacket(PathStream stream, uint* index, in MaskW lanes)
    {
        _path = UIntW.Pick(stream.Path, index);
        _hasFirst = false;
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            _hasFirst |= Of(_path[lane])[Vertices] == 0;
        }
    }

    /// <inheritdoc/>
    public override void Emitted(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance)
    {
        UIntW instance = group.IsInstanced ? UIntW.Pick(stream.Instance, index) : 0u;
        UIntW primitive = UIntW.Pick(stream.Primitive, index);
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            Rgb part = Lane(light, lane);
            if (!part.IsBlack)
            {
                AddArrived(_path[lane], _layerOfLight[_lights.Find(group, instance[lane], primitive[lane]) + 1], part);
            }
        }
    }

    /// <inheritdoc/>
    public override void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
        UIntW path = UIntW.Pick(stream.Path, index);
        RgbW light = stream.PickThroughput(index) * arriving;
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            Rgb part = Lane(light, lane);
            if (!part.IsBlack && _sky >= LightPathAovFilm.FirstLight)
            {
                AddArrived(path[lane], _sky, part);
            }
        }
    }

    /// <inheritdoc/>
    public override void Shone(uint path, Rgb light) => AddArrived(path, _media, light);

    /// <inheritdoc/>
    public override void Brightened(PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance)
    {
        // Ambient light stands in for light that comes by many ways, and what it meets first counts as matt.
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            float* numbers = Of(_path[lane]);
            Rgb part = Lane(light, lane);
            Rgb matt = numbers[Vertices] == 0 ? Rgb.White : FirstMatt(numbers);
            Add(numbers, _ambient, LightPathAov.Indirect, part, matt, numbers[InMedium] > 0);
        }
    }

    /// <inheritdoc/>
    public override void BeginLights(in RgbW weight)
    {
        _weight = weight;
        _matt = Rgb.White;
    }

    /// <inheritdoc/>
    public override void Split(in SurfaceW surface, Material material, in Vec3W direction, in RgbW bsdf)
    {
        if (_hasFirst)
        {
            material.DiffuseBsdf(surface, direction, out RgbW matt);
            _matt = Ratio(matt, bsdf);
        }
    }

    /// <inheritdoc/>
    public override void Lit(int light, in MaskW lanes, in RgbW radiance, bool isWaiting)
    {
        RgbW all = _weight * radiance;
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            float* numbers = Of(_path[lane]);
            bool isFirst = numbers[Vertices] == 0;
            Share share = new(
                _path[lane],
                _layerOfLight[light + 1],
                isFirst ? LightPathAov.Direct : LightPathAov.Indirect,
                Lane(all, lane),
                isFirst ? Lane(_matt, lane) : FirstMatt(numbers));
            if (isWaiting)
            {
                _waiting.Add(share);
            }
            else
            {
                Add(share);
            }
        }
    }

    /// <inheritdoc/>
    public override void LitInMedium(int light, in MaskW lanes, in RgbW radiance)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            float* numbers = Of(_path[lane]);
            bool isFirst = numbers[Vertices] == 0;
            LightPathAov kind = isFirst ? LightPathAov.Direct : LightPathAov.Indirect;
            Add(numbers, _layerOfLight[light + 1], kind, Lane(radiance, lane), FirstMatt(numbers), isFirst || numbers[InMedium] > 0);
        }
    }

    /// <inheritdoc/>
    public override void Settle(int* hits)
    {
        for (int i = 0; i < _waiting.Count; i++)
        {
            if (hits[i] < 0)
            {
                Add(_waiting[i]);
            }
        }

        _waiting.Clear();
    }

    /// <inheritdoc/>
    public override void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter,
        bool isByLobe)
    {
        MaskW straight = scatter.Delta & (scatter.Direction.X >= surface.Incoming.X) & (scatter.Direction.X <= surface.Incoming.X)
            & (scatter.Direction.Y >= surface.Incoming.Y) & (scatter.Direction.Y <= surface.Incoming.Y)
            & (scatter.Direction.Z >= surface.Incoming.Z) & (scatter.Direction.Z <= surface.Incoming.Z);
        RgbW share = default;
        bool isKnown = false;
        for (uint rest = alive.Except(straight).Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            float* numbers = Of(_path[lane]);
            if (numbers[Vertices]++ == 0)
            {
                if (!isKnown)
                {
                    share = MattShare(surface, material, scatter, isByLobe);
                    isKnown = true;
                }

                (numbers[Matt], numbers[Matt + 1], numbers[Matt + 2]) = Lane(share, lane);
            }
        }
    }

    /// <inheritdoc/>
    public override void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf)
    {
        for (uint rest = alive.Bits; rest != 0; rest &= rest - 1)
        {
            float* numbers = Of(_path[BitOperations.TrailingZeroCount(rest)]);
            if (numbers[Vertices]++ == 0)
            {
                numbers[InMedium] = 1;
            }
        }
    }

    /// <inheritdoc/>
    public override void Finish(uint path, int pixel, Rgb radiance, Rgb sample)
    {
        if (!float.IsFinite(sample.R) || !float.IsFinite(sample.G) || !float.IsFinite(sample.B))
        {
            return;
        }

        (int x, int y) = _tile.Pixel(pixel);
        long place = (y * _pictureWidth) + x;
        float* sums = Of(path) + Sums;
        long* units = stackalloc long[Layers];
        FinishChannel(sums, radiance.R, sample.R, units, place, 0);
        FinishChannel(sums, radiance.G, sample.G, units, place, 1);
        FinishChannel(sums, radiance.B, sample.B, units, place, 2);
    }

    private static Rgb Lane(in RgbW color, int lane) => new(color.R[lane], color.G[lane], color.B[lane]);

    private static Rgb FirstMatt(float* numbers) => new(numbers[Matt], numbers[Matt + 1], numbers[Matt + 2]);

    private static FloatW Ratio(FloatW part, FloatW whole) => (whole > 0f).Select(FloatW.Max(0f, FloatW.Min(part / whole, 1f)), 0f);

    private static RgbW Ratio(in RgbW part, in RgbW whole) => new(Ratio(part.R, whole.R), Ratio(part.G, whole.G), Ratio(part.B, whole.B));

    // How much of the light along the next ray the matt part scatters. Where a lobe is chosen that lights are not asked for, only its own
    // share counts.
    private static RgbW MattShare(in SurfaceW surface, Material material, in ScatterW scatter, bool isByLobe)
    {
        material.Bsdf(surface, scatter.Direction, out RgbW bsdf);
        material.DiffuseBsdf(surface, scatter.Direction, out RgbW matt);
        if (!isByLobe)
        {
            return scatter.Delta.Select(default, Ratio(matt, bsdf));
        }

        material.Brdf(surface, out RgbW asked);
        asked = (Vec3W.Dot(scatter.Direction, surface.Facing) > 0f).Select(asked, default) * -1f;
        return scatter.Specular.Select(scatter.Delta.Select(default, Ratio(matt + asked, bsdf + asked)), Rgb.White);
    }

    private float* Of(uint path) => _numbers.Pointer + ((long)path * _width);

    private void Add(in Share share)
    {
        float* numbers = Of(share.Path);
        Add(numbers, share.Layer, share.Kind, share.Light, share.Matt, numbers[InMedium] > 0);
    }

    // Light that a path has met.
    private void AddArrived(uint path, int layer, Rgb light)
    {
        float* numbers = Of(path);
        LightPathAov kind = numbers[Vertices] switch { 0 => LightPathAov.Emission, 1 => LightPathAov.Direct, _ => LightPathAov.Indirect };
        Add(numbers, layer, kind, light, FirstMatt(numbers), numbers[InMedium] > 0);
    }

    private static void Add(float* numbers, int layer, LightPathAov kind, Rgb light, Rgb matt, bool inMedium)
    {
        float* sums = numbers + Sums;
        Add(sums, layer, light);
        Add(sums, (int)kind, light);
        if (kind == LightPathAov.Emission)
        {
            return;
        }

        if (inMedium)
        {
            Add(sums, (int)LightPathAov.Volume, light);
            return;
        }

        Add(sums, (int)LightPathAov.Diffuse, light * matt);
        Add(sums, (int)LightPathAov.Specular, light * (Rgb.White + (matt * -1)));
    }

    private static void Add(float* sums, int layer, Rgb light)
    {
        sums[3 * layer] += light.R;
        sums[(3 * layer) + 1] += light.G;
        sums[(3 * layer) + 2] += light.B;
    }

    private void FinishChannel(float* sums, float gathered, float sample, long* units, long pixel, int channel)
    {
        float clamped = float.Clamp(sample, -Film.SampleLimit, Film.SampleLimit);
        long total = ToUnits(clamped);
        double scale = gathered == 0 ? 0 : (double)clamped / gathered;
        for (int i = 0; i < Layers; i++)
        {
            units[i] = ToUnits(sums[(3 * i) + channel] * scale);
        }

        if ((units[(int)LightPathAov.Direct] | units[(int)LightPathAov.Indirect]) == 0)
        {
            units[(int)LightPathAov.Emission] = total;
        }

        long scattered = total - units[(int)LightPathAov.Emission];
        Balance(units, (int)LightPathAov.Direct, (int)LightPathAov.Indirect, scattered);
        Balance(units, (int)LightPathAov.Diffuse, (int)LightPathAov.Volume, scattered);
        Balance(units, LightPathAovFilm.FirstLight, Layers - 1, total);
        for (int i = 0; i < Layers; i++)
        {
            _film.Add(i, pixel, channel, units[i]);
        }
    }

    // What rounding leaves goes to the largest, the first of equals.
    private static void Balance(long* units, int first, int last, long total)
    {
        if (first > last)
        {
            return;
        }

        int largest = first;
        for (int i = first; i <= last; i++)
        {
            total -= units[i];
            largest = long.Abs(units[i]) > long.Abs(units[largest]) ? i : largest;
        }

        units[largest] += total;
    }

    private static long ToUnits(double light) =>
        double.IsNaN(light) ? 0 : (long)double.Round(double.Clamp(light, -Film.SampleLimit, Film.SampleLimit) * Film.ChannelUnits);

    /// <summary>Light that is added to a path.</summary>
    /// <param name="Path">The path's number in the tile.</param>
    /// <param name="Layer">The source's layer.</param>
    /// <param name="Kind">Direct or indirect.</param>
    /// <param name="Light">The light.</param>
    /// <param name="Matt">The matt share of the vertex nearest to the camera.</param>
    private readonly record struct Share(uint Path, int Layer, LightPathAov Kind, Rgb Light, Rgb Matt);
}
