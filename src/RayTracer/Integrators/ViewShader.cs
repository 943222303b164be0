using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Shows something of the surfaces that camera rays meet, as colours: for looking for mistakes in a scene.</summary>
internal abstract unsafe class ViewShader(ShaderContext context, bool usesUv) : SurfaceShader(context)
{
    /// <summary>The colours that are shown.</summary>
    protected abstract void Color(Material material, in SurfaceW surface, out RgbW color);

    protected override void Arrive(PathStream stream, uint* index, in Vec3W direction, out RgbW arriving) => arriving = default;

    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        UIntW path = UIntW.Pick(stream.Path, index);
        Describe(Scene, group, stream, index, group.Traits.UsesUv || usesUv, out SurfaceW surface);
        Color(group.Material, surface, out RgbW color);
        Observer?.Emitted(group, stream, index, active, color, color);
        ScatterW scatter = default;
        Observer?.Scattered(stream, index, active, MaskW.None, group.Material, surface, scatter, isByLobe: false);
        Finished.Append(active.Bits, color, path);
    }
}

/// <summary>The view of shading normals.</summary>
internal sealed class NormalsIntegrator() : Integrator("normals", IntegratorTraits.None)
{
    protected internal override SurfaceShader CreateShader(ShaderContext context) => new Shader(context);

    private sealed class Shader(ShaderContext context) : ViewShader(context, usesUv: false)
    {
        protected override void Color(Material material, in SurfaceW surface, out RgbW color) =>
            color = new(Half(surface.Facing.X), Half(surface.Facing.Y), Half(surface.Facing.Z));

        private static FloatW Half(FloatW x) => FloatW.MultiplyAdd(x, 0.5f, 0.5f);
    }
}

/// <summary>The view of surface coordinates.</summary>
internal sealed class UvIntegrator() : Integrator("uv", IntegratorTraits.None)
{
    protected internal override SurfaceShader CreateShader(ShaderContext context) => new Shader(context);

    private sealed class Shader(ShaderContext context) : ViewShader(context, usesUv: true)
    {
        protected override void Color(Material material, in SurfaceW surface, out RgbW color) =>
            color = new(surface.U - FloatW.Floor(surface.U), surface.V - FloatW.Floor(surface.V), 0f);
    }
}

/// <summary>The view of how much light surfaces send on.</summary>
internal sealed class AlbedoIntegrator() : Integrator("albedo", IntegratorTraits.None)
{
    protected internal override SurfaceShader CreateShader(ShaderContext context) => new Shader(context);

    private sealed class Shader(ShaderContext context) : ViewShader(context, usesUv: false)
    {
        protected override void Color(Material material, in SurfaceW surface, out RgbW color) => material.Albedo(surface, out color);
    }
}
