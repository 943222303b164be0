namespace RayTracer.Textbook;

/// <summary>
/// A matt surface under a clear coat (the report's DiffuseSpecularMaterial, section 6.2.6): the share of light that Schlick's approximation gives is
/// reflected by the coat, and the rest by what is below.
/// </summary>
/// <param name="below">The matt surface.</param>
/// <param name="coat">The material that the coat is like.</param>
/// <param name="r0">How much the coat reflects along the normal.</param>
public sealed class Coated(IMaterial below, IMaterial coat, double r0) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight)
    {
        double share = Refraction.Schlick(toViewer.Z, r0);
        return (coat.Evaluate(hit, toViewer, toLight) * share) + (below.Evaluate(hit, toViewer, toLight) * (1 - share));
    }

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to)
    {
        double chance = CoatChance(from);
        return (chance * coat.Pdf(hit, from, to)) + ((1 - chance) * below.Pdf(hit, from, to));
    }

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        double share = Refraction.Schlick(from.Z, r0);
        double chance = CoatChance(from);
        bool isCoat = sampler.Next() < chance;
        if ((isCoat ? coat : below).Sample(hit, from, sampler) is not { } part)
        {
            return null;
        }

        double factor = isCoat ? share / chance : (1 - share) / (1 - chance);
        return part with
        {
            Weight = part.Weight * factor,
            ParticleWeight = part.ParticleWeight * (factor * ViewerShare(part.Direction) / share),
            Pdf = part.Lobe == Lobe.Mirror ? 0 : Pdf(hit, from, part.Direction),
        };
    }

    /// <inheritdoc/>
    public IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from)
    {
        double share = Refraction.Schlick(from.Z, r0);
        return [.. coat.Mirrors(hit, from).Select(m => m with { Weight = m.Weight * share, ParticleWeight = m.ParticleWeight * ViewerShare(m.Direction) })];
    }

    /// <inheritdoc/>
    public Rgb Matt(in Hit hit, Vector toViewer) => below.Matt(hit, toViewer) * (1 - Refraction.Schlick(toViewer.Z, r0));

    /// <inheritdoc/>
    public Rgb Ambient(in Hit hit, Vector toViewer)
    {
        double share = Refraction.Schlick(toViewer.Z, r0);
        return (coat.Ambient(hit, toViewer) * share) + (below.Ambient(hit, toViewer) * (1 - share));
    }

    // What the coat mirrors, lamps above all, is brighter than what is below: it is looked at more often than by its share.
    private double CoatChance(Vector from) => Math.Sqrt(Refraction.Schlick(from.Z, r0));

    // Of a path from a light, the viewer is where it goes.
    private double ViewerShare(Vector toViewer) => Refraction.Schlick(Math.Abs(toViewer.Z), r0);
}
