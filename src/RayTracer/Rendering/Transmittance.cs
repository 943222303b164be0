using RayTracer.Lights;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What media, or in the report transparent things, leave of the light on its way from a light to where it is scattered, through boundaries that do not change its direction, that priorities make unreal, or where the report does not mind it. Each thread has
/// its own.
/// </summary>
/// <param name="scene">A scene in which paths track what they are in, or transparent things weaken shadows.</param>
internal sealed unsafe class Transmittance(Scene scene)
{
    private const int MaxBoundaries = 256;

    // A ray that comes so near to a light has reached it.
    private const float Reached = 1 - 1e-4f;
    private readonly PinnedBuffer<int> _hits = new(scene.World.RoomForHits(16));
    private PathStream _rays = new(16);
    private PathStream _next = new(16);

    /// <summary>Follows shadow rays.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="origin">The points from which they start.</param>
    /// <param name="instance">The instances on which they start; 0 for none.</param>
    /// <param name="inner">Those points in the instances' spaces.</param>
    /// <param name="direction">Their unit directions.</param>
    /// <param name="distance">The distances to the light.</param>
    /// <param name="media">The media in which they start.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="light">The light.</param>
    /// <param name="transmittance">The fraction of the light that arrives; black in other lanes.</param>
    public void Trace(
        uint lanes, in Vec3W origin, in UIntW instance, in Vec3W inner, in Vec3W direction, in FloatW distance, in UIntW media, in FloatW time, LightSource? light, out RgbW transmittance) =>
        Trace(lanes, origin, instance, inner, direction, distance, media, time, light, out transmittance, out _);

    /// <summary>As the other, and tells how likely a path would have come so far (<see cref="MediumTable.MeanPassing"/>).</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="origin">The points from which they start.</param>
    /// <param name="instance">The instances on which they start; 0 for none.</param>
    /// <param name="inner">Those points in the instances' spaces.</param>
    /// <param name="direction">Their unit directions.</param>
    /// <param name="distance">The distances to the light.</param>
    /// <param name="media">The media in which they start.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="light">The light; null where they end at a point that does not stand in the way itself.</param>
    /// <param name="transmittance">The fraction of the light that arrives; black in other lanes.</param>
    /// <param name="passed">That probability; 1 where there are no media that scatter light.</param>
    public void Trace(
        uint lanes, in Vec3W origin, in UIntW instance, in Vec3W inner, in Vec3W direction, in FloatW distance, in UIntW media, in FloatW time, LightSource? light, out RgbW transmittance,
        out FloatW passed)
    {
        float* arrived = stackalloc float[4 * 16];
        new Span<float>(arrived, 4 * 16).Clear();
        _rays.Count = 0;
        Append(_rays, lanes, origin, direction, Rgb.White, 1f, UIntW.Iota, media, distance, time);
        _rays.SetStart(lanes, instance, inner);
        for (int boundary = 0; boundary < MaxBoundaries && _rays.Count > 0; boundary++)
        {
            scene.World.ClosestHit(_rays, _hits.Pointer);
            _next.Count = 0;
            for (uint i = 0; i < _rays.Count; i++)
            {
                Step(i, light, arrived);
            }

            (_rays, _next) = (_next, _rays);
        }

        transmittance = new(FloatW.Load(arrived), FloatW.Load(arrived + 16), FloatW.Load(arrived + 32));
        passed = FloatW.Load(arrived + 48);
    }

    // Takes a ray to what it meets: the light, something that stops it, or a boundary, which it crosses.
    private void Step(uint ray, LightSource? light, float* arrived)
    {
        uint* index = stackalloc uint[16];
        new Span<uint>(index, 16).Fill(ray);
        float left = _rays.Travelled[ray];
        float met = _rays.Distance[ray];
        int primitive = (int)_rays.Primitive[ray];
        bool isLight = light is not null && primitive == light.Primitive && (scene.World.Instances is null || _rays.Instance[ray] == (uint)light.Instance);
        bool isThere = isLight || met >= left * Reached;
        ShadingGroup? group = isThere ? null : scene.Groups[scene.GroupOfPrimitive[primitive]];
        bool isBoundary = scene.HasMedia && group is { Traits.IsBoundary: true };
        bool isTransparent = scene.WeakensShadows && group is { Traits.IsTransparent: true };
        if (group is not null && !isBoundary && !isTransparent && !(scene.HasNesting && group.IsNested))
        {
            return;
        }

        UIntW media = UIntW.Pick(_rays.Media, index);
        RgbW transmittance = _rays.PickThroughput(index);
        FloatW passed = FloatW.Pick(_rays.Passed, index);
        if (scene.HasMedia)
        {
            RgbW part = MediumTable.Transmittance(scene.Media.Extinction(media), float.Min(met, left));
            transmittance *= part;
            passed *= scene.Media.MeanPassing(media, part);
        }

        if (scene.HasNesting)
        {
            transmittance *= MediumTable.Transmittance(scene.Media.Absorption(media), float.Min(met, left));
        }

        if (group is null)
        {
            uint lane = _rays.Path[ray];
            (arrived[lane], arrived[16 + lane], arrived[32 + lane], arrived[48 + lane]) = (transmittance.R[0], transmittance.G[0], transmittance.B[0], passed[0]);
            return;
        }

        SurfaceShader.Describe(scene, group, _rays, index, group.Traits.UsesUv, out Materials.SurfaceW surface);
        if (isTransparent)
        {
            group.Material.Transparency(surface, out RgbW through);
            transmittance *= through;
        }

        UIntW beyond = scene.Cross(media, group.Interior, MaskW.All, ~SurfaceShader.ComesFromInside(surface));
        if (!isBoundary && !isTransparent && !SurfaceShader.IsUnreal(media, beyond).Any)
        {
            return;
        }

        FloatW time = scene.IsTimed ? FloatW.Pick(_rays.Time, index) : 0f;
        Vec3W start = SurfaceShader.Leave(surface, surface.Incoming);

        // The start is beside the ray: from there, the same direction and the rest of the length would end behind a light that is near.
        Vec3W direction = surface.Incoming;
        FloatW rest = left - met;
        DirectLight.TurnTo(Vec3W.MultiplyAdd(direction, left, _rays.PickOrigin(index) - start), ref direction, ref rest);
        Append(_next, 1u, start, direction, transmittance, passed, UIntW.Pick(_rays.Path, index), beyond, rest, time);
        if (group.IsInstanced)
        {
            _next.SetStart(1u, surface.Instance, SurfaceShader.LeaveInside(surface, surface.Incoming));
        }
    }

    private void Append(
        PathStream to, uint lanes, in Vec3W origin, in Vec3W direction, in RgbW transmittance, in FloatW passed, in UIntW lane, in UIntW media, in FloatW left,
        in FloatW time)
    {
        if (scene.IsTimed)
        {
            to.SetTime(lanes, time);
        }

        to.SetMedia(lanes, media, left);
        to.SetPassed(lanes, passed);
        to.Append(lanes, origin, direction, transmittance, Rgb.Black, lane, 0u);
    }
}
