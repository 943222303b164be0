using RayTracer.Rendering;

namespace RayTracer.Description;

/// <summary>An integrator that traces light from its sources: a choice among the <see cref="Rendering.Strategies"/>.</summary>
/// <param name="name">The name in scene files.</param>
/// <param name="strategies">The ways in which it makes paths.</param>
internal abstract class LightTracingIntegrator(string name, Strategies strategies) : Integrator(
    name, IntegratorTraits.Light | IntegratorTraits.Media | IntegratorTraits.Priorities | IntegratorTraits.LiteralNormals | IntegratorTraits.SampledEnvironment | IntegratorTraits.LitGloss | IntegratorTraits.PathLimit
        | IntegratorTraits.SoftTone | IntegratorTraits.TracesLight | ((strategies & Strategies.Merges) != Strategies.None ? IntegratorTraits.MergesPaths : IntegratorTraits.None))
{
    /// <summary>The ways in which it makes paths.</summary>
    public Strategies Strategies => strategies;

    /// <inheritdoc/>
    protected internal sealed override SurfaceShader CreateShader(ShaderContext context) => new CameraSubpaths(context, strategies);
}
