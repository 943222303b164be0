namespace RayTracer.Textbook;

/// <summary>
/// Phong's model (report, section 4.2.5; Phong, Illumination for computer generated pictures, 1975): a matt part, and a lobe around the mirror
/// direction that narrows as the exponent grows, scaled so that its colour is the share of light in it. Without the matt part it is the report's metal
/// (section 6.2.6). The lobe stands for BRDF · cosine, so that it is not reciprocal.
/// </summary>
/// <param name="matt">The share of light that is reflected in all directions.</param>
/// <param name="shine">The share of light around the mirror direction.</param>
/// <param name="exponent">The exponent of the lobe.</param>
/// <param name="ambient">A factor on ambient light; null for the sum of the others.</param>
public sealed class Phong(ITexture matt, ITexture shine, double exponent, ITexture? ambient) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight)
    {
        if (toViewer.Z <= 0 || toLight.Z <= 0)
        {
            return default;
        }

        return Matt(hit, toViewer) + (shine.At(hit.U, hit.V) * (LobePdf(toViewer, toLight) / toLight.Z));
    }

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to)
    {
        double chance = ShineChance(hit);
        return to.Z <= 0 ? 0 : (chance * LobePdf(from, to)) + ((1 - chance) * Warp.CosineHemispherePdf(to.Z));
    }

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        double chance = ShineChance(hit);
        bool shines = sampler.Next() < chance;
        Vector to = shines
            ? new Frame(Refraction.Reflect(from)).ToWorld(Warp.CosinePower(sampler.Next2(), exponent))
            : Warp.CosineHemisphere(sampler.Next2());

        // What would go below the surface is lost.
        if (to.Z <= 0)
        {
            return null;
        }

        // Of each part alone: the colour of the chosen one over its chance. The report needs that; the density is that of both.
        Rgb weight = shines ? shine.At(hit.U, hit.V) * (1 / chance) : matt.At(hit.U, hit.V) * (1 / (1 - chance));
        return new Scattering(to, weight, Pdf(hit, from, to), shines ? Lobe.Glossy : Lobe.Matt);
    }

    /// <inheritdoc/>
    public Rgb Matt(in Hit hit, Vector toViewer) => matt.At(hit.U, hit.V) * (1 / Math.PI);

    /// <inheritdoc/>
    public Rgb Ambient(in Hit hit, Vector toViewer) => ambient?.At(hit.U, hit.V) ?? matt.At(hit.U, hit.V) + shine.At(hit.U, hit.V);

    private double LobePdf(Vector from, Vector to) => Warp.CosinePowerPdf(Vector.Dot(Refraction.Reflect(from), to), exponent);

    private double ShineChance(in Hit hit)
    {
        double bright = shine.At(hit.U, hit.V).Luminance;
        double dull = matt.At(hit.U, hit.V).Luminance;
        return bright + dull > 0 ? bright / (bright + dull) : 0;
    }
}
