namespace RayTracer.Textbook;

/// <summary>
/// Path tracing (Kajiya, The rendering equation, 1986): light from the sources at every surface that a path meets, and one scattered ray from each, to
/// the end.
/// </summary>
/// <param name="maxDepth">The largest number of edges of a path: 1 shows what shines, 2 adds direct light; below 0 for no limit.</param>
/// <param name="rouletteDepth">The number of edges after which paths may end at random.</param>
public sealed class PathIntegrator(int maxDepth, int rouletteDepth) : IIntegrator
{
    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler)
    {
        Rgb light = default;
        Rgb throughput = Rgb.White;
        double pdf = 0;
        for (int edges = 1; ; edges++)
        {
            if (!scene.Intersect(ray, out Hit hit))
            {
                return light + (throughput * LightSampling.FromAround(scene, ray, pdf));
            }

            light += throughput * LightSampling.Emitted(scene, ray, hit, pdf);
            if (edges == maxDepth)
            {
                return light;
            }

            // Straight from a light: that is one more edge.
            Vector toViewer = hit.Frame.ToLocal(-ray.Direction);
            light += throughput * LightSampling.FromOneLight(scene, hit, toViewer, sampler);

            // On to the next surface.
            if (hit.Thing!.Material.Sample(hit, toViewer, sampler) is not { } scattered)
            {
                return light;
            }

            Vector direction = hit.Frame.ToWorld(scattered.Direction);
            throughput *= DirectIntegrator.Weight(hit, toViewer, scattered);
            if (throughput.IsBlack || hit.Leaks(direction, scattered.Direction.Z) || (edges >= rouletteDepth && !Survives(scene, ref throughput, sampler.Next())))
            {
                return light;
            }

            ray = hit.Leave(direction);
            pdf = scattered.Pdf;
        }
    }

    /// <summary>
    /// Roulette: a path that carries little mostly ends, and those that go on make up for the others, so that the mean stays (Arvo &amp; Kirk 1990).
    /// </summary>
    internal static bool Survives(Scene? scene, ref Rgb throughput, double random)
    {
        double survival = Math.Min(throughput.Largest, 0.95);
        scene?.Witness?.Survived(survival);
        throughput *= 1 / survival;
        return random < survival;
    }
}
