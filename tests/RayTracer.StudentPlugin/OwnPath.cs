using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.StudentPlugin;

/// <summary>The name of <see cref="OwnPath"/> in scene files.</summary>
public sealed class OwnPathName() : TextbookIntegrator("ownPath")
{
    /// <inheritdoc/>
    public override IIntegrator Make(RenderDescription render) => new OwnPath(render.MaxDepth < 0 ? 20 : render.MaxDepth);
}

/// <summary>Paths that find light by chance alone.</summary>
/// <param name="edges">The largest number of edges.</param>
public sealed class OwnPath(int edges) : IIntegrator
{
    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler) => Follow(scene, ray, sampler, edges);

    private static Rgb Follow(Scene scene, Ray ray, ISampler sampler, int left)
    {
        if (!scene.Intersect(ray, out Hit hit))
        {
            return scene.Environment?.Radiance(ray.Direction) ?? default;
        }

        Rgb light = hit.Thing!.Light?.Radiance(ray.Direction, hit) ?? default;
        return left > 1 && hit.Thing.Material.Sample(hit, hit.Frame.ToLocal(-ray.Direction), sampler) is { } s
            ? light + (s.Weight * Follow(scene, hit.Leave(hit.Frame.ToWorld(s.Direction)), sampler, left - 1)) : light;
    }
}
