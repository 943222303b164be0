using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// Ambient occlusion (Landis 2002): from where a camera ray meets a surface, a ray in a direction that is chosen in proportion to the cosine brings
/// white light, unless it meets something near.
/// </summary>
internal sealed unsafe class OcclusionShader(ShaderContext context) : SurfaceShader(context)
{
    private readonly float _reach = context.Scene.Render.OcclusionDistance > 0 ? context.Scene.Render.OcclusionDistance : float.PositiveInfinity;

    protected override void Arrive(PathStream stream, uint* index, in Vec3W direction, out RgbW arriving) => arriving = Numerics.Rgb.White;

    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        UIntW path = UIntW.Pick(stream.Path, index);
        MaskW isSecond = ~UIntW.Equal(UIntW.Pick(stream.State, index) & PathState.DepthMask, 0u);
        BeginVertex(path, 0u);
        Describe(Scene, group, stream, index, group.Traits.UsesUv, out SurfaceW surface);
        FloatW far = (FloatW.Pick(stream.Distance, index) > _reach).Select(1f, 0f);
        RgbW radiance = new(far, far, far);
        Observer?.Emitted(group, stream, index, active, radiance, radiance);

        Vertex.Direction(out FloatW u, out FloatW v);
        Onb.FromNormal(surface.Facing, out Onb frame);
        ScatterW scatter = new() { Direction = frame.ToWorld(Warp.CosineHemisphere(u, v)), Weight = Numerics.Rgb.White, Absorbed = MaskW.None };
        MaskW alive = active.Except(isSecond);
        if (group.MayLeak)
        {
            alive = alive.Except(Leaks(surface, scatter.Direction));
        }

        Observer?.Scattered(stream, index, active, alive, group.Material, surface, scatter, isByLobe: false);
        uint going = alive.Bits;
        uint ended = active.Bits & ~going;
        if (ended != 0)
        {
            RgbW arrived = isSecond.Select(radiance, default);
            Finished.Append(ended, arrived, path);
        }

        if (going != 0)
        {
            if (Scene.IsTimed)
            {
                next.SetTime(going, FloatW.Pick(stream.Time, index));
            }

            next.Append(going, Leave(surface, scatter.Direction), scatter.Direction, Numerics.Rgb.White, Numerics.Rgb.Black, path, PathState.OneDiffuse);
            if (group.IsInstanced)
            {
                next.SetStart(going, surface.Instance, LeaveInside(surface, scatter.Direction));
            }
        }
    }
}

/// <summary>The integrator of ambient occlusion.</summary>
internal sealed class AoIntegrator() : Integrator("ao", IntegratorTraits.OcclusionDistance)
{
    protected internal override SurfaceShader CreateShader(ShaderContext context) => new OcclusionShader(context);
}
