using System.Numerics;
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
            _generator.Fill(_rays);
            if (_rays.Count == 0)
            {
                return;
            }

            if (film.Has(Aov.BvhCost))
            {
                AddCosts();
            }

            _scene.World.ClosestHit(_rays, _hits.Pointer);
            AddRays();
            if (film.NeedsSurfaces)
            {
                AddSurfaces();
            }
        }
    }

    private void AddCosts()
    {
        for (int i = 0; i < _rays.Count; i++)
        {
            _film.AddCost(PixelOf(i, out _), _scene.World.Cost(_rays.Ray(i), _scene.IsTimed ? _rays.Time[i] : 0));
        }
    }

    private void AddRays()
    {
        for (int i = 0; i < _rays.Count; i++)
        {
            uint primitive = _rays.Primitive[i];
            _film.AddRay(PixelOf(i, out uint sample), sample, primitive == _scene.World.Count ? null : primitive, _rays.Distance[i]);
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
        SurfaceShader.Describe(_scene, group, _rays, index, group.UsesUv || _film.Has(Aov.Uv), out SurfaceW surface);
        group.Material.Albedo(surface, out RgbW albedo);
        for (int lane = 0; lane < count; lane++)
        {
            long pixel = PixelOf((int)index[lane], out _);
            _film.Add(Aov.Normal, pixel, 0, surface.Facing.X[lane]);
            _film.Add(Aov.Normal, pixel, 1, surface.Facing.Y[lane]);
            _film.Add(Aov.Normal, pixel, 2, surface.Facing.Z[lane]);
            _film.Add(Aov.Albedo, pixel, 0, albedo.R[lane]);
            _film.Add(Aov.Albedo, pixel, 1, albedo.G[lane]);
            _film.Add(Aov.Albedo, pixel, 2, albedo.B[lane]);
            _film.Add(Aov.Uv, pixel, 0, surface.U[lane]);
            _film.Add(Aov.Uv, pixel, 1, surface.V[lane]);
        }
    }

    // The pixel's number in the picture.
    private long PixelOf(int ray, out uint sample)
    {
        int path = (int)_rays.Path[ray];
        sample = (uint)(_samples.First + (path % _samples.Count));
        (int x, int y) = _tile.Pixel(path / _samples.Count);
        return ((long)y * _film.Width) + x;
    }
}
