namespace RayTracer.Textbook;

/// <summary>A matt surface: equally bright from everywhere (Lambert's law; report, section 4.2.2).</summary>
/// <param name="color">The share of light that is reflected.</param>
public sealed class Diffuse(ITexture color) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => toViewer.Z > 0 && toLight.Z > 0 ? Matt(hit, toViewer) : default;

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => Warp.CosineHemispherePdf(to.Z);

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        Vector to = Warp.CosineHemisphere(sampler.Next2());
        return new Scattering(to, color.At(hit.U, hit.V), Warp.CosineHemispherePdf(to.Z), Lobe.Matt);
    }

    /// <summary>The colour over π: over all directions above, the cosine's integral is π.</summary>
    public Rgb Matt(in Hit hit, Vector toViewer) => color.At(hit.U, hit.V) * (1 / Math.PI);

    /// <inheritdoc/>
    public Rgb Ambient(in Hit hit, Vector toViewer) => color.At(hit.U, hit.V);
}
