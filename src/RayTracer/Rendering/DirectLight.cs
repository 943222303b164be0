using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>
/// Light that arrives straight from the sources: one point of every light for every hit (report, listing 6.4), or, where there are many
/// lights, of one that is chosen; and several where paths first meet the scene (<see cref="Scene.PointsOfFirst"/>).
/// </summary>
internal sealed unsafe class DirectLight(Scene scene, ShadowQueue? queue, PathObserver? observer, StageClock? clock)
{
    // Lights whose samples are computed before their shadow rays are traced: independent chains of roots and
    // divisions then overlap in the processor (a tenth of the whole render on an AVX2 machine).
    private const int Batch = 8;

    // Of the rays from a vertex, those to lights, behind those that the path itself may follow.
    private const uint FirstShadow = 1 << 16;
    private readonly LightSource[] _lights = [.. scene.SampledLights];
    private readonly bool _varies = scene.HasVaryingMedia;
    private readonly LightSelection? _selection = scene.LightSelection;
    private readonly int _points = scene.PointsOfFirst;
    private readonly Transmittance? _transmittance = scene.TracksInteriors || scene.WeakensShadows ? new(scene) : null;

    // Where registers are whole cache lines, as on the stack they are not.
    private readonly PinnedBuffer<ShapeSampleW> _samples = new(Batch);
    private readonly PinnedBuffer<RgbW> _radiance = new(Batch);
    private readonly PinnedBuffer<LitW> _lit = new(1);

    public long ShadowRays { get; private set; }

    /// <summary>
    /// The share of one way to choose a direction among two (Veach 1997, section 9.2, power heuristic with exponent 2): pdf² / (pdf² +
    /// other²).
    /// </summary>
    /// <param name="pdf">Density of that way.</param>
    /// <param name="other">Density of the other.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Weight(FloatW pdf, FloatW other)
    {
        FloatW ratio = other / pdf;
        return 1f / FloatW.MultiplyAdd(ratio, ratio, 1f);
    }

    /// <summary>Adds the light of all sources to the radiance of a packet, or has its shadow rays wait in the queue.</summary>
    /// <param name="surface">The lit points.</param>
    /// <param name="group">The group of their surfaces.</param>
    /// <param name="shared">
    /// The material by whose whole BSDF light is scattered, and whose scattered rays find the rest of it; null where what is scattered is the
    /// same for all directions on the ray's side and <paramref name="weight"/> has it, and no scattered ray looks for lights.
    /// </param>
    /// <param name="media">The media on the ray's side; used only where paths track what they are in.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="active">Lanes in use.</param>
    /// <param name="weight">Throughput, times BRDF where light is not shared.</param>
    /// <param name="radiance">Added to.</param>
    public void Add(
        in SurfaceW surface, ShadingGroup group, Material? shared, in UIntW media, VertexSamples samples, in FloatW time, in MaskW active,
        in RgbW weight, ref RgbW radiance)
    {
        bool isLiteral = group.MayBeLiteral && scene.IsLiteral;
        Vec3W side = group.MayLeak ? surface.Inside.Select(-surface.Normal, surface.Normal) : surface.Facing;
        ref LitW lit = ref *_lit.Pointer;
        lit.Side = side;
        lit.Origin = Vec3W.MultiplyAdd(side, surface.Offset, surface.Point);
        lit.Instance = 0u;
        if (group.IsInstanced)
        {
            lit.Instance = surface.Instance;
            lit.Inner = SurfaceShader.LeaveInside(surface, side);
        }

        lit.Media = media;
        lit.Interior = shared is not null ? group.Interior : 0;
        lit.Time = time;
        lit.Transmits = shared is not null && group.Traits.Transmits;
        lit.IsSmoothed = group.MayLeak && !isLiteral;
        lit.IsLiteral = isLiteral;
        lit.Key = _varies ? samples.Stream(FirstShadow) : 0u;
        lit.LeavesByDirection = lit.Transmits || isLiteral;
        lit.From = lit.LeavesByDirection ? surface.Point : lit.Origin;
        ref RgbW arriving = ref lit.Arriving;
        arriving = default;
        queue?.Begin(weight);
        observer?.BeginLights(weight);
        lit.Share = _points > 1 ? samples.IsFirst.Select(1f / _points, 1f) : 1f;
        for (int point = 0; point < _points; point++)
        {
            MaskW lanes = point == 0 ? active : active & samples.IsFirst;
            if (!lanes.Any)
            {
                break;
            }

            lit.Point = (uint)point;
            if (_selection is null)
            {
                AddAll(surface, shared, ref lit, point, samples, lanes, ref arriving);
            }
            else
            {
                AddChosen(surface, shared, ref lit, point, samples, lanes, ref arriving);
            }
        }

        if (queue is null)
        {
            radiance = RgbW.MultiplyAdd(weight, arriving, radiance);
        }
    }

    /// <summary>Adds the light of all sources that a medium scatters back along the ray.</summary>
    /// <param name="point">The lit points.</param>
    /// <param name="incoming">Unit directions of the rays.</param>
    /// <param name="media">The media there.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="active">Lanes in use.</param>
    /// <param name="weight">Throughput.</param>
    /// <param name="radiance">Added to.</param>
    public void AddInMedium(
        in Vec3W point, in Vec3W incoming, in UIntW media, VertexSamples samples, in FloatW time, in MaskW active,
        in RgbW weight, ref RgbW radiance)
    {
        UIntW chosen = 0u;
        FloatW probability = 1f;
        _selection?.Choose(point, default, samples.LightChoice(), out chosen, out probability);
        for (int i = 0; i < _lights.Length; i++)
        {
            MaskW lit = _selection is null ? active : active & UIntW.Equal(chosen, (uint)i) & (probability > 0f);
            if (!lit.Any)
            {
                continue;
            }

            samples.Light(_selection is null ? i : 0, out FloatW u, out FloatW v);
            _lights[i].Sample(point, u, v, time, out ShapeSampleW sample, out RgbW light);
            lit &= sample.InversePdf > 0f;
            if (lit.Any)
            {
                ShadowRays += BitOperations.PopCount(lit.Bits);
                FloatW phase = scene.Media.Phase(media, point, incoming, sample.Direction);
                FloatW share = _lights[i].IsDelta ? phase : phase * Weight(1f, phase * sample.InversePdf / probability);
                clock?.Enter(Stage.Shadow);
                if (_varies)
                {
                    _transmittance!.Draw(samples.Stream(FirstShadow + (uint)i));
                }

                _transmittance!.Trace(lit.Bits, point, 0u, default, sample.Direction, sample.Distance, media, time, _lights[i], out RgbW part);
                clock?.Enter(Stage.Light);
                radiance = RgbW.MultiplyAdd(weight * light * (share / probability), part, radiance);
                observer?.LitInMedium(i, lit, weight * light * (share / probability) * part);
            }
        }
    }

    // A point of every light. Those without extent have only one.
    private void AddAll(in SurfaceW surface, Material? material, ref LitW lit, int point, VertexSamples samples, in MaskW active, ref RgbW arriving)
    {
        for (int first = 0; first < _lights.Length; first += Batch)
        {
            int count = Math.Min(Batch, _lights.Length - first);
            for (int i = 0; i < count; i++)
            {
                samples.Light((point * _lights.Length) + first + i, out lit.U, out lit.V);
                _lights[first + i].Sample(lit.From, lit.U, lit.V, lit.Time, out _samples.Pointer[i], out _radiance.Pointer[i]);
            }

            for (int i = 0; i < count; i++)
            {
                bool isDelta = _lights[first + i].IsDelta;
                if (isDelta && point > 0)
                {
                    continue;
                }

                if (!isDelta && _points > 1)
                {
                    _samples.Pointer[i].InversePdf *= lit.Share;
                    _radiance.Pointer[i] *= lit.Share;
                }

                ref ShapeSampleW sample = ref _samples.Pointer[i];
                Face(surface, material, ref lit, sample, active, isDelta ? MaskW.All : MaskW.None, _radiance.Pointer[i]);
                Trace(surface, ref lit, first + i, sample, lit.Free, ref arriving);
            }
        }
    }

    // One light of many for each lane; those of the same light together.
    private void AddChosen(in SurfaceW surface, Material? material, ref LitW lit, int point, VertexSamples samples, in MaskW among, ref RgbW arriving)
    {
        // Several points take one from each part of the lights.
        FloatW choice = FloatW.Min((samples.LightChoice() + point) * lit.Share, VertexSamples.LargestBelowOne);
        _selection!.Choose(lit.From, lit.Transmits ? default : surface.Facing, choice, out UIntW chosen, out FloatW probability);
        samples.Light(point, out FloatW u, out FloatW v);
        FloatW inverse = lit.Share / probability;
        ref ShapeSampleW sample = ref _samples.Pointer[0];
        ref RgbW radiance = ref _radiance.Pointer[0];
        (sample, radiance) = (default, default);
        MaskW delta = MaskW.None;
        MaskW active = among & (probability > 0f);
        for (MaskW rest = active; rest.Any;)
        {
            int light = First(chosen, rest, out MaskW same);
            rest = rest.Except(same);
            _lights[light].Sample(lit.From, u, v, lit.Time, out _samples.Pointer[1], out _radiance.Pointer[1]);
            ref ShapeSampleW one = ref _samples.Pointer[1];
            sample.Direction = same.Select(one.Direction, sample.Direction);
            sample.Distance = same.Select(one.Distance, sample.Distance);
            sample.InversePdf = same.Select(one.InversePdf, sample.InversePdf);
            radiance = same.Select(_radiance.Pointer[1], radiance);
            delta = _lights[light].IsDelta ? delta | same : delta;
        }

        sample.InversePdf *= inverse;
        Face(surface, material, ref lit, sample, active, delta, radiance * inverse);
        if (_transmittance is null && queue is null && observer is null && scene.Primitives.HasTree)
        {
            ShadowRays += BitOperations.PopCount(lit.Free.Bits);
            int* own = stackalloc int[FloatW.Count];
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                own[lane] = _lights[(int)chosen[lane]].OwnPrimitive;
            }

            clock?.Enter(Stage.Shadow);
            scene.Primitives.OccludeEach(
                lit.LeavesByDirection ? lit.Start : lit.Origin, lit.LeavesByDirection ? lit.Towards : sample.Direction, lit.LeavesByDirection ? lit.Distance : sample.Distance, own, ref lit.Free);
            clock?.Enter(Stage.Light);
            arriving = RgbW.MultiplyAdd(lit.Radiance, lit.Free.Select(lit.Cosine, 0f), arriving);
            return;
        }

        for (MaskW rest = lit.Free; rest.Any;)
        {
            int light = First(chosen, rest, out MaskW same);
            rest = rest.Except(same);
            Trace(surface, ref lit, light, sample, same, ref arriving);
        }
    }

    // A light that was chosen, and all the lanes that it was chosen for.
    private static int First(in UIntW chosen, in MaskW among, out MaskW same)
    {
        uint light = chosen[BitOperations.TrailingZeroCount(among.Bits)];
        same = among & UIntW.Equal(chosen, light);
        return (int)light;
    }

    // What a chosen point of a light brings if nothing is in the way, and the shadow ray that asks.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Face(in SurfaceW surface, Material? material, ref LitW lit, in ShapeSampleW sample, in MaskW lanes, in MaskW delta, in RgbW brought)
    {
        ref FloatW cosine = ref lit.Cosine;
        ref MaskW free = ref lit.Free;
        lit.Radiance = brought;
        cosine = Vec3W.Dot(sample.Direction, surface.Facing);
        free = lanes & (sample.InversePdf > 0f);
        if (lit.LeavesByDirection)
        {
            Aim(surface, sample, ref lit);
        }

        if (lit.Transmits)
        {
            if (!lit.IsLiteral)
            {
                free = free.Except(SurfaceShader.Leaks(surface, sample.Direction));
            }

            cosine = FloatW.Abs(cosine);
        }
        else
        {
            free &= cosine > 0f;
            if (lit.IsSmoothed)
            {
                // Light from behind the surface itself would come through it.
                free &= Vec3W.Dot(sample.Direction, lit.Side) > 0f;
            }
        }

        if (material is not null && free.Any)
        {
            Scatter(surface, material, sample, delta, ref free, ref lit.Radiance);
        }
    }

    // Adds what arrives from a light, unless something is in the way.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Trace(in SurfaceW surface, ref LitW lit, int light, in ShapeSampleW sample, in MaskW free, ref RgbW arriving)
    {
        uint wanted = free.Bits;
        if (wanted == 0)
        {
            return;
        }

        ref RgbW radiance = ref lit.Radiance;
        ref FloatW cosine = ref lit.Cosine;
        ref readonly Vec3W origin = ref lit.LeavesByDirection ? ref lit.Start : ref lit.Origin;
        ref readonly Vec3W towards = ref lit.LeavesByDirection ? ref lit.Towards : ref sample.Direction;
        ref readonly FloatW distance = ref lit.LeavesByDirection ? ref lit.Distance : ref sample.Distance;
        ShadowRays += BitOperations.PopCount(wanted);
        clock?.Enter(Stage.Shadow);
        if (_transmittance is not null)
        {
            SurfaceShader.MediaAlong(scene, surface, sample.Direction, lit.Interior, lit.Media, out UIntW there);
            if (_varies)
            {
                _transmittance.Draw(Hash.Mix(lit.Key + (lit.Point * (uint)_lights.Length) + (uint)light));
            }

            _transmittance.Trace(wanted, origin, lit.Instance, lit.Inner, towards, distance, there, lit.Time, _lights[light], out RgbW part);
            clock?.Enter(Stage.Light);
            arriving = RgbW.MultiplyAdd(radiance * part, cosine, arriving);
            observer?.Lit(light, free, radiance * part * cosine, isWaiting: false);
            return;
        }

        lit.Unblocked = free;
        scene.Primitives.Occlude(origin, towards, distance, _lights[light].OwnPrimitive, ref lit.Unblocked);
        clock?.Enter(Stage.Light);
        if (queue is not null)
        {
            queue.Add(lit.Unblocked.Bits, origin, lit.Instance, lit.Inner, towards, distance, lit.Time, light, radiance, cosine);
            observer?.Lit(light, lit.Unblocked, radiance * cosine, isWaiting: true);
            return;
        }

        arriving = RgbW.MultiplyAdd(radiance, lit.Unblocked.Select(cosine, 0f), arriving);
        observer?.Lit(light, lit.Unblocked, radiance * cosine, isWaiting: false);
    }

    // The shadow ray, which starts on the light's side of the surface. The sample is seen from the surface itself: a ray of its direction
    // and length from elsewhere would end beside the chosen point, or behind it.
    private static void Aim(in SurfaceW surface, in ShapeSampleW sample, ref LitW lit)
    {
        lit.Start = SurfaceShader.Leave(surface, sample.Direction);
        lit.Inner = SurfaceShader.LeaveInside(surface, sample.Direction);
        (lit.Towards, lit.Distance) = (sample.Direction, sample.Distance);
        TurnTo(Vec3W.MultiplyAdd(sample.Direction, sample.Distance, surface.Point - lit.Start), ref lit.Towards, ref lit.Distance);
    }

    /// <summary>Turns rays to a point ahead of them, so that they end there; those without an end, or past it, stay.</summary>
    /// <param name="to">From where they start to the point.</param>
    /// <param name="direction">Their unit directions.</param>
    /// <param name="distance">Their lengths.</param>
    public static void TurnTo(in Vec3W to, ref Vec3W direction, ref FloatW distance)
    {
        FloatW length = FloatW.Sqrt(Vec3W.Dot(to, to));
        MaskW isAhead = (length < float.PositiveInfinity) & (Vec3W.Dot(to, direction) > 0f);
        direction = isAhead.Select(to * (1f / length), direction);
        distance = isAhead.Select(length, distance);
    }

    // The part of a light's sample that the surface scatters, and that scattered rays leave.
    private void Scatter(in SurfaceW surface, Material material, in ShapeSampleW sample, in MaskW delta, ref MaskW free, ref RgbW radiance)
    {
        ref RgbW bsdf = ref _lit.Pointer->Bsdf;
        ref FloatW pdf = ref _lit.Pointer->Pdf;
        material.Evaluate(surface, sample.Direction, out bsdf, out pdf);
        free = free.Except((bsdf.R <= 0f) & (bsdf.G <= 0f) & (bsdf.B <= 0f));
        observer?.Split(surface, material, sample.Direction, bsdf);
        radiance *= bsdf;
        radiance *= delta.Select(1f, Weight(1f, pdf * sample.InversePdf));
    }

    // Lit points, beside their surfaces.
    private struct LitW
    {
        public Vec3W Side;
        public Vec3W Origin;
        public Vec3W From;
        public Vec3W Start;
        public Vec3W Towards;
        public Vec3W Inner;
        public UIntW Instance;
        public FloatW Distance;
        public FloatW U, V;
        public FloatW Share;
        public RgbW Arriving;
        public RgbW Radiance;
        public RgbW Bsdf;
        public FloatW Pdf;
        public FloatW Cosine;
        public MaskW Free;
        public MaskW Unblocked;
        public UIntW Media;
        public UIntW Key;
        public FloatW Time;

        // Behind the registers, which lie in whole cache lines.
        public uint Interior;
        public uint Point;
        public bool Transmits;
        public bool IsSmoothed;
        public bool IsLiteral;
        public bool LeavesByDirection;
    }
}
