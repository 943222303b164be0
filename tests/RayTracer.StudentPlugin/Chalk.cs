using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.StudentPlugin;

/// <summary>The material as scene files name it: <c>{ "type": "chalk", "color": "white" }</c>.</summary>
[SceneType("chalk", "A matt surface.")]
public sealed record ChalkDescription : TextbookMaterialDescription
{
    /// <summary>The share of light that is reflected.</summary>
    [Parameter("The share of light that is reflected.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = "white";

    /// <inheritdoc/>
    public override IMaterial Make(TextureMaker texture) => new Chalk(texture(Color));
}

/// <summary>Lambert's law.</summary>
public sealed class Chalk(ITexture color) : IMaterial
{
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => toLight.Z > 0 ? color.At(hit.U, hit.V) * (1 / Math.PI) : default;

    public double Pdf(in Hit hit, Vector from, Vector to) => Warp.CosineHemispherePdf(to.Z);

    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        Vector to = Warp.CosineHemisphere(sampler.Next2());
        return new Scattering(to, color.At(hit.U, hit.V), Pdf(hit, from, to), Lobe.Matt);
    }
}
