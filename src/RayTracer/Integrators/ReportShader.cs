using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What happens where paths meet a surface in the report (listing 6.3): emission, ambient light, light from the sources, and the choice of the next
/// ray.
/// </summary>
internal sealed unsafe class ReportShader(ShaderContext context) : SurfaceShader(context)
{
    private readonly ShadowQueue? _queue = context.Queue;
    private readonly DirectLight _directLight = new(context.Scene, context.Queue, PathObserver.OfLights(context.Observer), context.Clock);

    internal override long ShadowRays => _directLight.ShadowRays;

    internal override void Flush(PathStream next) => _queue?.Flush(Finished, next);

    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        // Random numbers first: their long chain of multiplications then overlaps with the description of the surface.
        ref PacketW packet = ref Packet;
        ref SurfaceW surface = ref packet.Surface;
        ref RgbW throughput = ref packet.Throughput;
        ref RgbW radiance = ref packet.Radiance;
        ref UIntW path = ref packet.Path;
        path = UIntW.Pick(stream.Path, index);
        UIntW state = UIntW.Pick(stream.State, index);
        UIntW diffuseDepth = state & PathState.DepthMask;
        UIntW specularDepth = (state >> PathState.SpecularShift) & PathState.DepthMask;
        packet.Vertex = diffuseDepth + specularDepth;
        BeginVertex(path, packet.Vertex);
        Observer?.BeginPacket(stream, index, active);
        Clock?.Enter(Stage.Describe);
        Describe(Scene, group, stream, index, group.Traits.UsesUv, out surface);
        Clock?.Enter(Stage.Shade);
        packet.Time = Scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        throughput = stream.PickThroughput(index);
        radiance = stream.PickRadiance(index);

        // Light that the surface itself sends towards the ray's origin.
        Material material = group.Material;
        if (group.Traits.Emits)
        {
            AddEmission(group, stream, index, active, surface, throughput, state, ref radiance);
        }

        if (group.Traits.Disperses)
        {
            Disperse(UIntW.Equal(state & PathState.HasWavelength, 0u), ref surface, ref throughput);
        }

        if (!Scene.Ambient.IsBlack)
        {
            material.AmbientResponse(surface, out RgbW response);
            radiance = RgbW.MultiplyAdd(throughput * response, Scene.Ambient, radiance);
            Observer?.Brightened(stream, index, active, throughput * response * Scene.Ambient, radiance);
        }

        Light(group, active, next);
        if (!Splits)
        {
            Continue(group, stream, next, index, state, active);
            return;
        }

        RgbW arrived = throughput;
        for (int way = 0; way < SamplesOfPath; way++)
        {
            MaskW turned = active;
            TurnTo(way, ref turned);
            throughput = arrived;
            Continue(group, stream, next, index, state, turned);
        }
    }

    // Light from the sources.
    private void Light(ShadingGroup group, in MaskW lanes, PathStream next)
    {
        if (!group.Traits.IsLit)
        {
            return;
        }

        if (_queue is { IsFull: true })
        {
            _queue.Flush(Finished, next);
        }

        ref PacketW packet = ref Packet;
        group.Material.Brdf(packet.Surface, out RgbW brdf);
        Clock?.Enter(Stage.Light);
        _directLight.Add(packet.Surface, group, shared: null, 0u, Vertex, packet.Time, lanes, packet.Throughput * brdf, ref packet.Radiance);
        Clock?.Enter(Stage.Shade);
    }

    // The next ray.
    private void Continue(ShadingGroup group, PathStream stream, PathStream next, uint* index, in UIntW state, in MaskW active)
    {
        ref PacketW packet = ref Packet;
        ref SurfaceW surface = ref packet.Surface;
        ref RgbW throughput = ref packet.Throughput;
        Material material = group.Material;
        UIntW diffuseDepth = state & PathState.DepthMask;
        UIntW specularDepth = (state >> PathState.SpecularShift) & PathState.DepthMask;
        ref ScatterW scatter = ref packet.Scatter;
        Clock?.Enter(Stage.Scatter);
        material.Scatter(surface, Vertex, out scatter);
        Clock?.Enter(Stage.Shade);
        throughput *= scatter.Weight;
        UIntW limit = scatter.Specular.Select((UIntW)(uint)Scene.Render.MaxSpecularDepth, (uint)Scene.Render.MaxDiffuseDepth);
        MaskW goesOn = scatter.Specular.Select(specularDepth, diffuseDepth) < limit;

        // Written so that a path whose throughput is not a number survives, and is counted at its end.
        MaskW isDark = (throughput.R <= 0f) & (throughput.G <= 0f) & (throughput.B <= 0f);
        MaskW alive = active.Except(scatter.Absorbed).Except(isDark) & goesOn;
        if (group.MayLeak)
        {
            alive = alive.Except(Leaks(surface, scatter.Direction));
        }

        Observer?.Scattered(stream, index, active, alive, material, surface, scatter, isByLobe: true);
        uint ended = active.Except(alive).Bits;
        uint going = alive.Bits;
        if (_queue is not null && group.Traits.IsLit)
        {
            _queue.End(ended, Finished.Count, going, next.Count);
        }

        if (ended != 0)
        {
            Finished.Append(ended, packet.Radiance, packet.Path);
        }

        if (going != 0)
        {
            UIntW step = scatter.Specular.Select((UIntW)PathState.OneSpecular, PathState.OneDiffuse);
            UIntW emission = scatter.Specular.Select((UIntW)PathState.CountsEmission, 0u);
            if (Scene.WeakensShadows && group.Traits.IsTransparent)
            {
                // What comes straight through has been asked of the sources already, where the path came from.
                MaskW passes = Vec3W.Dot(scatter.Direction, surface.Facing) < 0f;
                emission = (scatter.Specular & passes).Select(state & PathState.CountsEmission, emission);
            }

            packet.Origin = Leave(surface, scatter.Direction);
            if (Scene.IsTimed)
            {
                next.SetTime(going, packet.Time);
            }

            next.Append(going, packet.Origin, scatter.Direction, throughput, packet.Radiance, packet.Path, ((state & 0xffffu) + step) | emission | WavelengthAfter(group, state));
            if (group.IsInstanced)
            {
                next.SetStart(going, surface.Instance, LeaveInside(surface, scatter.Direction));
            }
        }
    }

    private void AddEmission(
        ShadingGroup group, PathStream stream, uint* index, in MaskW active, in SurfaceW surface, in RgbW throughput, in UIntW state, ref RgbW radiance)
    {
        MaskW counts = ~UIntW.Equal(state & PathState.CountsEmission, 0u);
        group.Material.Emission(CosineOfEmission(surface), surface.U, surface.V, out RgbW emitted);
        radiance = counts.Select(RgbW.MultiplyAdd(throughput, emitted, radiance), radiance);
        Observer?.Emitted(group, stream, index, active & counts, throughput * emitted, radiance);
    }
}

/// <summary>The report's integrator.</summary>
internal sealed class ReportIntegrator()
    : Integrator(
        "report",
        IntegratorTraits.Light | IntegratorTraits.Layers | IntegratorTraits.AmbientLight | IntegratorTraits.WeakenedShadows | IntegratorTraits.BounceLimits
            | IntegratorTraits.Splits)
{
    protected internal override SurfaceShader CreateShader(ShaderContext context) => new ReportShader(context);
}
