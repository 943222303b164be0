namespace Lab7;

/// <summary>A photon: some of a lamp's power, which has arrived at a surface.</summary>
/// <param name="Point">Where.</param>
/// <param name="From">The unit direction, in the world, in which it came from: away from the surface.</param>
/// <param name="Power">How much power it brings.</param>
public readonly record struct Photon(Vector Point, Vector From, Rgb Power);

/// <summary>Sends light from the lamps into the scene (Jensen, Global illumination using photon maps, 1996).</summary>
public static class Photons
{
    // Light between two mirrors need not end.
    private const int MostEdges = 16;

    /// <summary>Lets one of the photons leave a lamp.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="count">The number of photons that share the power of all lamps.</param>
    /// <param name="sampler">The source of random numbers.</param>
    /// <returns>The ray that leaves the lamp, and the power of the photon; null where there is none.</returns>
    public static (Ray Ray, Rgb Power)? Emit(Scene scene, int count, ISampler sampler)
    {
        //? Photons.Emit: scene.ChooseLight, then light.Emit; divide its power by the chance of the lamp and by the number of photons.
        if (scene.Lights.Count == 0)
        {
            return null;
        }

        (ILight light, double chance) = scene.ChooseLight(sampler.Next());
        return light.Emit(sampler) is { } emitted ? (emitted.Ray, emitted.Power * (1 / (chance * count))) : null;
        //!
    }

    /// <summary>Follows a photon through glass and mirrors to the first other surface. There it is stored, unless it came straight from the lamp.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="ray">The ray in which it left the lamp.</param>
    /// <param name="power">Its power.</param>
    /// <param name="sampler">The source of random numbers.</param>
    /// <param name="store">Takes it.</param>
    public static void Follow(Scene scene, Ray ray, Rgb power, ISampler sampler, Action<Photon> store)
    {
        //? Photons.Follow: while the material's Sample says Lobe.Mirror, multiply the power by its ParticleWeight and go on; store it at the first other surface.
        bool isCaustic = false;
        for (int edges = 0; edges < MostEdges && scene.Intersect(ray, out Hit hit); edges++)
        {
            Vector from = hit.Frame.ToLocal(-ray.Direction);
            if (hit.Thing!.Material.Sample(hit, from, sampler) is not { } scattered)
            {
                return;
            }

            if (scattered.Lobe != Lobe.Mirror)
            {
                if (isCaustic)
                {
                    store(new(hit.Point, -ray.Direction, power));
                }

                return;
            }

            isCaustic = true;
            power *= scattered.ParticleWeight;
            ray = hit.Leave(hit.Frame.ToWorld(scattered.Direction));
        }
        //!
    }
}
