namespace RayTracer.Textbook;

/// <summary>Clear glass or water: reflects one part of the light, refracts the other, and absorbs some of it inside.</summary>
/// <param name="index">The refractive index of the inside over that of the outside.</param>
/// <param name="extinction">How fast the inside absorbs: after a distance d, e^(−extinction·d) is left (Bouguer 1729; report, section 6.2.6).</param>
/// <param name="isSchlick">True for Schlick's approximation, as in the report; false for Fresnel's equations.</param>
/// <param name="reflected">A factor on what is reflected: 1 for real glass.</param>
/// <param name="refracted">A factor on what is refracted: 1 for real glass.</param>
public sealed class Dielectric(double index, Rgb extinction, bool isSchlick, ITexture reflected, ITexture refracted) : IMaterial
{
    /// <summary>Nothing: what is scattered goes in two single directions.</summary>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => default;

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => 0;

    /// <inheritdoc/>
    public IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from)
    {
        (Scattering above, Scattering? below, double share) = Both(hit, from);
        above = above with { Weight = above.Weight * share, ParticleWeight = above.ParticleWeight * share };
        return below is { } b ? [above, b with { Weight = b.Weight * (1 - share), ParticleWeight = b.ParticleWeight * (1 - share) }] : [above];
    }

    /// <summary>One of the two, with the probability of its share: so that the weight of either is 1, but for factors.</summary>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        (Scattering above, Scattering? below, double share) = Both(hit, from);
        return sampler.Next() < share ? above : below;
    }

    private (Scattering Above, Scattering? Below, double Share) Both(in Hit hit, Vector from)
    {
        // Light that comes from inside has been absorbed on its way from where it last met something.
        Rgb left = hit.Inside ? extinction.Exp(-hit.Distance) : Rgb.White;
        double eta = hit.Inside ? index : 1 / index;
        Scattering above = new(Refraction.Reflect(from), left * reflected.At(hit.U, hit.V), 0, Lobe.Mirror);
        if (Refraction.Refract(from, eta) is not { } direction)
        {
            return (above, null, 1);
        }

        double r0 = (index - 1) / (index + 1);
        double share = isSchlick
            ? Refraction.Schlick(eta > 1 ? -direction.Z : from.Z, r0 * r0)
            : Refraction.Fresnel(from.Z, -direction.Z, eta);
        Rgb through = left * refracted.At(hit.U, hit.V);
        return (above, new Scattering(direction, through * (eta * eta), 0, Lobe.Mirror) { ParticleWeight = through }, share);
    }
}
