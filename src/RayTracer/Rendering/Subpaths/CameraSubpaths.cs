using System.Numerics;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>
/// Camera paths: they meet lights, ask them, and are connected and merged with the light paths of the pass. All that a path gathers is added up under its
/// number, in an order that depends on the path alone.
/// </summary>
internal sealed unsafe class CameraSubpaths : SubpathShader
{
    private const int LeastRays = 8192;

    // Of points on lights that are infinitely far away, for those who look at paths.
    private const float FarAway = 1e6f;
    private readonly EmitterLookup _emitters;
    private readonly Strategies _strategies;
    private readonly LightPass _pass;
    private readonly Connections? _connections;
    private readonly PhotonMerge? _merge;
    private readonly StrategyRecorder? _recorder;
    private readonly Action _traceRays;
    private readonly int _raysOfPacket;
    private readonly ShadowRays _rays;
    private readonly PinnedBuffer<ShapeSampleW> _sample = new(1);
    private readonly PinnedBuffer<RgbW> _brought = new(1);
    private PinnedBuffer<float> _gathered = new(0);
    private int _stride;
    private long _traced;

    /// <summary>Makes one.</summary>
    /// <param name="context">The context that it works in.</param>
    /// <param name="strategies">Its strategies.</param>
    public CameraSubpaths(ShaderContext context, Strategies strategies)
        : base(context)
    {
        _emitters = new(Scene);
        _strategies = strategies;
        _pass = context.Light!;
        _recorder = _pass.Recorder();
        _raysOfPacket = FloatW.Count * (Scene.LightSelection is null ? Lights.Length : 1);
        _rays = new(Scene, Math.Max(LeastRays, _raysOfPacket));
        _traceRays = TraceRays;
        _connections = (strategies & Strategies.Connections) != Strategies.None ? new(Scene, _pass, Gather, _recorder) : null;
        _merge = (strategies & Strategies.Merges) != Strategies.None ? new(_pass, IsPhotons, _recorder) : null;
    }

    /// <inheritdoc/>
    internal override long ShadowRays => _traced + (_connections?.Traced ?? 0);

    private bool IsPhotons => (_strategies & (Strategies.Camera | Strategies.Merges)) == Strategies.Merges;

    /// <inheritdoc/>
    internal override void Begin(PathSource source, SampleRange samples)
    {
        base.Begin(source, samples);
        Weights = _pass.Weights;
        _recorder?.Begin(source, samples);
        if (_stride < source.Total + 32)
        {
            _stride = source.Total + 32;
            _gathered = new(3L * _stride);
        }

        new Span<float>(_gathered.Pointer, 3 * _stride).Clear();
    }

    /// <inheritdoc/>
    internal override void Flush(PathStream next)
    {
        _connections?.Flush(_rays, _traceRays);
        TraceRays();
    }

    /// <inheritdoc/>
    internal override void End()
    {
        float* r = _gathered.Pointer;
        for (int i = 0; i < Source.Total; i += FloatW.Count, r += FloatW.Count)
        {
            Finished.Append(MaskW.First(Source.Total - i).Bits, new(FloatW.Load(r), FloatW.Load(r + _stride), FloatW.Load(r + (2 * _stride))), UIntW.Iota + (uint)i);
            Finished.Drain();
        }
    }

    /// <inheritdoc/>
    internal override void Miss(PathStream stream, uint* members, int count)
    {
        for (int i = 0; i < count && MaxDepth > 0; i += FloatW.Count)
        {
            uint* index = members + i;
            ref VertexW at = ref At;
            at.Path = UIntW.Pick(stream.Path, index);
            at.State = UIntW.Pick(stream.State, index);
            at.Surface.Incoming = stream.PickDirection(index);
            Arrive(stream, index, at.Surface.Incoming, out RgbW arriving);
            RgbW alone = arriving;
            MaskW shared = ~UIntW.Equal(at.State & PathState.VertexMask, 0u);
            if (Scene.Environment is not null && shared.Any)
            {
                arriving *= shared.Select(EnvironmentWeight(stream, index), 1f);
            }

            Observer?.Missed(stream, index, MaskW.First(count - i), arriving);

            // A direction that is not a number meets nothing; it must not pass for a ray into the open.
            FloatW fault = Vec3W.Dot(at.Surface.Incoming, at.Surface.Incoming) * 0f;
            RgbW throughput = stream.PickThroughput(index);
            _recorder?.Add(MaskW.First(count - i).Bits, at.Path, new() { To = (at.State & PathState.VertexMask) + 2u, Factors = new() { CameraPart = throughput, Radiance = alone } }, throughput * arriving, throughput * alone);
            Gather(MaskW.First(count - i).Bits, at.Path, (throughput * arriving) + new RgbW(fault, fault, fault));
        }
    }

    /// <inheritdoc/>
    protected override void Arrive(ShadingGroup group, PathStream stream, uint* index, MaskW first)
    {
        ref VertexW at = ref At;
        at.Sums.Arrive(at.Distance * at.Distance, at.Cosine);
        if (first.Any)
        {
            Scene.Camera.Density(Start(stream, index, at.Surface.Incoming), at.Surface.Incoming, at.Distance, at.Time, out FloatW density);
            bool isSeenByLight = (_strategies & Strategies.Camera) != Strategies.None;
            at.Sums.Vcm = first.Select(isSeenByLight ? SubpathSumsW.Limited(PathWeights.Power(Weights.CameraPaths / (density * at.Cosine))) : 0f, at.Sums.Vcm);
            at.Sums.Vc = first.Select(0f, at.Sums.Vc);
            at.Sums.Vm = first.Select(0f, at.Sums.Vm);
        }
    }

    /// <inheritdoc/>
    protected override MaskW Visit(ShadingGroup group, PathStream stream, uint* index, MaskW active)
    {
        ref VertexW at = ref At;
        MakeRoom();
        if (group.Traits.Emits && MaxDepth > 0)
        {
            AddEmission(group, stream, index, active);
        }

        MaskW goesOn = active & (at.Number + 1u < MaxDepth);
        if (IsPhotons)
        {
            // Light that paths meet after they have gathered is the lights' own: the rest is in the photons.
            goesOn &= UIntW.Equal(at.State & PathState.HasScattered, 0u);
        }

        if (!group.Traits.HasDensity || !goesOn.Any)
        {
            return goesOn;
        }

        if ((_strategies & Strategies.Lights) != Strategies.None)
        {
            AddLights(group, goesOn);
        }

        if ((_strategies & (Strategies.Merges | Strategies.Connections)) != Strategies.None)
        {
            CameraEndW end = new() { Throughput = at.Throughput, Color = WavelengthColor(), Sums = at.Sums, Path = at.Path, Number = at.Number, Media = at.Media, Time = at.Time };
            if (_merge is not null && !group.IsOfMedia)
            {
                _merge.Add(group, ref at.Surface, end, MaxDepth, goesOn, out at.Bsdf);
                Gather(goesOn.Bits, at.Path, at.Bsdf);
            }

            _connections?.Add(group, ref at.Surface, end, LightPaths(at.Path), MaxDepth, goesOn);
        }

        return goesOn;
    }

    /// <inheritdoc/>
    protected override void Choose(ShadingGroup group, ref SurfaceW surface, out ScatterW scatter, out FloatW pdf, out FloatW reversePdf)
    {
        group.Material.Scatter(surface, Vertex, out scatter);
        scatter.Absorbed |= Dropped(surface, scatter.Direction);
        (pdf, reversePdf) = (1f, 1f);
        if (group.Traits.HasDensity)
        {
            group.Material.Pdf(surface, scatter.Direction, out pdf);
            Adjoint.ReversePdf(group.Material, ref surface, scatter.Direction, out reversePdf);
        }
    }

    /// <inheritdoc/>
    protected override MaskW Ending(MaskW delta) => _strategies == (Strategies.Seen | Strategies.Camera) ? ~delta : MaskW.None;

    private void MakeRoom()
    {
        if (_connections is { IsFull: true })
        {
            _connections.Flush(_rays, _traceRays);
        }

        if (!_rays.HasRoomFor(_raysOfPacket))
        {
            TraceRays();
        }
    }

    // The light paths that camera paths are connected with: those of their pixels, where the sample has one.
    private UIntW LightPaths(UIntW path)
    {
        PathNumber.Split(path, Samples, out UIntW pixel, out _);
        return UIntW.Gather(Source.PixelNumbers, pixel);
    }

    private static FloatW Share(FloatW others) => 1f / (others + 1f);

    // Light of the surface itself: in full where the camera sees it straight, or no other way could have found it.
    private void AddEmission(ShadingGroup group, PathStream stream, uint* index, in MaskW active)
    {
        ref VertexW at = ref At;
        FloatW cosine = CosineOfEmission(at.Surface);
        group.Material.Emission(cosine, at.Surface.U, at.Surface.V, out RgbW emitted);
        RgbW alone = emitted;
        MaskW shared = (active & cosine > 0f).Except(UIntW.Equal(at.Number, 0u));
        if (shared.Any)
        {
            LightHitW hit = new()
            {
                From = Start(stream, index, at.Surface.Incoming),
                FromNormal = Scene.LightSelection is null ? default : stream.PickNormal(index),
                Direction = at.Surface.Incoming,
                Distance = at.Distance,
                Cosine = cosine,
                Time = at.Time,
                Primitive = UIntW.Pick(stream.Primitive, index),
            };
            _emitters.Densities(group, Scene.World.Instances is null ? 0u : UIntW.Pick(stream.Instance, index), hit, shared, _pass.Emission, out FloatW asked, out FloatW emission);
            FloatW perArea = asked * cosine / (at.Distance * at.Distance);
            emitted *= shared.Select(SeenWeight(perArea, emission), 1f);
        }

        _recorder?.Add(active.Bits, at.Path, new() { To = at.Number + 2u, Factors = new() { CameraPart = at.Throughput, Radiance = alone } }, at.Throughput * emitted, at.Throughput * alone);
        Gather(active.Bits, at.Path, at.Throughput * emitted);
    }

    // The weight of a light that is met, by the densities with which it is asked, and with which it sends a path of light here.
    private FloatW SeenWeight(FloatW asked, FloatW emission)
    {
        ref SubpathSumsW sums = ref At.Sums;
        FloatW emitted = PathWeights.Power(emission / Weights.PerLightPath);
        return Share(FloatW.MultiplyAdd(PathWeights.Power(asked), sums.Vcm, IsPhotons ? 0f : emitted * sums.Vc));
    }

    private FloatW EnvironmentWeight(PathStream stream, uint* index)
    {
        ref VertexW at = ref At;
        at.Sums.Vcm = FloatW.Pick(stream.Vcm, index);
        at.Sums.Vc = FloatW.Pick(stream.Vc, index);
        if (Scene.HasMedia)
        {
            at.Sums.Pass(FloatW.Pick(stream.Passed, index));
        }

        LightHitW hit = new() { From = Start(stream, index, at.Surface.Incoming), Direction = at.Surface.Incoming, Distance = float.PositiveInfinity, Cosine = 1f };
        UIntW number = (uint)(Lights.Length - 1);
        Scene.Environment!.Pdf(hit, out FloatW asked);
        Scene.Environment.EmissionPdf(hit, out FloatW point, out FloatW direction);
        if (Scene.LightSelection is not null)
        {
            Scene.LightSelection.Probability(hit.From, stream.PickNormal(index), number, out FloatW probability);
            asked *= probability;
        }

        return SeenWeight(asked, point * direction * _pass.Emission.Probability(number));
    }

    private void AddLights(ShadingGroup group, MaskW active)
    {
        ref VertexW at = ref At;
        if (Scene.LightSelection is null)
        {
            for (int light = 0; light < Lights.Length; light++)
            {
                Vertex.Light(light, out FloatW u, out FloatW v);
                AddLight(group, light, u, v, 1f, active);
            }

            return;
        }

        Scene.LightSelection.Choose(at.Surface.Point, group.Traits.Transmits ? default : at.Surface.Facing, Vertex.LightChoice(), out UIntW chosen, out FloatW probability);
        Vertex.Light(0, out FloatW u0, out FloatW v0);
        for (MaskW rest = active & (probability > 0f); rest.Any;)
        {
            int light = (int)chosen[BitOperations.TrailingZeroCount(rest.Bits)];
            MaskW same = rest & UIntW.Equal(chosen, (uint)light);
            AddLight(group, light, u0, v0, probability, same);
            rest = rest.Except(same);
        }
    }

    private void AddLight(ShadingGroup group, int number, FloatW u, FloatW v, FloatW probability, MaskW active)
    {
        ref VertexW at = ref At;
        LightSource light = Lights[number];
        ref ShapeSampleW sample = ref *_sample.Pointer;
        ref RgbW brought = ref *_brought.Pointer;
        light.Sample(at.Surface.Point, u, v, at.Time, out sample, out brought);
        // Along a light that is just touched, the weights would be 0 / 0; no light comes from there.
        active = (active & sample.InversePdf > 0f & sample.Cosine > 0f).Except(Dropped(at.Surface, sample.Direction));
        group.Material.Evaluate(at.Surface, sample.Direction, out at.Bsdf, out at.Pdf);
        active = active.Except((at.Bsdf.R <= 0f) & (at.Bsdf.G <= 0f) & (at.Bsdf.B <= 0f));
        if (!active.Any)
        {
            return;
        }

        FloatW asked = probability * (!light.IsDelta ? 1f / sample.InversePdf : IsFar[number] ? 1f : sample.Distance * sample.Distance);
        FloatW others = light.IsDelta ? 0f : PathWeights.Power(at.Pdf / asked);
        if ((_strategies & Strategies.Camera) != Strategies.None)
        {
            light.EmissionPdf(at.Surface.Point, sample, at.Time, out FloatW point, out FloatW direction);
            FloatW emission = point * direction * _pass.Emission.Probability((uint)number);
            FloatW towards = emission * Meeting(at.Surface, sample.Direction) / (asked * sample.Cosine * Weights.PerLightPath);
            Adjoint.ReversePdf(group.Material, ref at.Surface, sample.Direction, out FloatW reversePdf);
            others = FloatW.MultiplyAdd(PathWeights.Power(towards), at.Sums.Connected(reversePdf, Weights.At(group)), others);
        }

        RgbW left = Rgb.White;
        if (Scene.TracksInteriors)
        {
            Follow(group, active, sample.Direction, sample.Distance, light, out left, out FloatW passed);
            others *= PathWeights.Power(passed);
        }

        FloatW cosine = Cosine(at.Surface, sample.Direction);
        FloatW scale = cosine * Share(others) / probability;
        RgbW value = at.Throughput * brought * at.Bsdf * scale;
        if (Scene.TracksInteriors)
        {
            _traced += BitOperations.PopCount(active.Bits);
            value *= left;
            Gather(active.Bits, at.Path, value);
            _recorder?.Add(active.Bits, at.Path, Ways(sample, brought, cosine, probability, left), value, value * (others + 1f));
            return;
        }

        at.Start = Leave(at.Surface, sample.Direction);
        at.Inner = LeaveInside(at.Surface, sample.Direction);
        DirectLight.TurnTo(Vec3W.MultiplyAdd(sample.Direction, sample.Distance, at.Surface.Point - at.Start), ref sample.Direction, ref sample.Distance);
        _traced += BitOperations.PopCount(active.Bits);
        Scene.Primitives.Occlude(at.Start, sample.Direction, sample.Distance, light.OwnPrimitive, ref active);
        if (active.Any)
        {
            _rays.Add(active.Bits, at.Start, group.IsInstanced ? at.Surface.Instance : 0u, at.Inner, sample.Direction, sample.Distance, at.Time, number, value, 0f, at.Path);
            _recorder?.Wait(active.Bits, Ways(sample, brought, cosine, probability, left), value * (others + 1f));
        }
    }

    // Of paths that end at a chosen point of a light.
    private WaysW Ways(in ShapeSampleW sample, in RgbW brought, FloatW cosine, FloatW probability, in RgbW left) => new()
    {
        From = 1u,
        To = At.Number + 2u,
        Point = Vec3W.MultiplyAdd(sample.Direction, FloatW.Min(sample.Distance, FarAway), At.Surface.Point),
        Factors = new() { CameraPart = At.Throughput, CameraBsdf = At.Bsdf, Radiance = brought * (1f / sample.InversePdf), Left = left, Geometry = cosine, Pdf = probability / sample.InversePdf },
    };

    // The factor on light whose path has a wavelength where the camera's has none yet.
    private RgbW WavelengthColor()
    {
        RgbW color = Rgb.White;
        if (Scene.Wavelengths is not null)
        {
            Scene.Wavelengths.Sample(Vertex.Wavelength(), out _, out color);
            color = UIntW.Equal(At.State & PathState.HasWavelength, 0u).Select(color, Rgb.White);
        }

        return color;
    }

    private void TraceRays()
    {
        _rays.Trace();
        for (int i = 0; i < _rays.Count; i++)
        {
            if (_rays.Hits[i] < 0)
            {
                float* sum = _gathered.Pointer + _rays.Owners[i];
                sum[0] += _rays.Load(0, i);
                sum[_stride] += _rays.Load(1, i);
                sum[2 * _stride] += _rays.Load(2, i);
            }
        }

        _recorder?.Settle(_rays);
        _rays.Clear();
    }

    private void Gather(uint lanes, in UIntW path, in RgbW light)
    {
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            float* sum = _gathered.Pointer + path[lane];
            sum[0] += light.R[lane];
            sum[_stride] += light.G[lane];
            sum[2 * _stride] += light.B[lane];
        }
    }
}
