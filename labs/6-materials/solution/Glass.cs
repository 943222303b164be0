namespace Lab6;

/// <summary>Clear glass: it reflects one part of the light, and refracts the other.</summary>
/// <param name="index">The refractive index of the inside over that of the outside.</param>
public sealed class Glass(double index) : IMaterial
{
    /// <summary>The direction on the other side, by Snell's law. Null in total reflection.</summary>
    /// <param name="from">Where the light comes from: a unit vector above the surface.</param>
    /// <param name="eta">The refractive index on the side of <paramref name="from"/> over that of the other.</param>
    public static Vector? Refract(Vector from, double eta)
    {
        //? Glass.Refract: the sine of the angle becomes eta times as large; above 1 there is no such angle.
        double sin2 = eta * eta * (1 - (from.Z * from.Z));
        return sin2 >= 1 ? null : new Vector(-eta * from.X, -eta * from.Y, -Math.Sqrt(1 - sin2));
        //!
    }

    /// <summary>The share of unpolarised light that is reflected (Fresnel's equations).</summary>
    /// <param name="cosine">Cosine of the angle from which light comes.</param>
    /// <param name="refracted">Cosine of the angle on the other side.</param>
    /// <param name="eta">The refractive index on the side from which light comes, over that of the other.</param>
    public static double Fresnel(double cosine, double refracted, double eta)
    {
        //? Glass.Fresnel: the mean of two squares, one for each polarisation.
        double parallel = (cosine - (eta * refracted)) / (cosine + (eta * refracted));
        double across = ((eta * cosine) - refracted) / ((eta * cosine) + refracted);
        return 0.5 * ((parallel * parallel) + (across * across));
        //!
    }

    /// <summary>Nothing: what is scattered goes in two single directions.</summary>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => Rgb.Black;

    /// <summary>0, as for all single directions.</summary>
    public double Pdf(in Hit hit, Vector from, Vector to) => 0;

    /// <summary>Both directions, with the share of the light of each as its weight.</summary>
    public IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from)
    {
        //? Glass.Mirrors: the reflected direction with the weight F; the refracted one with (1 − F)·eta², and 1 − F for particles.
        double eta = hit.Inside ? index : 1 / index;
        Vector up = new(-from.X, -from.Y, from.Z);
        if (Refract(from, eta) is not { } down)
        {
            return [new(up, Rgb.White, 0, Lobe.Mirror)];
        }

        double share = Fresnel(from.Z, -down.Z, eta);
        return
        [
            new(up, new Rgb(share), 0, Lobe.Mirror),
            new(down, new Rgb((1 - share) * eta * eta), 0, Lobe.Mirror) { ParticleWeight = new Rgb(1 - share) },
        ];
        //!
    }

    /// <summary>One of the two, by chance, with a weight that makes up for that.</summary>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        //? Glass.Sample: choose the first of Mirrors with the probability F, and divide its weight by that; or the other by 1 − F.
        IReadOnlyList<Scattering> both = Mirrors(hit, from);
        double chance = both[0].Weight.R;
        bool isFirst = both.Count == 1 || sampler.Next() < chance;
        Scattering chosen = isFirst ? both[0] : both[1];
        double divisor = isFirst ? chance : 1 - chance;
        return chosen with { Weight = chosen.Weight * (1 / divisor), ParticleWeight = chosen.ParticleWeight * (1 / divisor) };
        //!
    }
}
