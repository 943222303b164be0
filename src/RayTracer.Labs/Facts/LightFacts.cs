using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.Labs;

/// <summary>
/// Facts about an <see cref="ILight"/> of finite size: what <see cref="ILight.Sample"/> lets arrive on a ball around it is what <see cref="ILight.Emit"/>
/// lets leave, however large the ball.
/// </summary>
/// <param name="light">The light.</param>
/// <param name="around">A box around it; a point for a point light.</param>
/// <param name="seed">Of the random numbers.</param>
/// <param name="samples">The number of samples.</param>
public sealed class LightFacts(ILight light, Bounds around, long seed = 1, int samples = 1 << 16)
{
    /// <summary>Samples are sound.</summary>
    public const string Numbers = MaterialFacts.Numbers;

    /// <summary>As much arrives as leaves.</summary>
    public const string Flux = "as much light arrives as leaves";

    /// <summary>Checks both.</summary>
    public IReadOnlyList<Fact> All()
    {
        double size = Math.Max(around.Size.Length, 1);
        return
        [
            Fact.Of(Numbers, "Directions have length 1, and densities and radiances are not negative.", Places(2 * size, 2000), SoundAt),
            Fact.Of(Flux, "What arrives on a ball around the light is what leaves it.", new[] { 2 * size, 10 * size }, FluxThrough),
        ];
    }

    private Fact? SoundAt((Vector From, Vector Inwards, (double, double) Random) at)
    {
        if (light.Sample(at.From, at.Random) is not { } s)
        {
            return null;
        }

        bool isSound = Math.Abs(s.Direction.Length - 1) < 1e-6 && s.Distance > 0 && s.Pdf > 0 && s.Radiance is { R: >= 0, G: >= 0, B: >= 0 } && double.IsFinite(s.Radiance.Largest + s.Pdf);
        return isSound ? null : Fact.Wrong($"Sample returned {s}.");
    }

    private Fact? FluxThrough(double radius)
    {
        (double arrives, double arrivesSpread) = Mean(Places(radius, samples).Select(at =>
            light.Sample(at.From, at.Random) is { } s ? s.Radiance.G * Math.Max(0, Vector.Dot(s.Direction, at.Inwards)) / s.Pdf * 4 * Math.PI * radius * radius : 0));
        IndependentSampler sampler = Sampler(1);
        (double leaves, double leavesSpread) = Mean(Enumerable.Range(0, samples).Select(_ => light.Emit(sampler)?.Power.G ?? 0));
        double tolerance = (Histogram.MostDeviations * Math.Sqrt((arrivesSpread * arrivesSpread) + (leavesSpread * leavesSpread))) + (1e-3 * leaves);
        return Math.Abs(arrives - leaves) <= tolerance ? null : Fact.Wrong(
            $"By Sample, {Fact.Text(arrives)} arrives on a ball around the light; by Emit, {Fact.Text(leaves)} leaves it. Light grows weaker by the squared distance, and by the cosine at a surface that shines.",
            leaves, arrives, $"a ball of radius {Fact.Text(radius)}");
    }

    private IEnumerable<(Vector From, Vector Inwards, (double, double) Random)> Places(double radius, int count)
    {
        IndependentSampler sampler = Sampler(0);
        for (int i = 0; i < count; i++)
        {
            Vector outwards = Warp.Sphere(sampler.Next2());
            yield return (around.Middle + (radius * outwards), -outwards, sampler.Next2());
        }
    }

    private IndependentSampler Sampler(int stream)
    {
        IndependentSampler sampler = new(seed);
        sampler.Begin(stream, 0, 0);
        return sampler;
    }

    private static (double Mean, double Spread) Mean(IEnumerable<double> values)
    {
        double[] all = [.. values];
        double mean = all.Average();
        return (mean, Math.Sqrt(all.Sum(v => (v - mean) * (v - mean))) / all.Length);
    }
}
