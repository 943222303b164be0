using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.StudentPlugin;

/// <summary>Describes <see cref="OwnMatt"/>.</summary>
[SceneType("ownMatt", "A matt surface.")]
public sealed record OwnMattDescription : TextbookMaterialDescription
{
    /// <summary>The share of light that is reflected.</summary>
    [Parameter("The share of light that is reflected.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = new Numerics.Rgb(0.5f, 0.5f, 0.5f);

    /// <summary>The height above which it breaks.</summary>
    [Parameter("The height above which it breaks.", Unit = "scene units")]
    public float BreaksAbove { get; init; } = 1e6f;

    /// <inheritdoc/>
    public override IMaterial Make(TextureMaker texture) => new OwnMatt(texture(Color), BreaksAbove);
}

/// <summary>A matt surface, whose directions are chosen by throwing points at a disk.</summary>
/// <param name="color">The share of light that is reflected.</param>
/// <param name="breaksAbove">The height above which it throws an exception.</param>
public sealed class OwnMatt(ITexture color, double breaksAbove = double.PositiveInfinity) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => toLight.Z > 0 ? Matt(hit, toViewer) : default;

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => Math.Max(0, to.Z) / Math.PI;

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        double x, y;
        do
        {
            (double u, double v) = sampler.Next2();
            (x, y) = ((2 * u) - 1, (2 * v) - 1);
        }
        while ((x * x) + (y * y) >= 1);
        Vector to = new(x, y, Math.Sqrt(1 - (x * x) - (y * y)));
        return new Scattering(to, color.At(hit.U, hit.V), to.Z / Math.PI, Lobe.Matt);
    }

    /// <inheritdoc/>
    public Rgb Matt(in Hit hit, Vector toViewer) =>
        hit.Point.Y > breaksAbove ? throw new InvalidOperationException("This is too high.") : color.At(hit.U, hit.V) * (1 / Math.PI);
}
