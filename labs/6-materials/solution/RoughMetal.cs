namespace Lab6;

/// <summary>
/// Rough metal of tiny mirrors (Torrance and Sparrow 1967), whose tilts are distributed by GGX (Walter et al., Microfacet models for refraction through rough
/// surfaces, 2007). They reflect all light.
/// </summary>
/// <param name="alpha">Roughness: 0 is a mirror, 1 is nearly matt.</param>
public sealed class RoughMetal(double alpha) : IMaterial
{
    /// <summary>How many mirrors have a tilt: their area, over that of the surface, per steradian (Walter's D, equation 33).</summary>
    /// <param name="tilt">The normal of a mirror: a unit vector.</param>
    public double Distribution(Vector tilt)
    {
        //? RoughMetal.Distribution: α² / (π · cos⁴θ · (α² + tan²θ)²), for tilts above the surface.
        double cos2 = tilt.Z * tilt.Z;
        double sum = (alpha * alpha * cos2) + (1 - cos2);
        return tilt.Z > 0 ? alpha * alpha / (Math.PI * sum * sum) : 0;
        //!
    }

    /// <summary>The share of the mirrors that others do not hide, as seen from a direction (Walter's G₁, equation 34).</summary>
    /// <param name="direction">A unit vector above the surface.</param>
    public double Visible(Vector direction)
    {
        //? RoughMetal.Visible: 2 / (1 + √(1 + α²·tan²θ)).
        double tan2 = (1 - (direction.Z * direction.Z)) / (direction.Z * direction.Z);
        return 2 / (1 + Math.Sqrt(1 + (alpha * alpha * tan2)));
        //!
    }

    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight)
    {
        //? RoughMetal.Evaluate: D · G₁ · G₁ / (4 · cos · cos), where the mirrors are tilted halfway between both directions.
        if (toViewer.Z <= 0 || toLight.Z <= 0)
        {
            return Rgb.Black;
        }

        Vector tilt = (toViewer + toLight).Unit;
        return new Rgb(Distribution(tilt) * Visible(toViewer) * Visible(toLight) / (4 * toViewer.Z * toLight.Z));
        //!
    }

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to)
    {
        //? RoughMetal.Pdf: tilts have the density D · cosine; directions are spread 4 · (from · tilt) times as wide.
        if (from.Z <= 0 || to.Z <= 0)
        {
            return 0;
        }

        Vector tilt = (from + to).Unit;
        return Distribution(tilt) * tilt.Z / (4 * Vector.Dot(from, tilt));
        //!
    }

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        //? RoughMetal.Sample: a tilt with tan²θ = α²·u / (1 − u) has the density D · cosine; the direction is from, mirrored at it.
        (double u, double v) = sampler.Next2();
        double cos = 1 / Math.Sqrt(1 + (alpha * alpha * u / (1 - u)));
        double sin = Math.Sqrt(Math.Max(0, 1 - (cos * cos)));
        Vector tilt = new(sin * Math.Cos(2 * Math.PI * v), sin * Math.Sin(2 * Math.PI * v), cos);
        Vector to = (2 * Vector.Dot(from, tilt) * tilt) - from;
        double pdf = Pdf(hit, from, to);

        // Where the mirror sends light below the surface, it meets another one: that light is lost here.
        return to.Z > 0 && pdf > 0 ? new Scattering(to, Evaluate(hit, from, to) * (to.Z / pdf), pdf, Lobe.Glossy) : null;
        //!
    }
}
