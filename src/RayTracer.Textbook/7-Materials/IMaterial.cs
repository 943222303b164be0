namespace RayTracer.Textbook;

/// <summary>
/// How a surface scatters light. All directions are unit vectors that point away from the surface, in its frame (<see cref="Hit.Frame"/>): the
/// normal on the side that the ray comes from is (0, 0, 1), and the cosine with it is z.
/// </summary>
public interface IMaterial
{
    /// <summary>
    /// The BSDF, per steradian, without the cosine: the share of the light from one direction that goes in another. What goes into single
    /// directions (<see cref="Mirrors"/>) is not in it.
    /// </summary>
    /// <param name="hit">The place.</param>
    /// <param name="toViewer">Where the light goes.</param>
    /// <param name="toLight">Where it comes from.</param>
    Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight);

    /// <summary>The density, per steradian, with which <see cref="Sample"/> continues a path in a direction; 0 for single directions.</summary>
    /// <param name="hit">The place.</param>
    /// <param name="from">Where the path comes from.</param>
    /// <param name="to">Where it goes on.</param>
    double Pdf(in Hit hit, Vector from, Vector to);

    /// <summary>Chooses where a path goes on; null where it ends, as the light is absorbed.</summary>
    /// <param name="hit">The place.</param>
    /// <param name="from">Where the path comes from: towards the viewer.</param>
    /// <param name="sampler">The source of random numbers.</param>
    Scattering? Sample(in Hit hit, Vector from, ISampler sampler);

    /// <summary>The single directions into which mirrors and glass send light, with the share of each as its weight.</summary>
    /// <param name="hit">The place.</param>
    /// <param name="from">Where the path comes from.</param>
    IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from) => [];

    /// <summary>The part of the BSDF that is Lambert's, the same for all directions above: that for which the report samples light sources.</summary>
    Rgb Matt(in Hit hit, Vector toViewer) => default;

    /// <summary>The share of ambient light that is reflected (report, section 4.2).</summary>
    Rgb Ambient(in Hit hit, Vector toViewer) => default;
}

/// <summary>How a path was scattered: matt surfaces in all directions, glossy ones in many, mirrors and glass in one.</summary>
public enum Lobe
{
    /// <summary>By Lambert's law.</summary>
    Matt,

    /// <summary>Around a direction.</summary>
    Glossy,

    /// <summary>In a single direction.</summary>
    Mirror,
}

/// <summary>How a path goes on.</summary>
/// <param name="Direction">Where, in the surface's frame.</param>
/// <param name="Weight">What becomes of light that comes from there: BSDF · cosine / pdf.</param>
/// <param name="Pdf">The density of the direction, per steradian; 0 for single directions.</param>
/// <param name="Lobe">How it was scattered.</param>
public readonly record struct Scattering(Vector Direction, Rgb Weight, double Pdf, Lobe Lobe)
{
    /// <summary>
    /// The weight for a path that comes from a light, where that is another one: radiance grows in a denser medium, since it is squeezed into
    /// fewer directions, and the number of particles does not (Veach 1997, section 5.2). Only of single directions.
    /// </summary>
    public Rgb ParticleWeight { get; init; } = Weight;
}
