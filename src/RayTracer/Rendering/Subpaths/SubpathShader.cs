using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What subpaths do where they meet a surface, from the camera or from a light: they bring their partial sums along, are connected there by those who
/// know how, and go on. <see cref="LightSubpaths"/> and <see cref="CameraSubpaths"/> say what is different between the two.
/// </summary>
/// <param name="context">The context that it works in.</param>
internal abstract unsafe class SubpathShader(ShaderContext context) : SurfaceShader(context)
{
    private const float LargestSurvival = 0.95f;
    private readonly PinnedBuffer<VertexW> _at = new(1);

    /// <summary>The number of edges that a whole path may have.</summary>
    protected uint MaxDepth { get; } = context.Scene.Render.MaxDepth < 0 ? RenderDescription.LongestPath : (uint)context.Scene.Render.MaxDepth;

    /// <summary>The constants of the weights; set when a pass begins.</summary>
    protected PathWeights Weights { get; set; } = new(1, 1, 0);

    /// <summary>What camera paths see of what is behind everything; null where nobody asks.</summary>
    private protected Backdrop? Backdrop { get; } = context.Backdrop;

    /// <summary>The packet of vertices at work.</summary>
    protected ref VertexW At => ref *_at.Pointer;

    /// <inheritdoc/>
    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, MaskW active)
    {
        ref VertexW at = ref At;
        at.Path = UIntW.Pick(stream.Path, index);
        at.State = UIntW.Pick(stream.State, index);
        at.Number = at.State & PathState.VertexMask;
        Begin(at.Path, at.Number);
        Describe(Scene, group, stream, index, group.Traits.UsesUv, out at.Surface);
        at.Throughput = stream.PickThroughput(index);
        at.Time = Scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        at.Distance = FloatW.Pick(stream.Distance, index);
        at.Cosine = FloatW.Abs(Vec3W.Dot(at.Surface.Incoming, at.Surface.Normal));
        at.Sums.Vcm = FloatW.Pick(stream.Vcm, index);
        at.Sums.Vc = FloatW.Pick(stream.Vc, index);
        at.Sums.Vm = FloatW.Pick(stream.Vm, index);
        Arrive(group, stream, index, UIntW.Equal(at.Number, 0u));
        if (group.Traits.Disperses)
        {
            Disperse(at.State, ref at.Surface, ref at.Throughput);
            at.State |= PathState.HasWavelength;
        }

        MaskW goesOn = Visit(group, stream, index, active);
        if (goesOn.Any)
        {
            GoOn(group, goesOn, next);
        }
    }

    /// <summary>Turns to the random numbers of vertices, of which camera and light have their own.</summary>
    /// <param name="path">Numbers of the paths.</param>
    /// <param name="number">Numbers of the vertices on them, from 0.</param>
    protected abstract void Begin(in UIntW path, in UIntW number);

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

    private void GoOn(ShadingGroup group, MaskW alive, PathStream next)
    {
        ref VertexW at = ref At;
        ref ScatterW scatter = ref at.Scatter;
        Choose(group, ref at.Surface, out scatter, out at.Pdf, out at.ReversePdf);
        alive = alive.Except(scatter.Absorbed).Except(Ending(scatter.Delta));
        alive = Survive(alive, scatter.Weight, ref at.Throughput);
        uint going = alive.Bits;
        if (going == 0)
        {
            return;
        }

        Backdrop?.Leave(at.Path, alive, at.Surface, scatter);
        at.Sums.Leave(FloatW.Abs(Vec3W.Dot(scatter.Direction, at.Surface.Normal)), at.Pdf, at.ReversePdf, scatter.Delta, Weights);
        if (Scene.IsTimed)
        {
            next.SetTime(going, at.Time);
        }

        UIntW state = (at.Number + 1u) | WavelengthAfter(group, at.State) | scatter.Delta.Select((UIntW)0u, PathState.HasScattered) | (at.State & PathState.HasScattered);
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
    }

    // Ends paths at random by what a bounce takes of them, and makes those that survive brighter: the same for both directions, whatever the strength of
    // a light.
    private MaskW Survive(MaskW alive, in RgbW weight, ref RgbW throughput)
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

        FloatW left = after / before;
        FloatW survival = (left < LargestSurvival).Select(left, LargestSurvival);
        throughput *= asked.Select(1f / survival, 1f);
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
