using System.Numerics;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Path tracing (Kajiya 1986): what light the surface sends, light from the sources, and the choice of the next ray. Light that both a light's
/// sampling and the scattered ray can find is weighted between the two by multiple importance sampling (Veach 1997, section 9.2, power
/// heuristic); paths that carry little end at random, and the others make up for them (Arvo &amp; Kirk 1990).
/// </summary>
internal sealed unsafe class PathShader(Scene scene, FinishedPaths finished, ShadowQueue? queue, PathRecorder? recorder) : SurfaceShader(scene, finished, recorder)
{
    private const uint DepthBits = 0xffff;
    private const float LargestSurvival = 0.95f;
    private readonly DirectLight _directLight = new(scene, queue);
    private readonly LightMap _lights = new(scene);
    private readonly uint _maxDepth = scene.Render switch
    {
        { Integrator: Description.Integrator.Direct } => 2u,
        { MaxDepth: < 0 } => Description.RenderDescription.LongestPath,
        _ => (uint)scene.Render.MaxDepth,
    };

    public override long ShadowRays => _directLight.ShadowRays;

    public override void Flush(PathStream next) => queue?.Flush(Finished, next);

    protected override void Arrive(PathStream stream, uint* index, in Vec3W direction, out RgbW arriving)
    {
        arriving = default;
        if (_maxDepth == 0)
        {
            return;
        }

        base.Arrive(stream, index, direction, out arriving);
        MaskW shared = UIntW.Equal(UIntW.Pick(stream.State, index) & PathState.CountsEmission, 0u);
        if (Scene.Environment is not null && shared.Any)
        {
            Scene.Environment.Pdf(direction, out FloatW pdf);
            arriving *= shared.Select(DirectLight.Weight(FloatW.Pick(stream.Pdf, index), pdf), 1f);
        }
    }

    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, MaskW active)
    {
        UIntW path = UIntW.Pick(stream.Path, index);
        UIntW state = UIntW.Pick(stream.State, index);
        UIntW vertex = state & DepthBits;
        BeginVertex(path, vertex);
        Describe(Scene, group, stream, index, group.UsesUv, out SurfaceW surface);
        FloatW time = Scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        RgbW throughput = stream.PickThroughput(index);
        RgbW radiance = stream.PickRadiance(index);
        Material material = group.Material;
        if (group.Emits && _maxDepth > 0)
        {
            AddEmission(group, surface, stream, index, active.Except(~UIntW.Equal(state & PathState.CountsEmission, 0u)), time, throughput, ref radiance);
        }

        Recorder?.Emitted(path, active, radiance);
        Recorder?.Brightened(path, active, radiance);

        // A path of so many edges may have one more: the ray to a light, or the next one.
        MaskW goesOn = active & (vertex + 1u < _maxDepth);
        if (group.HasDensity)
        {
            if (queue is { IsFull: true })
            {
                queue.Flush(Finished, next);
            }

            _directLight.Add(surface, material, group.HasShadingNormals, Vertex, time, goesOn, throughput, ref radiance);
        }

        material.Scatter(surface, Vertex, out ScatterW scatter);
        throughput *= scatter.Weight;
        MaskW alive = goesOn.Except(scatter.Absorbed).Except((throughput.R <= 0f) & (throughput.G <= 0f) & (throughput.B <= 0f));
        if (group.HasShadingNormals)
        {
            alive = alive.Except(Leaks(surface, scatter.Direction));
        }

        Survive(vertex, ref alive, ref throughput);
        Recorder?.Scattered(stream, index, active, alive, material, surface, scatter);
        uint going = alive.Bits;
        uint ended = active.Bits & ~going;
        if (queue is not null && group.HasDensity)
        {
            queue.End(ended, Finished.Count, going, next.Count);
        }

        if (ended != 0)
        {
            Finished.Append(ended, radiance, path);
        }

        if (going != 0)
        {
            GoOn(group, surface, scatter, time, going, throughput, radiance, path, vertex, next);
        }
    }

    private void GoOn(
        ShadingGroup group, in SurfaceW surface, in ScatterW scatter, in FloatW time, uint going, in RgbW throughput, in RgbW radiance, UIntW path, UIntW vertex, PathStream next)
    {
        if (Scene.IsTimed)
        {
            next.SetTime(going, time);
        }

        if (group.HasDensity && _lights.Count > 0)
        {
            group.Material.Pdf(surface, scatter.Direction, out FloatW pdf);
            next.SetPdf(going, pdf);
        }

        UIntW emission = group.HasDensity && _lights.Count > 0 ? scatter.Delta.Select((UIntW)PathState.CountsEmission, 0u) : PathState.CountsEmission;
        next.Append(going, Leave(surface, scatter.Direction), scatter.Direction, throughput, radiance, path, (vertex + 1u) | emission);
    }

    // Ends paths at random, and makes those that go on brighter, so that the mean stays.
    private void Survive(UIntW vertex, ref MaskW alive, ref RgbW throughput)
    {
        MaskW asked = alive & (vertex + 1u > (uint)Scene.Render.RouletteDepth);
        if (!asked.Any)
        {
            return;
        }

        FloatW most = FloatW.Max(throughput.R, FloatW.Max(throughput.G, throughput.B));

        // Written so that a path whose throughput is not a number goes on, and is counted at its end.
        FloatW survival = (most < LargestSurvival).Select(most, LargestSurvival);
        alive = alive.Except(asked & (Vertex.Roulette() >= survival));
        throughput *= asked.Select(1f / survival, 1f);
    }

    // Light of the surface itself: in full where no light could have been sampled for it, and weighted else.
    private void AddEmission(
        ShadingGroup group, in SurfaceW surface, PathStream stream, uint* index, MaskW shared, FloatW time, in RgbW throughput, ref RgbW radiance)
    {
        FloatW cosine = CosineOfEmission(surface);
        group.Material.Emission(cosine, surface.U, surface.V, out RgbW emitted);
        shared &= cosine > 0f;
        if (shared.Any)
        {
            LightHitW hit = new()
            {
                From = stream.PickOrigin(index),
                Direction = surface.Incoming,
                Distance = FloatW.Pick(stream.Distance, index),
                Cosine = cosine,
                Time = time,
                Primitive = UIntW.Pick(stream.Primitive, index),
            };
            _lights.Pdf(group, Scene.World.Instances is null ? 0u : UIntW.Pick(stream.Instance, index), hit, shared, out FloatW lightPdf);
            emitted *= shared.Select(DirectLight.Weight(FloatW.Pick(stream.Pdf, index), lightPdf), 1f);
        }

        radiance = RgbW.MultiplyAdd(throughput, emitted, radiance);
    }
}
