namespace Lab5;

/// <summary>Path tracing (Kajiya, The rendering equation, 1986): a ray is followed from surface to surface, and collects the light of all lamps that it meets.</summary>
/// <param name="maxEdges">The largest number of edges of a path: 1 shows lamps alone; below 0 for no limit.</param>
/// <param name="rouletteFrom">The number of edges from which on paths may end at random.</param>
public sealed class Paths(int maxEdges, int rouletteFrom) : IIntegrator
{
    /// <summary>The light that a surface sends out by itself, back along the ray that has met it.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="hit">What it has met.</param>
    public static Rgb Emitted(Ray ray, in Hit hit)
    {
        //? Paths.Emitted: hit.Thing.Light says how it shines, in the direction of the ray; most things have none.
        return hit.Thing!.Light?.Radiance(ray.Direction, hit) ?? Rgb.Black;
        //!
    }

    /// <summary>The light that comes from all around the scene, along a ray that meets nothing.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="ray">The ray.</param>
    public static Rgb Around(Scene scene, Ray ray)
    {
        //? Paths.Around: scene.Environment knows the radiance of a direction; some scenes have none.
        return scene.Environment?.Radiance(ray.Direction) ?? Rgb.Black;
        //!
    }

    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler)
    {
        //? Paths.Radiance: a loop over the edges of a path, with the light found so far, and the share of what is found next that comes back to the eye.
        Rgb light = Rgb.Black;
        Rgb throughput = Rgb.White;
        for (int edges = 1; ; edges++)
        {
            if (!scene.Intersect(ray, out Hit hit))
            {
                return light + (throughput * Around(scene, ray));
            }

            light += throughput * Emitted(ray, hit);
            if (edges == maxEdges)
            {
                return light;
            }

            Vector from = hit.Frame.ToLocal(-ray.Direction);
            if (hit.Thing!.Material.Sample(hit, from, sampler) is not { } scattered)
            {
                return light;
            }

            throughput *= scattered.Weight;
            if (edges >= rouletteFrom && !Roulette.Survives(ref throughput, sampler.Next()))
            {
                return light;
            }

            ray = hit.Leave(hit.Frame.ToWorld(scattered.Direction));
        }
        //!
    }
}
