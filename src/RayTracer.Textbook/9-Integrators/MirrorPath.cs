namespace RayTracer.Textbook;

/// <summary>A path from the camera for integrators whose light comes from paths that begin at the lights: those cannot be joined with it across a mirror.</summary>
internal static class MirrorPath
{
    /// <summary>What shines, seen straight, in mirrors or through glass, and what else is found at the surfaces on the way.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="ray">The camera's ray.</param>
    /// <param name="sampler">The source of random numbers.</param>
    /// <param name="maxDepth">The largest number of edges; below 0 for no limit.</param>
    /// <param name="rouletteDepth">The number of edges after which the path may end at random.</param>
    /// <param name="found">The light that leaves a surface, in its frame, towards the viewer, by the number of edges so far.</param>
    public static Rgb Radiance(Scene scene, Ray ray, ISampler sampler, int maxDepth, int rouletteDepth, Func<Hit, Vector, int, Rgb> found)
    {
        Rgb throughput = Rgb.White;
        Rgb light = default;
        for (int edges = 1; maxDepth < 0 || edges <= maxDepth; edges++)
        {
            if (!scene.Intersect(ray, out Hit hit))
            {
                return light + (throughput * LightSampling.FromAround(scene, ray, pdf: 0));
            }

            light += throughput * LightSampling.Emitted(scene, ray, hit, pdf: 0);
            Vector toViewer = hit.Frame.ToLocal(-ray.Direction);
            light += throughput * found(hit, toViewer, edges);
            if (hit.Thing!.Material.Sample(hit, toViewer, sampler) is not { Lobe: Lobe.Mirror } mirror)
            {
                return light;
            }

            throughput *= mirror.Weight;
            if (throughput.IsBlack || (edges >= rouletteDepth && !PathIntegrator.Survives(scene, ref throughput, sampler.Next())))
            {
                return light;
            }

            ray = hit.Leave(hit.Frame.ToWorld(mirror.Direction));
        }

        return light;
    }
}
