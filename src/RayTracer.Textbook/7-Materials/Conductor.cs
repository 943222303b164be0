namespace RayTracer.Textbook;

/// <summary>How much a metal reflects.</summary>
/// <param name="eta">Real part of the refractive index; black for a mirror without loss.</param>
/// <param name="k">Imaginary part.</param>
/// <param name="factor">A factor on what is reflected: 1 for real metals.</param>
public sealed class Reflectance(Rgb eta, Rgb k, ITexture factor)
{
    /// <summary>The share of light that is reflected.</summary>
    /// <param name="hit">The place.</param>
    /// <param name="cosine">Cosine of the angle from which it comes.</param>
    public Rgb At(in Hit hit, double cosine)
    {
        Rgb color = factor.At(hit.U, hit.V);
        return eta.IsBlack ? color
            : color * new Rgb(Refraction.Metal(cosine, eta.R, k.R), Refraction.Metal(cosine, eta.G, k.G), Refraction.Metal(cosine, eta.B, k.B));
    }
}

/// <summary>Polished metal, or a mirror without loss (report, section 4.2.1).</summary>
/// <param name="reflectance">How much it reflects.</param>
public sealed class Conductor(Reflectance reflectance) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => default;

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => 0;

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler) => Reflected(hit, from);

    /// <inheritdoc/>
    public IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from) => [Reflected(hit, from)];

    /// <inheritdoc/>
    public Rgb Ambient(in Hit hit, Vector toViewer) => reflectance.At(hit, toViewer.Z);

    private Scattering Reflected(in Hit hit, Vector from) => new(Refraction.Reflect(from), reflectance.At(hit, from.Z), 0, Lobe.Mirror);
}
