using System.Numerics;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What media, or in the report transparent things, leave of the light on its way from a light to where it is scattered, through boundaries that do not
/// change its direction, that priorities make unreal, or where the report does not mind it. Each thread has its own.
/// </summary>
/// <param name="scene">A scene in which paths track what they are in, or transparent things weaken shadows.</param>
internal sealed unsafe class Transmittance(Scene scene)
{
    private const int MaxBoundaries = 256;

    // A ray that comes so near to a light has reached it.
    private const float Reached = 1 - 1e-4f;
    private readonly PinnedBuffer<int> _hits = new(scene.World.RoomForHits(16));
    private readonly ShadowFlights? _flights = scene.HasVaryingMedia ? new() : null;
    private PathStream _rays = new(16);
    private PathStream _next = new(16);

    /// <summary>Sets the keys of the random numbers of the rays that are followed next, where media vary.</summary>
    public void Draw(in UIntW keys) => _flights!.Begin(keys);

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
            Step(light, arrived, (uint)boundary);
            (_rays, _next) = (_next, _rays);
        }

        transmittance = new(FloatW.Load(arrived), FloatW.Load(arrived + 16), FloatW.Load(arrived + 32));
        passed = FloatW.Load(arrived + 48);
    }

    // Takes the rays, which fit in a packet, to what they meet: the light, something that stops them, or a boundary, which they cross.
    private void Step(LightSource? light, float* arrived, uint boundary)
    {
        MaskW used = MaskW.First(_rays.Count);
        UIntW media = used.Select(UIntW.Load(_rays.Media), 0u);
        FloatW way = FloatW.Min(FloatW.Load(_rays.Distance), FloatW.Load(_rays.Travelled));
        RgbW left = new(FloatW.Load(_rays.ThroughputR), FloatW.Load(_rays.ThroughputG), FloatW.Load(_rays.ThroughputB));
        if (scene.HasMedia)
        {
            RgbW part = MediumTable.Transmittance(scene.Media.Extinction(media, new(FloatW.Load(_rays.DirectionX), FloatW.Load(_rays.DirectionY), FloatW.Load(_rays.DirectionZ))), way);
            left *= part;
            (FloatW.Load(_rays.Passed) * scene.Media.MeanPassing(media, part)).Store(_rays.Passed);
        }

        if (_flights is not null)
        {
            _flights.Weaken(scene.Media, _rays, media, way, boundary, ref left);
        }

        if (scene.HasNesting)
        {
            left *= MediumTable.Transmittance(scene.Media.Absorption(media), way);
        }

        left.R.Store(_rays.ThroughputR);
        left.G.Store(_rays.ThroughputG);
        left.B.Store(_rays.ThroughputB);
        uint* index = stackalloc uint[16];
        for (uint rest = used.Bits & ~Arrive(light, arrived); rest != 0;)
        {
            // Those that meet surfaces of the same group go on together.
            int number = GroupOf(BitOperations.TrailingZeroCount(rest));
            uint same = 0;
            int count = 0;
            for (uint among = rest; among != 0; among &= among - 1)
            {
                int ray = BitOperations.TrailingZeroCount(among);
                if (GroupOf(ray) == number)
                {
                    same |= 1u << ray;
                    index[count++] = (uint)ray;
                }
            }

            rest &= ~same;
            new Span<uint>(index + count, 16 - count).Fill(index[0]);
            Cross(scene.Groups[number], index, MaskW.First(count));
        }
    }

    private int GroupOf(int ray) => scene.GroupOfPrimitive[(int)_rays.Primitive[ray]];

    // Those that have reached the light.
    private uint Arrive(LightSource? light, float* arrived)
    {
        uint there = 0;
        for (int ray = 0; ray < _rays.Count; ray++)
        {
            bool isLight = light is not null && (int)_rays.Primitive[ray] == light.Primitive && (scene.World.Instances is null || _rays.Instance[ray] == (uint)light.Instance);
            if (isLight || _rays.Distance[ray] >= _rays.Travelled[ray] * Reached)
            {
                there |= 1u << ray;
                uint lane = _rays.Path[ray];
                (arrived[lane], arrived[16 + lane], arrived[32 + lane], arrived[48 + lane]) =
                    (_rays.ThroughputR[ray], _rays.ThroughputG[ray], _rays.ThroughputB[ray], _rays.Passed[ray]);
            }
        }

        return there;
    }

    private void Cross(ShadingGroup group, uint* index, in MaskW among)
    {
        bool isBoundary = scene.CrossesBoundaries && group.Traits.IsBoundary;
        bool isTransparent = scene.WeakensShadows && group.Traits.IsTransparent;
        bool isStraight = scene.PassesStraight && group.Traits.PassesStraight && !isBoundary;
        if (!isBoundary && !isTransparent && !isStraight && !(scene.HasNesting && group.IsNested))
        {
            return;
        }

        SurfaceShader.Describe(scene, group, _rays, index, group.Traits.UsesUv, out SurfaceW surface);
        RgbW transmittance = _rays.PickThroughput(index);
        if (isTransparent)
        {
            group.Material.Transparency(surface, out RgbW through);
            transmittance *= through;
        }

        UIntW media = UIntW.Pick(_rays.Media, index);
        UIntW beyond = isStraight && group.Interior == 0 ? media : scene.Cross(media, group.Interior, MaskW.All, ~SurfaceShader.ComesFromInside(surface));
        MaskW lanes = among;
        if (!isBoundary && !isTransparent)
        {
            MaskW unreal = scene.HasNesting && group.IsNested ? SurfaceShader.IsUnreal(media, beyond) : MaskW.None;
            lanes &= unreal;
            if (isStraight)
            {
                group.Material.Straight(surface, out RgbW share);
                transmittance = unreal.Select(transmittance, transmittance * share);
                lanes |= among.Except((transmittance.R <= 0f) & (transmittance.G <= 0f) & (transmittance.B <= 0f));
            }
        }

        FloatW time = scene.IsTimed ? FloatW.Pick(_rays.Time, index) : 0f;
        FloatW length = FloatW.Pick(_rays.Travelled, index);
        Vec3W start = SurfaceShader.Leave(surface, surface.Incoming);

        // The start is beside the ray: from there, the same direction and the rest of the length would end behind a light that is near.
        Vec3W direction = surface.Incoming;
        FloatW rest = length - FloatW.Pick(_rays.Distance, index);
        DirectLight.TurnTo(Vec3W.MultiplyAdd(direction, length, _rays.PickOrigin(index) - start), ref direction, ref rest);
        Append(_next, lanes.Bits, start, direction, transmittance, FloatW.Pick(_rays.Passed, index), UIntW.Pick(_rays.Path, index), beyond, rest, time);
        if (group.IsInstanced)
        {
            _next.SetStart(lanes.Bits, surface.Instance, SurfaceShader.LeaveInside(surface, surface.Incoming));
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
