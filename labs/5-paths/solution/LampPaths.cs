namespace Lab5;

/// <summary>The same, but at each surface one lamp is asked for its light, so that a path need not meet a lamp by chance.</summary>
/// <param name="maxEdges">The largest number of edges of a path, that to the lamp counted too; below 0 for no limit.</param>
/// <param name="rouletteFrom">The number of edges from which on paths may end at random.</param>
public sealed class LampPaths(int maxEdges, int rouletteFrom) : IIntegrator
{
    /// <summary>The light of one lamp, chosen at random, that a surface sends back: an estimate of that of all lamps.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="hit">The surface.</param>
    /// <param name="from">Where the path comes from, in the surface's frame.</param>
    /// <param name="sampler">The source of random numbers.</param>
    public static Rgb FromLamps(Scene scene, in Hit hit, Vector from, ISampler sampler)
    {
        //? LampPaths.FromLamps: scene.ChooseLight, then LightSampling.FromLight with the material's Evaluate; divide by the chance of the choice.
        if (scene.Lights.Count == 0)
        {
            return Rgb.Black;
        }

        (ILight light, double chance) = scene.ChooseLight(sampler.Next());
        IMaterial material = hit.Thing!.Material;
        Rgb found = LightSampling.FromLight(scene, light, hit, sampler, (in Hit at, Vector toLight) => material.Evaluate(at, from, toLight));
        return found * (1 / chance);
        //!
    }

    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler)
    {
        //? LampPaths.Radiance: as Paths.Radiance, with FromLamps at each surface. A lamp that a ray meets counts only where it was not asked before.
        Rgb light = Rgb.Black;
        Rgb throughput = Rgb.White;
        bool counts = true;
        for (int edges = 1; ; edges++)
        {
            if (!scene.Intersect(ray, out Hit hit))
            {
                return counts ? light + (throughput * Paths.Around(scene, ray)) : light;
            }

            if (counts)
            {
                light += throughput * Paths.Emitted(ray, hit);
            }

            if (edges == maxEdges)
            {
                return light;
            }

            Vector from = hit.Frame.ToLocal(-ray.Direction);
            light += throughput * FromLamps(scene, hit, from, sampler);
            if (hit.Thing!.Material.Sample(hit, from, sampler) is not { } scattered)
            {
                return light;
            }

            throughput *= scattered.Weight;
            if (edges >= rouletteFrom && !Roulette.Survives(ref throughput, sampler.Next()))
            {
                return light;
            }

            // A mirror's single direction meets no lamp that was asked: there the lamp itself must count.
            counts = scattered.Lobe == Lobe.Mirror;
            ray = hit.Leave(hit.Frame.ToWorld(scattered.Direction));
        }
        //!
    }
}
