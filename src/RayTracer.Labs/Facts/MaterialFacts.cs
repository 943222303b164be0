using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.Labs;

/// <summary>What a material says of itself, where that is not what most are.</summary>
public sealed record MaterialClaims
{
    /// <summary>The refractive index inside over that outside, for materials that scatter light through the surface.</summary>
    public double RefractiveIndex { get; init; } = 1;

    /// <summary>Why it is not reciprocal; null where it is.</summary>
    public string? ReciprocityException { get; init; }

    /// <summary>Why it may reflect more light than arrives; null where it may not.</summary>
    public string? EnergyException { get; init; }

    /// <summary>By what part numbers may be off by rounding.</summary>
    public double Rounding { get; init; } = 1e-6;

    /// <summary>True where <see cref="IMaterial.Mirrors"/> has all single directions.</summary>
    public bool ListsMirrors { get; init; } = true;
}

/// <summary>
/// Facts about an <see cref="IMaterial"/>: that <see cref="IMaterial.Sample"/>, <see cref="IMaterial.Pdf"/> and <see cref="IMaterial.Evaluate"/> belong
/// together, that no energy is created (the white furnace), and that light may go either way (Helmholtz 1867; Veach 1997, section 5.2).
/// </summary>
/// <param name="material">The material.</param>
/// <param name="claims">What it says of itself; null for nothing.</param>
/// <param name="seed">Of the random numbers.</param>
/// <param name="samples">The number of samples in each case.</param>
public sealed class MaterialFacts(IMaterial material, MaterialClaims? claims = null, long seed = 1, int samples = 1 << 15)
{
    /// <summary>The pdf's integral is the share of samples that go on.</summary>
    public const string PdfIntegral = "the pdf integrates to one";

    /// <summary>Samples have the density that the pdf gives.</summary>
    public const string Directions = "directions follow the pdf";

    /// <summary>Weights are BSDF · cosine / pdf.</summary>
    public const string Weights = "weights are BSDF · cosine / pdf";

    /// <summary>No energy is created.</summary>
    public const string Energy = "no more light leaves than arrives";

    /// <summary>Light may go either way.</summary>
    public const string Reciprocity = "light may go either way";

    /// <summary>All that can be seen is sampled.</summary>
    public const string Support = "all that scatters is sampled";

    /// <summary>Mirrors and samples agree.</summary>
    public const string Mirrors = "mirrors and samples agree";

    /// <summary>All numbers are numbers, and directions of length 1.</summary>
    public const string Numbers = "all numbers are sound";

    private readonly MaterialClaims _claims = claims ?? new();

    /// <summary>Checks all of them.</summary>
    public IReadOnlyList<Fact> All() =>
    [
        Check(Numbers, "All numbers are finite and not negative, and directions have length 1.", NumbersIn),
        Check(PdfIntegral, "The pdf integrates to the share of samples that go on.", PdfIntegralIn),
        Check(Directions, "The histogram of sampled directions is that of the pdf.", DirectionsIn),
        Check(Support, "Wherever the BSDF is above zero, the pdf is too.", SupportIn),
        Check(Weights, "The weights of samples are what BSDF and pdf say.", WeightsIn),
        .. _claims.ListsMirrors ? [Check(Mirrors, "Samples of single directions have, on the mean, the weights that Mirrors gives.", MirrorsIn)] : Array.Empty<Fact>(),
        Check(Energy, "In a white furnace the material is nowhere brighter than the furnace.", EnergyIn),
        _claims.ReciprocityException is { } reason ? new(Reciprocity, true, $"Not checked: {reason}.")
            : Check(Reciprocity, "The BSDF is the same with both directions exchanged.", ReciprocityIn),
    ];

    private Fact Check(string name, string good, Func<MaterialCase, Fact?> check) => Fact.Of(name, good, MaterialCase.All, check);

    private Fact? NumbersIn(MaterialCase at)
    {
        foreach (Scattering s in Draw(at))
        {
            if (!(Math.Abs(s.Direction.Length - 1) < _claims.Rounding))
            {
                return Fact.Wrong($"Sample returned the direction {s.Direction}, whose length is not 1.", 1, s.Direction.Length);
            }

            double pdf = material.Pdf(at.Hit, at.From, s.Direction);
            Rgb bsdf = material.Evaluate(at.Hit, at.From, s.Direction);
            if (Unsound(s.Weight) is { } weight)
            {
                return Fact.Wrong($"Sample returned a weight of {weight} in the direction {s.Direction}.", 0, weight);
            }

            if (Unsound(bsdf) is { } value)
            {
                return Fact.Wrong($"Evaluate is {value} for light from {s.Direction}.", 0, value);
            }

            if (Unsound(new(pdf)) is not null)
            {
                return Fact.Wrong($"Pdf is {pdf} in the direction {s.Direction}.", 0, pdf);
            }

            if (s.Lobe != Lobe.Mirror && !(Math.Abs(s.Pdf - pdf) <= _claims.Rounding * (pdf + 1e-6)))
            {
                return Fact.Wrong($"Sample says that its density is {Fact.Text(s.Pdf)}, but Pdf of the same direction is {Fact.Text(pdf)}.", pdf, s.Pdf);
            }
        }

        return null;
    }

    private Fact? PdfIntegralIn(MaterialCase at)
    {
        Histogram found = Histogram(at);
        double difference = found.Integral - found.Share;
        return Math.Abs(difference) <= found.ShareTolerance ? null : Fact.Wrong(
            $"The pdf integrates to {Fact.Text(found.Integral)}, but {Fact.Text(100 * found.Share)} % of the samples go on. {Hints.OfPdf(found.Integral / found.Share)}",
            found.Share, found.Integral);
    }

    private Fact? DirectionsIn(MaterialCase at)
    {
        Histogram found = Histogram(at);
        ((double X, double Y) place, double expected, double observed) = found.Worst;
        return found.Fits ? null : Fact.Wrong(
            $"Samples do not follow the pdf: around {Area.Direction(place.X, place.Y)} there were {observed:F0}, and {expected:F0} were expected. {Hints.OfDirections(found, at, material)}",
            expected, observed) with
        {
            Drawing = found.Draw($"Directions, seen from {at}", "azimuth", "cosine"),
        };
    }

    private Fact? SupportIn(MaterialCase at)
    {
        IndependentSampler sampler = Sampler(at, 2);
        for (int i = 0; i < 2000; i++)
        {
            Vector to = Warp.Sphere(sampler.Next2());
            Rgb bsdf = material.Evaluate(at.Hit, at.From, to);
            if (bsdf.Largest > 1e-9 && material.Pdf(at.Hit, at.From, to) <= 0)
            {
                return Fact.Wrong(
                    $"Evaluate is {Fact.Text(bsdf.Largest)} for light from {to}, but Pdf is 0: {(to.Z < 0 ? "that light comes from below the surface" : "no sample goes there")}.", 0, bsdf.Largest);
            }
        }

        return null;
    }

    private Fact? WeightsIn(MaterialCase at)
    {
        Scattering[] drawn = [.. Draw(at).Where(s => s.Lobe != Lobe.Mirror)];
        (Scattering Sample, Rgb Expected)[] pairs = [.. drawn.Select(s => (s, Expected(at, s.Direction)))];
        (Scattering Sample, Rgb Expected)[] wrong = [.. pairs.Where(p => (p.Sample.Weight - p.Expected) is var d && Largest(d) > _claims.Rounding * (1 + p.Expected.Largest))];
        if (wrong is not [var first, ..])
        {
            return null;
        }

        // Where several lobes choose one direction, weights may be right on the mean only: of the light that goes up, and of its first moments.
        Func<Vector, double>[] parts = [_ => 1, d => d.X, d => d.Y, d => d.Z, d => d.X * d.X, d => d.Z * d.Z];
        foreach (Func<Vector, double> part in parts)
        {
            double[] differences = [.. pairs.Select(p => (p.Sample.Weight.G - p.Expected.G) * part(p.Sample.Direction))];
            double mean = differences.Average();
            double spread = Math.Sqrt(differences.Sum(d => (d - mean) * (d - mean))) / differences.Length;
            if (Math.Abs(mean) > Labs.Histogram.MostDeviations * spread + _claims.Rounding)
            {
                return Fact.Wrong(
                    $"In the direction {first.Sample.Direction} the weight is {Fact.Text(first.Sample.Weight.G)}, but BSDF · cosine / pdf is {Fact.Text(first.Expected.G)}. {Hints.OfWeights(wrong)}",
                    first.Expected.G, first.Sample.Weight.G);
            }
        }

        return null;
    }

    private Fact? MirrorsIn(MaterialCase at)
    {
        Scattering[] single = [.. Draw(at).Where(s => s.Lobe == Lobe.Mirror)];
        IReadOnlyList<Scattering> mirrors = material.Mirrors(at.Hit, at.From);
        if (single.FirstOrDefault(s => !mirrors.Any(m => IsSame(m, s))) is { Lobe: Lobe.Mirror } stray)
        {
            return Fact.Wrong($"Sample returned the single direction {stray.Direction}, which is none of those of Mirrors.");
        }

        foreach (Scattering mirror in mirrors)
        {
            double[] weights = [.. single.Where(s => IsSame(mirror, s)).Select(s => s.Weight.G)];
            double mean = weights.Sum() / samples;
            double spread = Math.Sqrt(Math.Max(0, (weights.Sum(w => w * w) / samples) - (mean * mean)) / samples);
            if (Math.Abs(mean - mirror.Weight.G) > (Labs.Histogram.MostDeviations * spread) + 1e-6)
            {
                return Fact.Wrong(
                    $"Mirrors gives the direction {mirror.Direction} the weight {Fact.Text(mirror.Weight.G)}, but that of samples is {Fact.Text(mean)} on the mean: a lobe that is chosen with a probability has its weight divided by that.",
                    mirror.Weight.G, mean);
            }
        }

        return null;
    }

    private Fact? EnergyIn(MaterialCase at)
    {
        if (_claims.EnergyException is not null)
        {
            return null;
        }

        double index2 = Math.Pow(at.Hit.Inside ? 1 / _claims.RefractiveIndex : _claims.RefractiveIndex, 2);
        Cells cells = new(Area.Directions, [.. Draw(at).Where(s => s.Lobe != Lobe.Mirror).Select(s => Area.Of(s.Direction))]);

        // Radiance grows by the squared index where light is refracted; the number of particles does not.
        double Flux(double azimuth, double cosine) =>
            material.Evaluate(at.Hit, at.From, Area.Direction(azimuth, cosine)).Largest * Math.Abs(cosine) * (cosine < 0 ? index2 : 1);
        double scattered = cells.All.Sum(c => Cells.Integrate(c, Flux, 1e-5));
        double mirrored = _claims.ListsMirrors ? material.Mirrors(at.Hit, at.From).Sum(m => m.ParticleWeight.Largest)
            : Draw(at).Where(s => s.Lobe == Lobe.Mirror).Sum(s => s.ParticleWeight.Largest) / samples;
        double all = scattered + mirrored;
        return all <= 1 + 2e-3 + (_claims.ListsMirrors ? 0 : 0.03) ? null : Fact.Wrong($"{Fact.Text(all)} times the light that arrives is scattered. {Hints.OfEnergy(all, mirrored)}", 1, all);
    }

    private Fact? ReciprocityIn(MaterialCase at)
    {
        IndependentSampler sampler = Sampler(at, 3);
        Scattering[] drawn = [.. Draw(at, 200).Where(s => s.Lobe != Lobe.Mirror)];
        IEnumerable<Vector> directions = drawn.Select(s => s.Direction).Concat(Enumerable.Range(0, 200).Select(_ => Warp.Sphere(sampler.Next2())));
        foreach (Vector to in directions.Where(d => Math.Abs(d.Z) > 0.02))
        {
            // Seen from where the light came from, maybe from the other side.
            bool isAcross = to.Z < 0;
            Hit there = MaterialCase.HitAt(isAcross != at.Hit.Inside, at.Hit);
            Vector Seen(Vector d) => there.Frame.ToLocal(at.Hit.Frame.ToWorld(d));
            double index = at.Hit.Inside ? 1 / _claims.RefractiveIndex : _claims.RefractiveIndex;
            double factor = isAcross ? index * index : 1;
            double forth = material.Evaluate(at.Hit, at.From, to).G * factor;
            double back = material.Evaluate(there, Seen(to), Seen(at.From)).G;
            if (Math.Abs(forth - back) > 10 * _claims.Rounding * (forth + back) + 1e-9)
            {
                return Fact.Wrong(
                    $"The BSDF is {Fact.Text(forth)} for light from {to}, and {Fact.Text(back)} with both directions exchanged.{(isAcross ? " Across a boundary, it goes with the squared refractive index." : "")}",
                    forth, back);
            }
        }

        return null;
    }

    private Histogram Histogram(MaterialCase at)
    {
        IndependentSampler sampler = Sampler(at, 1);
        return Labs.Histogram.Of(
            Area.Directions,
            () => material.Sample(at.Hit, at.From, sampler) is { Lobe: not Lobe.Mirror } s ? Area.Of(s.Direction) : null,
            (azimuth, cosine) => material.Pdf(at.Hit, at.From, Area.Direction(azimuth, cosine)),
            samples);
    }

    private Rgb Expected(MaterialCase at, Vector to) => material.Evaluate(at.Hit, at.From, to) * (Math.Abs(to.Z) / material.Pdf(at.Hit, at.From, to));

    private IEnumerable<Scattering> Draw(MaterialCase at, int count = 0)
    {
        IndependentSampler sampler = Sampler(at, 0);
        return Enumerable.Range(0, count > 0 ? count : samples).Select(_ => material.Sample(at.Hit, at.From, sampler)).OfType<Scattering>();
    }

    private IndependentSampler Sampler(MaterialCase at, int stream)
    {
        IndependentSampler sampler = new(seed);
        sampler.Begin(at.Number, stream, 0);
        return sampler;
    }

    private static bool IsSame(Scattering a, Scattering b) => (a.Direction - b.Direction).Length < 1e-6;

    private static double Largest(Rgb difference) => new Rgb(Math.Abs(difference.R), Math.Abs(difference.G), Math.Abs(difference.B)).Largest;

    // The channel that is no number, or below 0; null where there is none.
    private static double? Unsound(Rgb color)
    {
        double[] channels = [color.R, color.G, color.B];
        int wrong = Array.FindIndex(channels, c => !(c >= 0 && double.IsFinite(c)));
        return wrong < 0 ? null : channels[wrong];
    }
}
