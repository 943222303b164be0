using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Textbook;

namespace RayTracer.Adapters;

/// <summary>
/// The name of an integrator whose class is the textbook edition's <see cref="IIntegrator"/>. Its <c>Radiance</c> asks for a scene of that edition, one ray at
/// a time, so that it is that edition which renders scenes with this name: commands choose it by themselves.
/// </summary>
/// <param name="name">The name in scene files, in camelCase.</param>
public abstract class TextbookIntegrator(string name)
    : Integrator(name, IntegratorTraits.Light | IntegratorTraits.AmbientLight | IntegratorTraits.BounceLimits | IntegratorTraits.PathLimit), IOwnIntegrator
{
    /// <inheritdoc/>
    public abstract IIntegrator Make(RenderDescription render);

    /// <inheritdoc/>
    protected internal sealed override SurfaceShader CreateShader(ShaderContext context) =>
        throw new NotSupportedException($"the integrator {Name} is rendered by the textbook edition (--edition textbook)");
}
