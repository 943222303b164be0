using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>Facts about a map from the unit square, whose points are uniform: what it makes of them has the density that is stated.</summary>
/// <param name="seed">Of the random numbers.</param>
/// <param name="samples">The number of samples.</param>
public sealed class WarpFacts(long seed = 1, int samples = 1 << 16)
{
    /// <summary>All points are where they can be.</summary>
    public const string Range = "all points are where they can be";

    /// <summary>The pdf integrates to one.</summary>
    public const string PdfIntegral = MaterialFacts.PdfIntegral;

    /// <summary>Points have the density that the pdf gives.</summary>
    public const string Distribution = "points follow the pdf";

    /// <summary>Checks a map to directions.</summary>
    /// <param name="warp">The map; to unit vectors.</param>
    /// <param name="pdf">The density, per steradian.</param>
    public IReadOnlyList<Fact> Directions(Func<(double U, double V), Vector> warp, Func<Vector, double> pdf) =>
    [
        Fact.Of(Range, "All directions have length 1.", Randoms(2000), random => warp(random) is var d && Math.Abs(d.Length - 1) < 1e-6 ? null
            : Fact.Wrong($"The direction {d} has the length {Fact.Text(d.Length)}.", 1, d.Length, $"{random}")),
        .. Densities(Area.Directions, "azimuth", "cosine", random => Area.Of(warp(random)), (azimuth, cosine) => pdf(Area.Direction(azimuth, cosine))),
    ];

    /// <summary>Checks a map to points of an area.</summary>
    /// <param name="area">The area, outside of which no point may be: <see cref="Area.Disk"/> or <see cref="Area.Unit"/>.</param>
    /// <param name="warp">The map.</param>
    /// <param name="pdf">The density by area; 0 where no points are.</param>
    public IReadOnlyList<Fact> Points(Area area, Func<(double U, double V), (double X, double Y)> warp, Func<double, double, double> pdf) =>
    [
        Fact.Of(Range, "All points are where they can be.", Randoms(2000), random => warp(random) is var p && area.Holds(p) && pdf(p.X, p.Y) > 0 ? null
            : Fact.Wrong($"The point {p} is outside, or its pdf is 0.", double.NaN, double.NaN, $"{random}")),
        .. Densities(area, "x", "y", random => warp(random), pdf),
    ];

    private IEnumerable<Fact> Densities(
        Area area, string x, string y, Func<(double U, double V), (double X, double Y)?> warp, Func<double, double, double> pdf)
    {
        Histogram Count()
        {
            IEnumerator<(double, double)> randoms = Randoms(int.MaxValue).GetEnumerator();
            return Histogram.Of(area, () => randoms.MoveNext() ? warp(randoms.Current) : null, pdf, samples);
        }

        yield return Fact.Of(PdfIntegral, "The pdf integrates to one.", [Count], count => count() is var found && Math.Abs(found.Integral - 1) <= 5e-3 ? null
            : Fact.Wrong($"The pdf integrates to {Fact.Text(found.Integral)}. {Hints.OfPdf(found.Integral)}", 1, found.Integral, "over all of it"));
        yield return Fact.Of(Distribution, "The histogram of points is that of the pdf.", [Count], count => count() is var found && found.Fits ? null
            : Fact.Wrong(
                $"Points do not follow the pdf: around ({Fact.Text(found.Worst.At.X)}, {Fact.Text(found.Worst.At.Y)}) there were {found.Worst.Observed:F0}, and {found.Worst.Expected:F0} were expected.",
                found.Worst.Expected, found.Worst.Observed, "in the cell that is farthest off") with
            {
                Drawing = found.Draw("Points of the warp", x, y),
            });
    }

    private IEnumerable<(double U, double V)> Randoms(int count)
    {
        IndependentSampler sampler = new(seed);
        sampler.Begin(0, 0, 0);
        for (int i = 0; i < count; i++)
        {
            yield return sampler.Next2();
        }
    }
}
