namespace RayTracer.Textbook;

/// <summary>
/// The report's method Color (listing 6.3), line by line: emission, ambient light, direct light and one more ray, with a limit for matt and one for
/// mirror-like bounces.
/// </summary>
/// <remarks>
/// As printed, the listing asks <c>countEmittedLight</c>, the flag of the ray that arrives, whether to sample the lights (line 24), where it means
/// the flag that the scattering has just set: so matt surfaces get no light from the lamps where the camera sees them, and mirrors do behind matt ones.
/// </remarks>
/// <param name="maxDiffuseDepth">The largest number of matt bounces.</param>
/// <param name="maxSpecularDepth">The largest number of glossy and mirror-like bounces.</param>
/// <param name="isAsPrinted">True for the listing as it is printed; false as it is meant.</param>
public sealed class ReportIntegrator(int maxDiffuseDepth, int maxSpecularDepth, bool isAsPrinted) : IIntegrator
{
    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler) => Color(scene, ray, sampler, 0, 0, countEmittedLight: true);

    private Rgb Color(Scene scene, Ray ray, ISampler sampler, int diffuseDepth, int specularDepth, bool countEmittedLight)
    {
        // Line 38: the background.
        if (!scene.Intersect(ray, out Hit hit))
        {
            return LightSampling.FromAround(scene, ray, pdf: 0);
        }

        IMaterial material = hit.Thing!.Material;
        Vector toViewer = hit.Frame.ToLocal(-ray.Direction);
        Rgb color = default;

        // Lines 13 to 15: find the emitted radiance.
        if (countEmittedLight)
        {
            color += LightSampling.Emitted(scene, ray, hit, pdf: 0);
        }

        // Line 18: find ambient light.
        color += scene.Ambient * material.Ambient(hit, toViewer);

        // Line 21: the scattered ray; cel says whether light that it meets is still to be counted.
        Scattering? scattered = material.Sample(hit, toViewer, sampler);
        bool cel = scattered is not { Lobe: Lobe.Matt };

        // Line 24, which prints the wrong flag. As meant, lamps are sampled wherever a surface has a matt part: what the material's choice between its
        // parts brings on average.
        if (!isAsPrinted || !countEmittedLight)
        {
            color += DirectLight(scene, hit, toViewer, sampler);
        }

        // Lines 25 to 33.
        if (scattered is not { } s)
        {
            return color;
        }

        Vector direction = hit.Frame.ToWorld(s.Direction);
        bool isDiffuse = isAsPrinted ? !countEmittedLight : !cel;
        bool goesOn = isDiffuse ? diffuseDepth < maxDiffuseDepth : specularDepth < maxSpecularDepth;
        if (goesOn && !s.Weight.IsBlack && !hit.Leaks(direction, s.Direction.Z))
        {
            color += s.Weight * Color(
                scene, hit.Leave(direction), sampler, isDiffuse ? diffuseDepth + 1 : diffuseDepth, isDiffuse ? specularDepth : specularDepth + 1, cel);
        }

        return color;
    }

    // Listing 6.4: one point of every light.
    private static Rgb DirectLight(Scene scene, in Hit hit, Vector toViewer, ISampler sampler)
    {
        Rgb matt = hit.Thing!.Material.Matt(hit, toViewer);
        Rgb sum = default;
        if (matt.IsBlack)
        {
            return sum;
        }

        foreach (ILight light in scene.Lights)
        {
            if (light is not EnvironmentLight)
            {
                sum += LightSampling.FromLight(scene, light, hit, sampler, (in Hit _, Vector toLight) => toLight.Z > 0 ? matt : default);
            }
        }

        return sum;
    }
}
