using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Extensions.Tests;

/// <summary>Surfaces in the light of a lamp beside the camera that is as bright at every distance.</summary>
public sealed class HeadlightIntegrator() : Integrator("headlight", IntegratorTraits.Light)
{
    /// <inheritdoc/>
    protected override SurfaceShader CreateShader(ShaderContext context) => new Shader(context);

    private sealed unsafe class Shader(ShaderContext context) : SurfaceShader(context)
    {
        protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active)
        {
            Describe(Scene, group, stream, index, group.Traits.UsesUv, out SurfaceW surface);
            group.Material.Albedo(surface, out RgbW albedo);
            Finished.Append(active.Bits, albedo * surface.Cosine, UIntW.Pick(stream.Path, index));
        }
    }
}
