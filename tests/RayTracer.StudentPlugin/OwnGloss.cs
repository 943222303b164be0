using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.StudentPlugin;

/// <summary>Describes <see cref="OwnGloss"/>.</summary>
[SceneType("ownGloss", "A rough mirror without loss but for shadows.")]
public sealed record OwnGlossDescription : TextbookMaterialDescription
{
    /// <summary>Roughness.</summary>
    [Parameter("Roughness.", Minimum = 0.01, Maximum = 1)]
    public float Alpha { get; init; } = 0.3f;

    /// <inheritdoc/>
    public override IMaterial Make(TextureMaker texture) => new OwnGloss(Alpha);
}

/// <summary>Tiny mirrors with the tilts of GGX, chosen without regard to which of them are seen.</summary>
/// <param name="alpha">Roughness.</param>
public sealed class OwnGloss(double alpha) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => toViewer.Z <= 0 || toLight.Z <= 0 ? default
        : new Rgb(Tilts((toViewer + toLight).Unit) * Seen(toViewer) * Seen(toLight) / (4 * toViewer.Z * toLight.Z));

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to)
    {
        Vector tilt = (from + to).Unit;
        return from.Z <= 0 || to.Z <= 0 ? 0 : Tilts(tilt) * tilt.Z / (4 * Vector.Dot(from, tilt));
    }

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        (double u, double v) = sampler.Next2();
        double tangent = alpha * Math.Sqrt(u / (1 - u));
        (double sin, double cos) = Math.SinCos(2 * Math.PI * v);
        Vector tilt = new Vector(tangent * cos, tangent * sin, 1).Unit;
        Vector to = (2 * Vector.Dot(from, tilt) * tilt) - from;
        double pdf = Pdf(hit, from, to);
        return pdf > 0 && Vector.Dot(from, tilt) > 0 ? new Scattering(to, Evaluate(hit, from, to) * (to.Z / pdf), pdf, Lobe.Glossy) : null;
    }

    private double Tilts(Vector tilt)
    {
        double x = (((tilt.X * tilt.X) + (tilt.Y * tilt.Y)) / (alpha * alpha)) + (tilt.Z * tilt.Z);
        return 1 / (Math.PI * alpha * alpha * x * x);
    }

    private double Seen(Vector d) => 2 / (1 + Math.Sqrt(1 + (alpha * alpha * ((d.X * d.X) + (d.Y * d.Y)) / (d.Z * d.Z))));
}
