using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Finds the media in which light paths start: those around a point of each light are known, and a ray from there to the start meets all that changes on
/// the way. Of a light that has no extent, nothing does. Where things move, they may leave such a point, and one outside of all of them is taken. Each
/// thread has its own.
/// </summary>
internal sealed unsafe class LightInteriors
{
    private const int MostHits = 1000;

    // Off the middle, where things that are symmetric have their boundaries.
    private static readonly Vector3 s_within = new(0.437f, 0.561f, 0.483f);
    private readonly Scene _scene;
    private readonly (Vector3 Point, uint Media)[] _known;
    private readonly PinnedBuffer<int> _hits;
    private PathStream _rays = new(16);
    private PathStream _next = new(16);

    /// <summary>Finds the media of a point of each light.</summary>
    /// <param name="scene">A scene in which paths track what they are in.</param>
    public LightInteriors(Scene scene)
    {
        _scene = scene;
        _hits = new(scene.World.RoomForHits(16));
        _known = [.. scene.SampledLights.Select(l => Known(l.Extent((scene.Render.Shutter.X, scene.Render.Shutter.Y)).Box))];
    }

    /// <summary>Makes one for another thread.</summary>
    /// <param name="other">One of the same scene.</param>
    public LightInteriors(LightInteriors other)
    {
        (_scene, _known) = (other._scene, other._known);
        _hits = new(_scene.World.RoomForHits(16));
    }

    /// <summary>The media at the starts of light paths.</summary>
    /// <param name="lanes">The lanes in use.</param>
    /// <param name="light">Numbers of their lights.</param>
    /// <param name="point">The starts.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    public UIntW Of(uint lanes, in UIntW light, in Vec3W point, in FloatW time)
    {
        uint* media = stackalloc uint[16];
        new Span<uint>(media, 16).Clear();
        _rays.Count = 0;
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            (Vector3 from, media[lane]) = _known[light[lane]];
            Vector3 to = new Vector3(point.X[lane], point.Y[lane], point.Z[lane]) - from;
            if (to != default && float.IsFinite(from.X))
            {
                Append(_rays, from, to.Unit(), media[lane], to.Norm(), time[lane], (uint)lane);
            }
        }

        for (int hit = 0; hit < MostHits && _rays.Count > 0; hit++)
        {
            _scene.World.ClosestHit(_rays, _hits.Pointer);
            _next.Count = 0;
            for (uint i = 0; i < _rays.Count; i++)
            {
                Step(i, media);
            }

            (_rays, _next) = (_next, _rays);
        }

        return UIntW.Load(media);
    }

    // Lights that are infinitely far away shine from outside of all that has an end.
    private (Vector3 Point, uint Media) Known(in Bounds box)
    {
        if (!box.IsFinite)
        {
            return (new(float.PositiveInfinity), 0);
        }

        if (_scene.IsTimed && _scene.World.IsFinite)
        {
            return (_scene.World.Ball.Center + (s_within * (4 * float.Sqrt(_scene.World.Ball.Area))), 0);
        }

        Vector3 point = box.Minimum + ((box.Maximum - box.Minimum) * s_within);
        return (point, EnclosingMedia.At(_scene, point));
    }

    // Takes a ray to the start, or through what it meets before.
    private void Step(uint ray, uint* media)
    {
        float left = _rays.Travelled[ray];
        float met = _rays.Distance[ray];
        if (met >= left)
        {
            return;
        }

        uint* index = stackalloc uint[16];
        new Span<uint>(index, 16).Fill(ray);
        ShadingGroup group = _scene.Groups[_scene.GroupOfPrimitive[(int)_rays.Primitive[ray]]];
        SurfaceShader.Describe(_scene, group, _rays, index, group.Traits.UsesUv, out Materials.SurfaceW surface);
        UIntW behind = UIntW.Pick(_rays.Media, index);
        if (group.Interior != 0)
        {
            behind = _scene.Cross(behind, group.Interior, MaskW.All, ~SurfaceShader.ComesFromInside(surface));
        }

        uint lane = _rays.Path[ray];
        media[lane] = Media.MediumStack.Scattered(behind)[0];
        Vec3W direction = surface.Incoming;
        Vec3W start = SurfaceShader.Leave(surface, direction);
        FloatW rest = left - met;
        DirectLight.TurnTo(Vec3W.MultiplyAdd(direction, left, _rays.PickOrigin(index) - start), ref direction, ref rest);
        Append(_next, start, direction, media[lane], rest, _scene.IsTimed ? _rays.Time[ray] : 0f, lane);
        if (group.IsInstanced)
        {
            _next.SetStart(1u, surface.Instance, SurfaceShader.LeaveInside(surface, surface.Incoming));
        }
    }

    private void Append(PathStream to, in Vec3W origin, in Vec3W direction, uint media, FloatW left, FloatW time, uint lane)
    {
        if (_scene.IsTimed)
        {
            to.SetTime(1u, time);
        }

        to.SetMedia(1u, media, left);
        to.Append(1u, origin, direction, Rgb.White, Rgb.Black, lane, 0u);
    }
}
