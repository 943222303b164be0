using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What subpaths do where they meet a surface, from the camera or from a light: they bring their partial sums along, are connected there by those who
/// know how, and go on. <see cref="LightSubpaths"/> and <see cref="CameraSubpaths"/> say what is different between the two.
/// </summary>
/// <param name="context">The context that it works in.</param>
internal abstract unsafe class SubpathShader(ShaderContext context) : InteriorShader(context)
{
    private const float LargestSurvival = 0.95f;
    private readonly Transmittance? _transmittance = context.Scene.TracksInteriors ? new(context.Scene) : null;
    private readonly PinnedBuffer<VertexW> _at = new(1);

    /// <summary>The number of edges that a whole path may have.</summary>
    protected uint MaxDepth { get; } = context.Scene.Render.MaxDepth < 0 ? RenderDescription.LongestPath : (uint)context.Scene.Render.MaxDepth;

    /// <summary>The lights.</summary>
    protected LightSource[] Lights { get; } = [.. context.Scene.SampledLights];

    /// <summary>Of each light, whether it is infinitely far away.</summary>
    protected bool[] IsFar { get; } = FarAmong(context.Scene);

    /// <summary>The constants of the weights; set when a pass begins.</summary>
    protected PathWeights Weights { get; set; } = new(1, 1, 0);

    /// <summary>The packet of vertices at work.</summary>
    protected ref VertexW At => ref *_at.Pointer;

    /// <inheritdoc/>
    internal override void SampleMedia(PathStream stream)
    {
        base.SampleMedia(stream);
        for (int i = 0; Scene.HasMedia && i < stream.Count; i += FloatW.Count)
        {
            UIntW media = MaskW.First(stream.Count - i).Select(UIntW.Load(stream.Media + i), 0u);
            Vec3W direction = new(FloatW.Load(stream.DirectionX + i), FloatW.Load(stream.DirectionY + i), FloatW.Load(stream.DirectionZ + i));
            RgbW left = MediumTable.Transmittance(Scene.Media.Extinction(media, direction), FloatW.Load(stream.Distance + i));
            FloatW before = (FloatW.Load(stream.Travelled + i) > 0f).Select(FloatW.Load(stream.Passed + i), 1f);
            (before * Scene.Media.MeanPassing(media, left)).Store(stream.Passed + i);
        }
    }

    /// <inheritdoc/>
    internal override void Scatter(PathStream stream, PathStream next, uint* members, int count) =>
        Shade(Scene.GroupOfMedia, stream, next, members, count);

    /// <inheritdoc/>
    protected override void Carry(PathStream stream, PathStream next, uint* index, uint going)
    {
        next.SetSums(going, new() { Vcm = FloatW.Pick(stream.Vcm, index), Vc = FloatW.Pick(stream.Vc, index), Vm = FloatW.Pick(stream.Vm, index) });
        next.SetPassed(going, FloatW.Pick(stream.Passed, index));
    }

    /// <inheritdoc/>
    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        ref VertexW at = ref At;
        at.Path = UIntW.Pick(stream.Path, index);
        at.State = UIntW.Pick(stream.State, index);
        at.Number = at.State & PathState.VertexMask;
        BeginVertex(at.Path, at.Number);
        DescribeVertex(Scene, group, stream, index, out at.Surface);
        MaskW lanes = active;
        if (Scene.TracksInteriors)
        {
            at.Media = UIntW.Pick(stream.Media, index);
            MaskW crossed = Unreal(group);
            Cross(group, at.Surface, stream, next, index, lanes & crossed);
            lanes = lanes.Except(crossed);
            if (!lanes.Any)
            {
                return;
            }
        }

        at.Throughput = stream.PickThroughput(index);
        at.Time = Scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        at.Distance = FloatW.Pick(stream.Distance, index);
        at.Distance = Scene.TracksInteriors ? at.Distance + FloatW.Pick(stream.Travelled, index) : at.Distance;
        at.Cosine = Meeting(at.Surface, at.Surface.Incoming);
        at.Sums.Vcm = FloatW.Pick(stream.Vcm, index);
        at.Sums.Vc = FloatW.Pick(stream.Vc, index);
        at.Sums.Vm = FloatW.Pick(stream.Vm, index);
        Arrive(group, stream, index, UIntW.Equal(at.Number, 0u));
        if (Scene.HasMedia)
        {
            at.Sums.Pass(FloatW.Pick(stream.Passed, index));
        }

        if (group.Traits.Disperses)
        {
            Disperse(UIntW.Equal(at.State & PathState.HasWavelength, 0u), ref at.Surface, ref at.Throughput);
            at.State |= PathState.HasWavelength;
        }

        if (Scene.HasNesting && group.IsNested)
        {
            Scene.Media.Index(Around(Scene, group, at.Surface, at.Media), at.Surface.Wavelength, out at.Surface.ExteriorIndex);
        }

        MaskW goesOn = Visit(group, stream, index, lanes);
        MaskW alive = goesOn.Any ? GoOn(group, goesOn, next) : MaskW.None;
        if (Observer is not null)
        {
            Report(group, stream, index, lanes, goesOn, alive);
        }
    }

    /// <summary>Brings the partial sums to the vertices.</summary>
    /// <param name="group">The group of surfaces.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="first">The lanes that are at the first vertex after the camera or the light.</param>
    protected abstract void Arrive(ShadingGroup group, PathStream stream, uint* index, MaskW first);

    /// <summary>Does all that ends at the vertices, and returns the lanes that may go on.</summary>
    /// <param name="group">The group of surfaces.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="active">The lanes in use.</param>
    protected abstract MaskW Visit(ShadingGroup group, PathStream stream, uint* index, MaskW active);

    /// <summary>Chooses how paths go on.</summary>
    /// <param name="group">The group of surfaces.</param>
    /// <param name="surface">The vertices.</param>
    /// <param name="scatter">The next rays.</param>
    /// <param name="pdf">The density of their directions; of no meaning for delta lobes.</param>
    /// <param name="reversePdf">The density of the way back.</param>
    protected abstract void Choose(ShadingGroup group, ref SurfaceW surface, out ScatterW scatter, out FloatW pdf, out FloatW reversePdf);

    /// <summary>The lanes that shall not go on, by whether their next ray was chosen by a delta lobe.</summary>
    protected virtual MaskW Ending(MaskW delta) => MaskW.None;

    /// <summary>Describes vertices, also those in media.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void DescribeVertex(Scene scene, ShadingGroup group, PathStream stream, uint* index, out SurfaceW surface)
    {
        if (group.IsOfMedia)
        {
            MediumMaterial.Describe(scene.Media, stream, index, out surface);
            return;
        }

        Describe(scene, group, stream, index, group.Traits.UsesUv, out surface);
    }

    /// <summary>Traces shadow rays from the vertices through all that paths pass without a vertex.</summary>
    /// <param name="group">The group of surfaces.</param>
    /// <param name="active">The lanes.</param>
    /// <param name="direction">Unit directions to what they end at.</param>
    /// <param name="distance">Its distance.</param>
    /// <param name="light">The light that they end at; null for a point.</param>
    /// <param name="left">The fraction of the light that is left.</param>
    /// <param name="passed">The probability that a path comes through the media.</param>
    protected void Follow(ShadingGroup group, MaskW active, Vec3W direction, FloatW distance, LightSource? light, out RgbW left, out FloatW passed)
    {
        ref VertexW at = ref At;
        MediaAlong(Scene, at.Surface, direction, group.Interior, at.Media, out UIntW media);
        UIntW instance = group.IsInstanced ? at.Surface.Instance : 0u;
        at.Start = Leave(at.Surface, direction);
        at.Inner = LeaveInside(at.Surface, direction);
        DirectLight.TurnTo(Vec3W.MultiplyAdd(direction, distance, at.Surface.Point - at.Start), ref direction, ref distance);
        _transmittance!.Trace(active.Bits, at.Start, instance, at.Inner, direction, distance, media, at.Time, light, out left, out passed);
    }

    private static bool[] FarAmong(Scene scene)
    {
        (double Open, double Close) shutter = (scene.Render.Shutter.X, scene.Render.Shutter.Y);
        return [.. scene.SampledLights.Select(l => !l.Extent(shutter).Box.IsFinite)];
    }

    // Where paths go through what they have met as if it were not there.
    private MaskW Unreal(ShadingGroup group)
    {
        ref VertexW at = ref At;
        if (Scene.HasMedia && group.Traits.IsBoundary)
        {
            return MaskW.All;
        }

        return Scene.HasNesting && group.IsNested
            ? IsUnreal(at.Media, Scene.Cross(at.Media, group.Interior, MaskW.All, ~ComesFromInside(at.Surface)))
            : MaskW.None;
    }

    private void Report(ShadingGroup group, PathStream stream, uint* index, MaskW active, MaskW goesOn, MaskW alive)
    {
        ref VertexW at = ref At;
        if (group.IsOfMedia)
        {
            Observer!.ScatteredInMedium(stream, index, active, alive, at.Surface.Point, at.Pdf);
            return;
        }

        at.Scatter.Absorbed &= goesOn;
        Observer!.Scattered(stream, index, active, alive, group.Material, at.Surface, at.Scatter, isByLobe: false);
    }

    // Returns the lanes that have a next ray.
    private MaskW GoOn(ShadingGroup group, MaskW alive, PathStream next)
    {
        ref VertexW at = ref At;
        ref ScatterW scatter = ref at.Scatter;
        Choose(group, ref at.Surface, out scatter, out at.Pdf, out at.ReversePdf);
        alive = alive.Except(scatter.Absorbed).Except(Ending(scatter.Delta));
        alive = Survive(group, alive, ref scatter.Weight, ref at.Throughput);
        uint going = alive.Bits;
        if (going == 0)
        {
            return alive;
        }

        at.Sums.Leave(Meeting(at.Surface, scatter.Direction), at.Pdf, at.ReversePdf, scatter.Delta, Weights.At(group));
        if (Scene.IsTimed)
        {
            next.SetTime(going, at.Time);
        }

        if (Scene.TracksInteriors)
        {
            MediaAlong(Scene, at.Surface, scatter.Direction, group.Interior, at.Media, out UIntW media);
            next.SetMedia(going, MediumStack.Scattered(media), 0f);
        }

        UIntW scattered = group.IsOfMedia ? 0u : scatter.Delta.Select((UIntW)0u, PathState.HasScattered);
        UIntW state = (at.Number + 1u) | WavelengthAfter(group, at.State) | scattered | (at.State & PathState.HasScattered);
        next.SetSums(going, at.Sums);
        if (Scene.LightSelection is not null)
        {
            next.SetNormal(going, group.Traits.Transmits ? default : at.Surface.Facing);
        }

        at.Start = Leave(at.Surface, scatter.Direction);
        next.Append(going, at.Start, scatter.Direction, at.Throughput, default, at.Path, state);
        if (group.IsInstanced)
        {
            next.SetStart(going, at.Surface.Instance, LeaveInside(at.Surface, scatter.Direction));
        }

        return alive;
    }

    // Ends paths at random by what a bounce takes of them, and makes those that survive brighter: the same for both directions, whatever the strength of
    // a light.
    private MaskW Survive(ShadingGroup group, MaskW alive, ref RgbW weight, ref RgbW throughput)
    {
        ref VertexW at = ref At;
        FloatW before = FloatW.Max(throughput.R, FloatW.Max(throughput.G, throughput.B));
        throughput *= weight;
        FloatW after = FloatW.Max(throughput.R, FloatW.Max(throughput.G, throughput.B));
        alive = alive.Except(after <= 0f);
        MaskW asked = alive & (at.Number + 1u > (uint)Scene.Render.RouletteDepth);
        if (!asked.Any)
        {
            return alive;
        }

        // What a medium takes has been taken on the way to where it scatters.
        ref RgbW albedo = ref at.Surface.DiffuseColor;
        FloatW left = group.IsOfMedia ? FloatW.Max(albedo.R, FloatW.Max(albedo.G, albedo.B)) : after / before;
        FloatW survival = (left < LargestSurvival).Select(left, LargestSurvival);
        FloatW brighter = asked.Select(1f / survival, 1f);
        throughput *= brighter;
        if (Observer is not null)
        {
            weight *= brighter;
        }

        return alive.Except(asked & (Vertex.Roulette() >= survival));
    }

    /// <summary>A packet of vertices.</summary>
    protected struct VertexW
    {
        public ScatterW Scatter;
        public SubpathSumsW Sums;
        public RgbW Throughput;
        public UIntW Path;
        public UIntW State;
        public UIntW Number;
        public UIntW Media;
        public FloatW Time;
        public FloatW Distance;
        public FloatW Cosine;
        public FloatW Pdf;
        public FloatW ReversePdf;
        public Vec3W Start;
        public Vec3W Inner;
        public RgbW Bsdf;
        public SurfaceW Surface;
    }
}
