using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Cameras;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Traces the camera rays of tiles, and adds what they meet first to auxiliary images. Each thread has its own.</summary>
internal sealed unsafe class FirstHits
{
    private readonly Scene _scene;
    private readonly RayGenerator _generator;
    private readonly PathStream _rays;
    private readonly GroupMembers _members;
    private readonly PinnedBuffer<int> _hits;
    private readonly long[] _costs;
    private AovFilm _film = null!;
    private Tile _tile;
    private SampleRange _samples;

    public FirstHits(Scene scene, int streamSize, int maxTilePixels)
    {
        _scene = scene;
        _rays = new(streamSize);
        _generator = new(scene, maxTilePixels);
        _members = new(scene, streamSize);
        _hits = new(scene.World.RoomForHits(streamSize));
        _costs = new long[_rays.Capacity];
    }

    /// <summary>Adds some samples of every pixel of a tile.</summary>
    /// <param name="film">The images; no other thread may use the tile's pixels.</param>
    /// <param name="tile">The pixels.</param>
    /// <param name="samples">The samples, at most <see cref="SampleAccumulator.MaxSamples"/>.</param>
    public void Add(AovFilm film, in Tile tile, SampleRange samples)
    {
        (_film, _tile, _samples) = (film, tile, samples);
        _generator.Begin(tile, samples);
        while (true)
        {
            _rays.Count = 0;
            _generator.Fill(_rays, _rays.Capacity);
            if (_rays.Count == 0)
            {
                return;
            }

            if (film.Needs.HasFlag(FirstHitParts.Cost))
            {
                FindCosts();
            }

            _scene.World.ClosestHit(_rays, _hits.Pointer);
            AddRays();
            if (film.Needs.HasFlag(FirstHitParts.Surface))
            {
                AddSurfaces();
            }
        }
    }

    private void FindCosts()
    {
        for (int i = 0; i < _rays.Count; i++)
        {
            _costs[i] = _scene.World.Cost(_rays.Ray(i), _scene.IsTimed ? _rays.Time[i] : 0);
        }
    }

    private void AddRays()
    {
        for (int i = 0; i < _rays.Count; i++)
        {
            FirstHit hit = Hit(i, out long pixel);
            _film.Count(pixel, hit.Primitive > 0);
            _film.Add(pixel, hit, isDescribed: false);
        }
    }

    private void AddSurfaces()
    {
        _members.Sort(_rays);
        for (int group = 0; group < _scene.Groups.Length; group++)
        {
            uint* members = _members.Of(group, out int count);
            for (int i = 0; i < count; i += FloatW.Count)
            {
                AddPacket(_scene.Groups[group], members + i, Math.Min(FloatW.Count, count - i));
            }
        }
    }

    private void AddPacket(ShadingGroup group, uint* index, int count)
    {
        bool usesUv = group.Traits.UsesUv || _film.Needs.HasFlag(FirstHitParts.Uv);
        SurfaceShader.Describe(_scene, group, _rays, index, usesUv, out SurfaceW surface);
        group.Material.Albedo(surface, out RgbW albedo);
        (FloatW right, FloatW down) = (0f, 0f);
        if (_film.Needs.HasFlag(FirstHitParts.Motion) && _scene.Camera.CanLink)
        {
            FindMotion(group, index, count, surface, out right, out down);
        }

        for (int lane = 0; lane < count; lane++)
        {
            FirstHit hit = Hit((int)index[lane], out long pixel) with
            {
                Point = At(surface.Point, lane),
                Normal = At(surface.Facing, lane),
                Albedo = new(albedo.R[lane], albedo.G[lane], albedo.B[lane]),
                Uv = new(surface.U[lane], surface.V[lane]),
                Motion = new(right[lane], down[lane]),
            };
            _film.Add(pixel, hit, isDescribed: true);
        }
    }

    // The same point of the surface, seen through the same point of the lens, when the shutter opens and when it closes.
    private void FindMotion(ShadingGroup group, uint* index, int count, in SurfaceW surface, out FloatW right, out FloatW down)
    {
        PathNumber.Split(MaskW.First(count).Select(UIntW.Pick(_rays.Path, index), 0u), _samples, out UIntW pixel, out UIntW sample);
        UIntW key = UIntW.Gather(_generator.PixelKeys, pixel);
        See(group, surface, _scene.Render.Shutter.X, key, sample, out CameraLinkW opening);
        See(group, surface, _scene.Render.Shutter.Y, key, sample, out CameraLinkW closing);
        (right, down) = (closing.X - opening.X, closing.Y - opening.Y);
    }

    private void See(ShadingGroup group, in SurfaceW surface, float time, in UIntW key, in UIntW sample, out CameraLinkW link)
    {
        Vec3W point = surface.Point;
        if (group.IsInstanced)
        {
            float* memory = stackalloc float[InstanceMaps.Floats];
            InstanceMaps maps = new(memory);
            maps.Fill(_scene.World.Instances!, surface.Instance, time);
            point = maps.Point(surface.InnerPoint);
        }

        _scene.Camera.Link(point, time, _scene.Sampler, key, sample, out link);
    }

    internal static Vector3 At(in Vec3W v, int lane) => new(v.X[lane], v.Y[lane], v.Z[lane]);

    /// <summary>What a ray meets, but for the surface.</summary>
    /// <param name="rays">The rays of a tile.</param>
    /// <param name="ray">The ray's index.</param>
    /// <param name="tile">The tile.</param>
    /// <param name="samples">Its samples.</param>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="pixel">The number of the ray's pixel in the picture.</param>
    internal static FirstHit Hit(PathStream rays, int ray, in Tile tile, SampleRange samples, int width, out long pixel)
    {
        int path = (int)rays.Path[ray];
        (int x, int y) = tile.Pixel(path / samples.Count);
        pixel = ((long)y * width) + x;
        return new()
        {
            Sample = (uint)(samples.First + (path % samples.Count)),
            Primitive = rays.Primitive[ray] + 1,
            Distance = rays.Distance[ray],
            Direction = new(rays.DirectionX[ray], rays.DirectionY[ray], rays.DirectionZ[ray]),
        };
    }

    private FirstHit Hit(int ray, out long pixel)
    {
        FirstHit hit = Hit(_rays, ray, _tile, _samples, _film.Width, out pixel);
        uint instance = _scene.World.Instances is null ? 0 : _rays.Instance[ray];
        return hit with { Primitive = hit.Primitive > _scene.World.Count ? 0 : hit.Primitive, Instance = instance, Cost = _costs[ray] };
    }
}
