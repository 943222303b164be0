namespace RayTracer.Textbook;

/// <summary>Light that comes to a surface straight from its sources (report, section 6.2.5, DirectLight).</summary>
public static class LightSampling
{
    /// <summary>
    /// One random point of a light, and what of its light the surface sends to the viewer: BSDF · radiance · cosine / pdf, unless something stands
    /// between.
    /// </summary>
    /// <param name="scene">The scene.</param>
    /// <param name="light">The light.</param>
    /// <param name="hit">The surface.</param>
    /// <param name="sampler">The source of random numbers.</param>
    /// <param name="bsdf">The BSDF, by the direction to the light in the surface's frame.</param>
    /// <param name="weight">
    /// A weight by the density of the light's point and the direction to it, where the same light may be found in another way; null for none.
    /// </param>
    /// <param name="chance">The probability with which the light was chosen.</param>
    public static Rgb FromLight(
        Scene scene, ILight light, in Hit hit, ISampler sampler, BsdfOf bsdf, Func<double, Vector, double>? weight = null, double chance = 1)
    {
        // From where the shadow ray starts, a little off the surface: seen from the surface itself, a lamp that nearly touches it would stand in its
        // own light.
        Vector start = hit.Leave(hit.Inside ? -hit.Normal : hit.Normal).Origin;
        if (light.Sample(start, sampler.Next2()) is not { } sample)
        {
            return default;
        }

        Vector toLight = hit.Frame.ToLocal(sample.Direction);
        Rgb scattered = bsdf(hit, toLight) * Math.Abs(toLight.Z);
        bool arrives = !scattered.IsBlack && !hit.Leaks(sample.Direction, toLight.Z) && scene.IsFree(new(start, sample.Direction), sample.Distance);
        double share = !arrives ? 0 : light.IsPoint || weight is null ? 1 : weight(chance * sample.Pdf, toLight);
        Rgb added = arrives ? scattered * sample.Radiance * (share / (chance * sample.Pdf)) : default;
        scene.Witness?.Asked(light, sample, chance, scattered, share, added);
        return added;
    }

    /// <summary>
    /// One light, chosen by power, of which one point is chosen; weighted against the chance that the scattered ray finds the same light.
    /// </summary>
    /// <param name="scene">The scene.</param>
    /// <param name="hit">The surface.</param>
    /// <param name="toViewer">Where the light goes, in the surface's frame.</param>
    /// <param name="sampler">The source of random numbers.</param>
    public static Rgb FromOneLight(Scene scene, in Hit hit, Vector toViewer, ISampler sampler)
    {
        if (scene.Lights.Count == 0)
        {
            return default;
        }

        (ILight light, double chance) = scene.ChooseLight(sampler.Next());
        IMaterial material = hit.Thing!.Material;
        Hit here = hit;
        return FromLight(
            scene, light, hit, sampler,
            (in Hit at, Vector toLight) => material.Evaluate(at, toViewer, toLight),
            (pdf, toLight) => Share(pdf, material.Pdf(here, toViewer, toLight)), chance);
    }

    /// <summary>
    /// How much a way to find light counts that another one finds too: in proportion to the square of its density (Veach 1997, section 9.2, the power
    /// heuristic). The shares of both are 1 together, so that nothing is counted twice.
    /// </summary>
    /// <param name="own">Density of this way.</param>
    /// <param name="other">Density of the other.</param>
    public static double Share(double own, double other) => own * own / ((own * own) + (other * other));

    /// <summary>
    /// The light of a lamp that a scattered ray has met, weighted against the chance that <see cref="FromOneLight"/> finds it; in full where that
    /// cannot be, after a mirror or straight from the camera.
    /// </summary>
    /// <param name="scene">The scene.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="hit">What it has met.</param>
    /// <param name="pdf">The density of the ray's direction; 0 where it was the only one.</param>
    public static Rgb Emitted(Scene scene, in Ray ray, in Hit hit, double pdf)
    {
        if (hit.Thing!.Light is not { } lamp)
        {
            return default;
        }

        double share = pdf == 0 ? 1 : Share(pdf, scene.Chance(lamp) * lamp.Pdf(ray.Origin, hit));
        Rgb radiance = lamp.Radiance(ray.Direction, hit);
        scene.Witness?.Shone(radiance, share);
        return radiance * share;
    }

    /// <summary>The light of what surrounds the scene, where a ray meets nothing; weighted as <see cref="Emitted"/>.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="pdf">The density of the ray's direction; 0 where it was the only one.</param>
    public static Rgb FromAround(Scene scene, in Ray ray, double pdf)
    {
        if (scene.Environment is not { } around)
        {
            return default;
        }

        double share = pdf == 0 ? 1 : Share(pdf, scene.Chance(around) * around.Pdf(ray.Direction));
        Rgb radiance = around.Radiance(ray.Direction);
        scene.Witness?.Shone(radiance, share);
        return radiance * share;
    }
}

/// <summary>The BSDF of a surface towards the viewer.</summary>
/// <param name="hit">The place.</param>
/// <param name="toLight">Where light comes from, in the surface's frame.</param>
public delegate Rgb BsdfOf(in Hit hit, Vector toLight);
