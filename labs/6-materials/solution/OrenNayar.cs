namespace Lab6;

/// <summary>
/// A matt surface of tiny V-shaped grooves: rougher than Lambert's, and so flatter, as the full moon is (Oren and Nayar, Generalization of Lambert's reflectance
/// model, 1994, the qualitative model).
/// </summary>
/// <param name="color">The share of light that a groove's wall reflects.</param>
/// <param name="sigma">The deviation of the walls' angles, in radians.</param>
public sealed class OrenNayar(Rgb color, double sigma) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight)
    {
        //? OrenNayar.Evaluate: Lambert's colour/π, times A + B · max(0, cos(φ₁ − φ₂)) · sin α · tan β.
        if (toViewer.Z <= 0 || toLight.Z <= 0)
        {
            return Rgb.Black;
        }

        double s2 = sigma * sigma;
        double a = 1 - (0.5 * s2 / (s2 + 0.33));
        double b = 0.45 * s2 / (s2 + 0.09);

        // The cosine of the difference of the azimuths, times both sines.
        double level = (toViewer.X * toLight.X) + (toViewer.Y * toLight.Y);
        double sines = Math.Sqrt((1 - (toViewer.Z * toViewer.Z)) * (1 - (toLight.Z * toLight.Z)));
        double cosine = sines > 0 ? Math.Max(0, level / sines) : 0;

        // α is the larger angle and β the smaller one, so that sin α · tan β is both sines over the larger cosine.
        double product = sines / Math.Max(toViewer.Z, toLight.Z);
        return color * ((a + (b * cosine * product)) / Math.PI);
        //!
    }

    /// <summary>The density of <see cref="Sample"/>.</summary>
    public double Pdf(in Hit hit, Vector from, Vector to) => Warp.CosineHemispherePdf(to.Z);

    /// <summary>As for a matt surface: by the cosine.</summary>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        Vector to = Warp.CosineHemisphere(sampler.Next2());
        double pdf = Pdf(hit, from, to);
        return pdf > 0 ? new Scattering(to, Evaluate(hit, from, to) * (to.Z / pdf), pdf, Lobe.Glossy) : null;
    }
}
