using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Path tracing (Kajiya 1986): what light the surface sends, light from the sources, and the choice of the next ray. Light that both a light's
/// sampling and the scattered ray can find is weighted between the two by multiple importance sampling (Veach 1997, section 9.2, power
/// heuristic); paths that carry little end at random, and the others make up for them (Arvo &amp; Kirk 1990).
/// </summary>
/// <param name="context">The context that it works in.</param>
/// <param name="maxDepth">The largest number of edges of a path after the camera; below 0 for no limit.</param>
internal sealed unsafe class PathShader(ShaderContext context, int maxDepth) : InteriorShader(context)
{
    internal const float LargestSurvival = 0.95f;

    // How many times what a path carries it survives: less noise for more time. Measured on the Cornell box, fog, glossy balls and a room; 1 is the usual choice.
    internal const float Leniency = 4;
    private readonly ShadowQueue? _queue = context.Queue;
    private readonly DirectLight _directLight = new(context.Scene, context.Queue, PathObserver.OfLights(context.Observer), context.Clock);
    private readonly EmitterLookup _lights = new(context.Scene);
    private readonly EnvironmentLight? _environment = context.Scene.SampledEnvironment;
    private readonly GuidedMaterials? _guided = context.Scene.Guide is { } guide ? new(guide) : null;
    private readonly uint _maxDepth = (uint)(maxDepth < 0 ? RenderDescription.LongestPath : maxDepth);

    internal override long ShadowRays => _directLight.ShadowRays;

    internal override void Flush(PathStream next) => _queue?.Flush(Finished, next);

    protected override void Arrive(PathStream stream, uint* index, in Vec3W direction, out RgbW arriving)
    {
        arriving = default;
        if (_maxDepth == 0)
        {
            return;
        }

        base.Arrive(stream, index, direction, out arriving);
        if (Scene.HidesLights)
        {
            arriving = UIntW.Equal(Edges(UIntW.Pick(stream.State, index)), 0u).Select(default, arriving);
        }

        MaskW shared = UIntW.Equal(UIntW.Pick(stream.State, index) & PathState.CountsEmission, 0u);
        if (_environment is { } environment && shared.Any)
        {
            environment.Pdf(direction, out FloatW pdf);
            if (Scene.LightSelection is not null)
            {
                // The last of the lights.
                Vec3W from = Start(stream, index, direction);
                Scene.LightSelection.Probability(from, stream.PickNormal(index), (uint)_lights.Count - 1u, out FloatW probability);
                pdf *= probability;
            }

            pdf *= Points(UIntW.Pick(stream.State, index));

            arriving *= shared.Select(DirectLight.Weight(FloatW.Pick(stream.Pdf, index), pdf), 1f);
        }
    }

    /// <inheritdoc/>
    protected override void Carry(PathStream stream, PathStream next, uint* index, uint going) => next.SetPdf(going, FloatW.Pick(stream.Pdf, index));

    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        if (Scene.CrossesBoundaries && group.Traits.IsBoundary)
        {
            Describe(Scene, group, stream, index, group.Traits.UsesUv, out SurfaceW boundary);
            Cross(group, boundary, stream, next, index, active);
            return;
        }

        ref PacketW packet = ref Packet;
        ref SurfaceW surface = ref packet.Surface;
        ref RgbW throughput = ref packet.Throughput;
        ref RgbW radiance = ref packet.Radiance;
        ref UIntW path = ref packet.Path;
        ref UIntW vertex = ref packet.Vertex;
        path = UIntW.Pick(stream.Path, index);
        UIntW state = UIntW.Pick(stream.State, index);
        vertex = state & PathState.VertexMask;
        packet.Media = Scene.TracksInteriors ? UIntW.Pick(stream.Media, index) : 0u;
        Vertex.SharesLights = group.Traits.Specular == SpecularLobe.None;
        BeginVertex(path, vertex);
        MaskW lanes = active;
        Observer?.BeginPacket(stream, index, lanes);
        Clock?.Enter(Stage.Describe);
        Describe(Scene, group, stream, index, group.Traits.UsesUv, out surface);
        Clock?.Enter(Stage.Shade);
        UIntW around = 0u;
        if (Scene.HasNesting && group.IsNested)
        {
            UIntW beyond = Scene.Cross(packet.Media, group.Interior, MaskW.All, ~ComesFromInside(surface));
            Cross(group, surface, stream, next, index, lanes & IsUnreal(packet.Media, beyond));
            lanes = lanes.Except(IsUnreal(packet.Media, beyond));
            around = ComesFromInside(surface).Select(beyond, packet.Media);
        }

        packet.Time = Scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        throughput = stream.PickThroughput(index);
        radiance = stream.PickRadiance(index);
        if (Scene.HidesLights && group.Traits.Emits)
        {
            MaskW hidden = lanes & UIntW.Equal(Edges(state), 0u);
            Pass(group, packet, state, stream, next, index, hidden.Bits);
            lanes = lanes.Except(hidden);
        }

        GuidedMaterial? guided = _guided?.At(group, surface);
        Material material = guided ?? group.Material;
        if (group.Traits.Emits && _maxDepth > 0)
        {
            AddEmission(group, surface, stream, index, lanes, lanes.Except(~UIntW.Equal(state & PathState.CountsEmission, 0u)), packet.Time, throughput, ref radiance);
        }

        if (group.Traits.Disperses)
        {
            Disperse(UIntW.Equal(state & PathState.HasWavelength, 0u), ref surface, ref throughput);
        }

        if (Scene.HasNesting && group.IsNested)
        {
            Scene.Media.Index(around, surface.Wavelength, out surface.ExteriorIndex);
        }

        // A path of so many edges may have one more: the ray to a light, or the next one.
        MaskW goesOn = lanes & (Edges(state) + 1u < _maxDepth);
        if (!Splits)
        {
            Light(group, material, goesOn, next);
            Continue(group, guided, stream, next, index, state, lanes, goesOn);
            return;
        }

        if (Vertex.SharesLights)
        {
            Light(group, material, goesOn, next);
        }

        (RgbW arrived, RgbW gathered) = (throughput, radiance);
        for (int way = 0; way < SamplesOfPath; way++)
        {
            MaskW turned = lanes;
            TurnTo(way, ref turned);
            (throughput, vertex) = (arrived, 0u);
            if (!Vertex.SharesLights)
            {
                radiance = gathered;
                Light(group, material, goesOn & turned, next);
            }

            Continue(group, guided, stream, next, index, state, turned, goesOn & turned);
        }
    }

    private void Light(ShadingGroup group, Material material, in MaskW lanes, PathStream next)
    {
        if (!group.Traits.HasDensity)
        {
            return;
        }

        if (_queue is { IsFull: true })
        {
            _queue.Flush(Finished, next);
        }

        ref PacketW packet = ref Packet;
        Clock?.Enter(Stage.Light);
        _directLight.Add(packet.Surface, group, material, packet.Media, Vertex, packet.Time, lanes, packet.Throughput, ref packet.Radiance);
        Clock?.Enter(Stage.Shade);
    }

    // The choice of the next ray, and the end of those that have none.
    private void Continue(
        ShadingGroup group, GuidedMaterial? guided, PathStream stream, PathStream next, uint* index, in UIntW state, in MaskW lanes, in MaskW goesOn)
    {
        ref PacketW packet = ref Packet;
        ref SurfaceW surface = ref packet.Surface;
        ref RgbW throughput = ref packet.Throughput;
        Material material = guided ?? group.Material;
        ref ScatterW scatter = ref packet.Scatter;
        Clock?.Enter(Stage.Scatter);
        material.Scatter(surface, Vertex, out scatter);
        Clock?.Enter(Stage.Shade);
        throughput *= scatter.Weight;
        MaskW straight = Scene.PassesStraight && group.Traits.PassesStraight ? Passing(state, surface, scatter) & lanes : MaskW.None;
        MaskW alive = (goesOn | straight).Except(scatter.Absorbed).Except((throughput.R <= 0f) & (throughput.G <= 0f) & (throughput.B <= 0f));
        alive = alive.Except(Dropped(surface, scatter.Direction).Except(straight));
        FloatW brightest = FloatW.Max(throughput.R, FloatW.Max(throughput.G, throughput.B));
        Survive(Scene.CountsPassed ? Edges(state) : packet.Vertex, guided is null ? brightest * Leniency : GuidedMaterial.Survival, ref alive, ref throughput);
        Observer?.Scattered(stream, index, lanes, alive, material, surface, scatter, isByLobe: false);
        uint going = alive.Bits;
        uint ended = lanes.Bits & ~going;
        if (_queue is not null && group.Traits.HasDensity)
        {
            _queue.End(ended, Finished.Count, going, next.Count);
        }

        if (ended != 0)
        {
            Finished.Append(ended, packet.Radiance, packet.Path);
        }

        Pass(group, packet, state, stream, next, index, (alive & straight).Bits);
        going = alive.Except(straight).Bits;
        if (going != 0)
        {
            packet.Vertex |= WavelengthAfter(group, state) | (state & PathState.PassedMask);
            GoOn(group, guided, ref packet, going, next);
        }
    }

    /// <inheritdoc/>
    internal override void Scatter(PathStream stream, PathStream next, uint* members, int count)
    {
        for (int i = 0; i < count; i += FloatW.Count)
        {
            ScatterPacket(stream, next, members + i, MaskW.First(count - i));
        }
    }

    // A vertex in a medium.
    private void ScatterPacket(PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        UIntW path = UIntW.Pick(stream.Path, index);
        UIntW state = UIntW.Pick(stream.State, index);
        UIntW vertex = state & PathState.VertexMask;
        UIntW media = UIntW.Pick(stream.Media, index);
        BeginVertex(path, vertex);
        Observer?.BeginPacket(stream, index, active);
        FloatW time = Scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        RgbW throughput = stream.PickThroughput(index);
        RgbW radiance = stream.PickRadiance(index);
        Vec3W incoming = stream.PickDirection(index);
        Vec3W point = Vec3W.MultiplyAdd(incoming, FloatW.Pick(stream.Distance, index), stream.PickOrigin(index));

        UIntW edges = Edges(state);
        MaskW alive = active & (edges + 1u < _maxDepth);
        alive = alive.Except((throughput.R <= 0f) & (throughput.G <= 0f) & (throughput.B <= 0f));
        Clock?.Enter(Stage.Light);
        _directLight.AddInMedium(point, incoming, media, Vertex, time, alive, throughput, ref radiance);
        Clock?.Enter(Stage.Scatter);
        Vec3W direction = Scene.Media.Scatter(media, point, incoming, Vertex, out FloatW pdf);
        Clock?.Enter(Stage.Shade);
        Survive(edges, FloatW.Max(throughput.R, FloatW.Max(throughput.G, throughput.B)) * Leniency, ref alive, ref throughput);
        Observer?.ScatteredInMedium(stream, index, active, alive, point, pdf);
        uint going = alive.Bits;
        uint ended = active.Bits & ~going;
        if (ended != 0)
        {
            Finished.Append(ended, radiance, path);
        }

        if (going != 0)
        {
            if (Scene.IsTimed)
            {
                next.SetTime(going, time);
            }

            next.SetPdf(going, pdf);
            if (Scene.LightSelection is not null)
            {
                next.SetNormal(going, default);
            }

            next.SetMedia(going, MediumStack.Scattered(media), 0f);
            UIntW emission = _lights.Count > 0 ? 0u : PathState.CountsEmission;
            next.Append(going, point, direction, throughput, radiance, path, (vertex + 1u) | emission | (state & (PathState.HasWavelength | PathState.PassedMask)));
        }
    }

    // The edges before a vertex. Vertices number random numbers too, so those that are no bounce are numbered, and do not count.
    private UIntW Edges(in UIntW state)
    {
        UIntW vertex = state & PathState.VertexMask;
        return Scene.CountsPassed ? vertex - (state >> PathState.PassedShift) : vertex;
    }

    // The paths that go straight through a surface as if it were not there; beyond what can be counted, they bounce.
    private static MaskW Passing(in UIntW state, in SurfaceW surface, in ScatterW scatter)
    {
        MaskW same = UIntW.Equal(scatter.Direction.X.AsUInt(), surface.Incoming.X.AsUInt()) & UIntW.Equal(scatter.Direction.Y.AsUInt(), surface.Incoming.Y.AsUInt())
            & UIntW.Equal(scatter.Direction.Z.AsUInt(), surface.Incoming.Z.AsUInt());
        return scatter.Delta & same & (state < PathState.PassedMask);
    }

    // Paths that have no vertex where they are, but a number of random numbers.
    private void Pass(ShadingGroup group, in PacketW packet, in UIntW state, PathStream stream, PathStream next, uint* index, uint going)
    {
        if (going != 0)
        {
            MediaAlong(Scene, packet.Surface, packet.Surface.Incoming, group.Interior, packet.Media, out UIntW media);
            UIntW passed = (state + (PathState.OnePassed + 1u)) | WavelengthAfter(group, state);
            Pass(group, packet.Surface, stream, next, index, going, MediumStack.Scattered(media), packet.Throughput, packet.Radiance, passed);
        }
    }

    private void GoOn(ShadingGroup group, GuidedMaterial? guided, ref PacketW packet, uint going, PathStream next)
    {
        ref SurfaceW surface = ref packet.Surface;
        ref ScatterW scatter = ref packet.Scatter;
        if (Scene.IsTimed)
        {
            next.SetTime(going, packet.Time);
        }

        if (group.Traits.HasDensity && _lights.Count > 0)
        {
            if (guided is not null)
            {
                packet.Pdf = guided.ChosenPdf;
            }
            else
            {
                group.Material.Pdf(surface, scatter.Direction, out packet.Pdf);
            }

            next.SetPdf(going, packet.Pdf);
            if (Scene.LightSelection is not null)
            {
                next.SetNormal(going, group.Traits.Transmits ? default : surface.Facing);
            }
        }

        if (Scene.TracksInteriors)
        {
            MediaAlong(Scene, surface, scatter.Direction, group.Interior, packet.Media, out UIntW media);
            next.SetMedia(going, MediumStack.Scattered(media), 0f);
        }

        UIntW emission = group.Traits.HasDensity && _lights.Count > 0 ? scatter.Delta.Select((UIntW)PathState.CountsEmission, 0u) : PathState.CountsEmission;
        packet.Origin = Leave(surface, scatter.Direction);
        packet.Vertex = (packet.Vertex + 1u) | emission;
        next.Append(going, packet.Origin, scatter.Direction, packet.Throughput, packet.Radiance, packet.Path, packet.Vertex);
        if (group.IsInstanced)
        {
            next.SetStart(going, surface.Instance, LeaveInside(surface, scatter.Direction));
        }
    }

    // Ends paths at random, and makes those that survive brighter, so that the mean stays.
    private void Survive(in UIntW vertex, in FloatW chance, ref MaskW alive, ref RgbW throughput)
    {
        MaskW asked = alive & (vertex + 1u > (uint)Scene.Render.RouletteDepth);
        if (!asked.Any)
        {
            return;
        }

        // Written so that a path whose throughput is not a number survives, and is counted at its end.
        FloatW survival = (chance < LargestSurvival).Select(chance, LargestSurvival);
        throughput *= asked.Select(1f / survival, 1f);
        alive = alive.Except(asked & (Vertex.Roulette() >= survival));
    }

    // The number of points of a light that were sampled at the vertex from which paths come.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private FloatW Points(in UIntW state) => UIntW.Equal(state & PathState.VertexMask, 1u).Select((float)Scene.PointsOfFirst, 1f);

    // Light of the surface itself: in full where no light could have been sampled for it, and weighted else.
    private void AddEmission(
        ShadingGroup group, in SurfaceW surface, PathStream stream, uint* index, in MaskW active, in MaskW counts, in FloatW time, in RgbW throughput, ref RgbW radiance)
    {
        FloatW cosine = CosineOfEmission(surface);
        group.Material.Emission(cosine, surface.U, surface.V, out RgbW emitted);
        MaskW shared = counts & (cosine > 0f);
        if (shared.Any)
        {
            FloatW travelled = Scene.TracksInteriors ? FloatW.Pick(stream.Travelled, index) : 0f;
            LightHitW hit = new()
            {
                From = Start(stream, index, surface.Incoming),
                FromNormal = Scene.LightSelection is null ? default : stream.PickNormal(index),
                Direction = surface.Incoming,
                Distance = FloatW.Pick(stream.Distance, index) + travelled,
                Cosine = cosine,
                Time = time,
                Primitive = UIntW.Pick(stream.Primitive, index),
            };
            _lights.Pdf(group, Scene.World.Instances is null ? 0u : UIntW.Pick(stream.Instance, index), hit, shared, out FloatW lightPdf);
            lightPdf *= Points(UIntW.Pick(stream.State, index));
            emitted *= shared.Select(DirectLight.Weight(FloatW.Pick(stream.Pdf, index), lightPdf), 1f);
        }

        radiance = RgbW.MultiplyAdd(throughput, emitted, radiance);
        Observer?.Emitted(group, stream, index, active, throughput * emitted, radiance);
    }
}

/// <summary>Path tracing.</summary>
internal class PathIntegrator(string name = "path", IntegratorTraits more = PathIntegrator.Media | IntegratorTraits.PathLimit | IntegratorTraits.Guides | IntegratorTraits.Splits) : Integrator(
    name, IntegratorTraits.Light | IntegratorTraits.Layers | IntegratorTraits.Priorities | IntegratorTraits.LiteralNormals | IntegratorTraits.SampledEnvironment
        | IntegratorTraits.LitGloss | IntegratorTraits.SoftTone | IntegratorTraits.HiddenLights | more)
{
    protected const IntegratorTraits Media = IntegratorTraits.Media | IntegratorTraits.VaryingMedia;

    protected internal override SurfaceShader CreateShader(ShaderContext context) => new PathShader(context, context.Scene.Render.MaxDepth);
}

/// <summary>Path tracing with direct light only.</summary>
internal sealed class DirectIntegrator() : PathIntegrator("direct", IntegratorTraits.None)
{
    protected internal override SurfaceShader CreateShader(ShaderContext context) => new PathShader(context, maxDepth: 2);
}

/// <summary>Path tracing in which what goes straight through surfaces may be no bounce.</summary>
internal sealed class VolPathIntegrator() : PathIntegrator("volPath", Media | IntegratorTraits.PathLimit | IntegratorTraits.StraightThrough);
