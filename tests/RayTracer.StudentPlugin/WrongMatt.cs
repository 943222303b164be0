using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.StudentPlugin;

/// <summary>A matt surface with a mistake: directions are chosen by the cosine, and the pdf says that they are even.</summary>
public sealed class WrongMatt : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => toLight.Z > 0 ? new(0.5 / Math.PI) : default;

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => to.Z > 0 ? 0.5 / Math.PI : 0;

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        Vector to = Warp.CosineHemisphere(sampler.Next2());
        return new Scattering(to, new(to.Z), 0.5 / Math.PI, Lobe.Matt);
    }
}
