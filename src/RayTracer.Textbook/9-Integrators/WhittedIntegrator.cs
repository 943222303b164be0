namespace RayTracer.Textbook;

/// <summary>
/// Ray tracing as it began (Whitted, An improved illumination model for shaded display, 1980): light from the lamps where a ray meets a surface, and
/// two more rays at glass, one reflected and one refracted. Light that was scattered by a matt surface before is left to ambient light.
/// </summary>
/// <param name="maxDepth">The largest number of mirrors and glass surfaces on a path.</param>
public sealed class WhittedIntegrator(int maxDepth) : IIntegrator
{
    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler) => Trace(scene, ray, sampler, maxDepth);

    private static Rgb Trace(Scene scene, Ray ray, ISampler sampler, int depth)
    {
        if (!scene.Intersect(ray, out Hit hit))
        {
            return LightSampling.FromAround(scene, ray, pdf: 0);
        }

        IMaterial material = hit.Thing!.Material;
        Vector toViewer = hit.Frame.ToLocal(-ray.Direction);
        Rgb color = LightSampling.Emitted(scene, ray, hit, pdf: 0);
        color += scene.Ambient * material.Ambient(hit, toViewer);
        foreach (ILight light in scene.Lights)
        {
            if (light is not EnvironmentLight)
            {
                color += LightSampling.FromLight(scene, light, hit, sampler, (in Hit at, Vector toLight) => material.Evaluate(at, toViewer, toLight));
            }
        }

        if (depth > 0)
        {
            foreach (Scattering mirror in material.Mirrors(hit, toViewer))
            {
                color += mirror.Weight * Trace(scene, hit.Leave(hit.Frame.ToWorld(mirror.Direction)), sampler, depth - 1);
            }
        }

        return color;
    }
}
