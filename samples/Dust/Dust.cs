using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Textbook;

namespace Dust;

/// <summary>The material as scene files name it: <c>{ "type": "dust", "color": "white" }</c>.</summary>
[SceneType("dust", "A matt surface that looks as bright at its edge as in its middle, as the moon does.")]
public sealed record DustDescription : TextbookMaterialDescription
{
    /// <summary>The share of light that a grain of dust scatters.</summary>
    [Parameter("Share of light that a grain of dust scatters.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = "white";

    /// <inheritdoc/>
    public override IMaterial Make(TextureMaker texture) => new Dust(texture(Color));
}

/// <summary>
/// A surface of dust: the law of Lommel and Seeliger (Seeliger 1887), by which light that enters is weakened on its way in and out, and scattered once. Its BRDF is
/// color / (4π) / (cos θᵢ + cos θₒ), which is reciprocal, and at most half of the light comes back.
/// </summary>
public sealed class Dust(ITexture color) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) =>
        toViewer.Z > 0 && toLight.Z > 0 ? color.At(hit.U, hit.V) * (1 / (4 * Math.PI * (toViewer.Z + toLight.Z))) : default;

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => from.Z > 0 ? Warp.CosineHemispherePdf(to.Z) : 0;

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        if (from.Z <= 0)
        {
            return null;
        }

        // The cosine and the density cancel but for a factor of π.
        Vector to = Warp.CosineHemisphere(sampler.Next2());
        return new Scattering(to, Evaluate(hit, from, to) * Math.PI, Pdf(hit, from, to), Lobe.Matt);
    }
}
