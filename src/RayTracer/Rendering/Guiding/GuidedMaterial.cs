using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// A material whose paths go on in directions that a guide chooses, or it itself, at random: the density is the mean of both, and the weight
/// of a direction that may have come from either is BSDF · |cosine| / that (the one-sample model of Veach 1997, section 9.2.4, with the
/// balance heuristic). Single directions are chosen by the material alone. One thread has it.
/// </summary>
/// <param name="guide">The guide.</param>
/// <param name="inner">The material.</param>
internal sealed unsafe class GuidedMaterial(PathGuide guide, Material inner) : WrapperMaterial(inner)
{
    private const float GuidedShare = 0.5f;
    private readonly PinnedBuffer<StateW> _state = new(1);

    /// <summary>
    /// The chance that guided paths survive where others end for their throughput: that says little of the light that they are on their
    /// way to (Vorba &amp; Křivánek 2016).
    /// </summary>
    public const float Survival = 0.9f;

    /// <summary>The densities with which the last directions were chosen.</summary>
    public ref readonly FloatW ChosenPdf => ref _state.Pointer->Pdf;

    /// <summary>Turns to a packet of points.</summary>
    public void Begin(in SurfaceW surface)
    {
        ref StateW state = ref *_state.Pointer;
        state.Root = guide.Find(surface.Point);
        state.Share = UIntW.Equal(state.Root, 0u).Select(0f, GuidedShare);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        ref StateW state = ref *_state.Pointer;
        MaskW guided = samples.Choose(state.Share, out FloatW rest);
        samples.Leave(rest);
        Inner.Scatter(surface, samples, out scatter);
        ChooseDirections(guided, samples, ref scatter);
        Inner.Evaluate(surface, scatter.Direction, out state.Bsdf, out FloatW own);
        state.Pdf = Mixed(own, state.Density);
        FloatW cosine = FloatW.Abs(Vec3W.Dot(scatter.Direction, surface.Facing));
        RgbW mixed = state.Bsdf * (state.Pdf > 0f).Select(cosine / state.Pdf, 0f);
        scatter.Weight = scatter.Delta.Select(scatter.Weight * (1f / (1f - state.Share)), mixed);
    }

    /// <inheritdoc/>
    protected override void Dim(in SurfaceW surface, in Vec3W direction, ref RgbW bsdf, ref FloatW pdf)
    {
        ref StateW state = ref *_state.Pointer;
        GuideMap.ToSquare(direction, out state.U, out state.V);
        state.Density = guide.Density(state.Root, state.U, state.V);
        pdf = Mixed(pdf, state.Density);
    }

    // One descent: by random numbers in lanes that are guided, to the directions that there are in the others.
    private void ChooseDirections(in MaskW guided, VertexSamples samples, ref ScatterW scatter)
    {
        ref StateW state = ref *_state.Pointer;
        samples.Direction(out FloatW u, out FloatW v);
        GuideMap.ToSquare(scatter.Direction, out state.U, out state.V);
        (state.U, state.V) = (guided.Select(u, state.U), guided.Select(v, state.V));
        guide.Descend(state.Root, guided, ref state.U, ref state.V, out state.Density);
        if (guided.Any)
        {
            scatter.Direction = guided.Select(GuideMap.ToDirection(state.U, state.V), scatter.Direction);
            scatter.Specular = scatter.Specular.Except(guided);
            scatter.Delta = scatter.Delta.Except(guided);
            scatter.Absorbed = scatter.Absorbed.Except(guided);
        }
    }

    private FloatW Mixed(in FloatW own, in FloatW density) =>
        FloatW.MultiplyAdd(_state.Pointer->Share, FloatW.MultiplyAdd(density, 1f / GuideMap.Solid, -own), own);

    private struct StateW
    {
        public UIntW Root;
        public FloatW Share;
        public FloatW U, V;
        public FloatW Density;
        public FloatW Pdf;
        public RgbW Bsdf;
    }
}
