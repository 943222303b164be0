namespace RayTracer.Textbook;

/// <summary>
/// Light that comes straight from its sources, found in two ways: a point of each light, which is good for small lights; and a direction of the
/// material's choice, which is good for shiny surfaces. Multiple importance sampling takes of each what it does best (Veach 1997, chapter 9).
/// </summary>
public sealed class DirectIntegrator : IIntegrator
{
    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler)
    {
        if (!scene.Intersect(ray, out Hit hit))
        {
            return LightSampling.FromAround(scene, ray, pdf: 0);
        }

        // What the camera sees shine.
        Rgb light = LightSampling.Emitted(scene, ray, hit, pdf: 0);

        // One way: a point of a light.
        Vector toViewer = hit.Frame.ToLocal(-ray.Direction);
        light += LightSampling.FromOneLight(scene, hit, toViewer, sampler);

        // The other: a direction that the material scatters in, and whatever shines there.
        if (hit.Thing!.Material.Sample(hit, toViewer, sampler) is { } scattered)
        {
            Vector direction = hit.Frame.ToWorld(scattered.Direction);
            if (!hit.Leaks(direction, scattered.Direction.Z))
            {
                Ray next = hit.Leave(direction);
                Rgb found = scene.Intersect(next, out Hit there)
                    ? LightSampling.Emitted(scene, next, there, scattered.Pdf)
                    : LightSampling.FromAround(scene, next, scattered.Pdf);
                light += Weight(hit, toViewer, scattered) * found;
            }
        }

        return light;
    }

    /// <summary>
    /// BSDF · cosine / pdf of a scattered direction, with all parts of the material: that of <see cref="Scattering.Weight"/> may be of the chosen part
    /// alone, and then the shares of the two ways would not fit together.
    /// </summary>
    internal static Rgb Weight(in Hit hit, Vector toViewer, in Scattering scattered) => scattered.Pdf == 0 ? scattered.Weight
        : hit.Thing!.Material.Evaluate(hit, toViewer, scattered.Direction) * (Math.Abs(scattered.Direction.Z) / scattered.Pdf);
}
