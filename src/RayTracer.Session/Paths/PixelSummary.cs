using RayTracer.Description;

namespace RayTracer.Session;

/// <summary>Where the light of a pixel comes from, over many of its samples.</summary>
/// <param name="Samples">The number of samples.</param>
/// <param name="Mean">The mean luminance.</param>
/// <param name="Noise">The standard error of the mean over the mean; 0 where it is dark.</param>
/// <param name="Lights">Shares by the light that it comes from.</param>
/// <param name="Things">Shares by what reflected it last before the camera.</param>
/// <param name="Depths">Shares by the number of edges of the path.</param>
/// <param name="Techniques">Shares by how it was found, and what each has of the noise.</param>
/// <param name="Advice">What would lessen the noise.</param>
public sealed record PixelSummary(
    int Samples, double Mean, double Noise, IReadOnlyList<LightShare> Lights, IReadOnlyList<LightShare> Things, IReadOnlyList<LightShare> Depths,
    IReadOnlyList<LightShare> Techniques, string Advice)
{
    private const double Little = 0.01;

    /// <summary>Adds up paths.</summary>
    /// <param name="paths">The paths.</param>
    /// <param name="integrator">The integrator that made them.</param>
    public static PixelSummary Of(IReadOnlyList<InspectedPath> paths, Integrator integrator)
    {
        Portion[] portions = [.. paths.SelectMany(p => Portions(p, integrator))];
        double mean = paths.Average(p => p.Radiance.Luminance);
        double variance = paths.Sum(p => (p.Radiance.Luminance - mean) * (p.Radiance.Luminance - mean)) / Math.Max(1, paths.Count - 1);
        double noise = mean > 0 ? Math.Sqrt(variance / paths.Count) / mean : 0;
        LightShare[] techniques = [.. Shares(portions, p => p.Technique, paths.Count).OrderByDescending(t => t.Variance)];
        return new(
            paths.Count, mean, noise, Shares(portions, p => p.Light, paths.Count), Shares(portions, p => p.Thing, paths.Count), Shares(portions, p => p.Depth, paths.Count), techniques,
            Advise(noise, techniques.FirstOrDefault()?.Name, paths.Count, integrator));
    }

    private static IEnumerable<Portion> Portions(InspectedPath path, Integrator integrator)
    {
        string first = path.Vertices.Count > 1 ? path.Vertices[1].Name : "camera";
        if (path.Ways.Count > 0)
        {
            return path.Ways.Select(w => new Portion(path.Sample, w.Radiance.Luminance, w.Light.Length > 0 ? w.Light : "all lights", first, $"{w.LightVertices + w.CameraVertices - (w.Event == "merged" ? 2 : 1)}", w.Event));
        }

        return path.Vertices.SelectMany((v, i) => OfVertex(path, v, i, first, integrator));
    }

    private static IEnumerable<Portion> OfVertex(InspectedPath path, InspectedVertex v, int i, string first, Integrator integrator)
    {
        string technique = i == 1 ? "seen" : PathSentence.IsByChance(path.Vertices, i, integrator) ? "chance" : "met";
        yield return new(path.Sample, Luminance(v.Parts.Emitted), v.Emission?.Name ?? v.Name, first, $"{i}", technique);
        yield return new(path.Sample, Luminance(v.Parts.Ambient), "ambient light", first, $"{i}", "ambient");
        foreach (InspectedLight light in v.Lights)
        {
            yield return new(path.Sample, light.Contribution.Luminance, light.Name, first, $"{i + 1}", i == 1 ? "direct" : "indirect");
        }
    }

    private static LightShare[] Shares(Portion[] portions, Func<Portion, string> by, int samples)
    {
        double sum = portions.Sum(p => p.Amount);
        LightShare[] shares = [.. portions.GroupBy(by).Select(g =>
        {
            double[] each = [.. g.GroupBy(p => p.Sample).Select(s => s.Sum(p => p.Amount))];
            double mean = each.Sum() / samples;
            return new LightShare(g.Key, sum > 0 ? g.Sum(p => p.Amount) / sum : 0, (each.Sum(e => e * e) / samples) - (mean * mean), [.. g.Where(p => p.Amount > 0).Select(p => p.Sample).Distinct()]);
        })];
        double all = shares.Sum(s => s.Variance);
        return [.. shares.Where(s => s.Share > 0).Select(s => s with { Variance = all > 0 ? s.Variance / all : 0 }).OrderByDescending(s => s.Share)];
    }

    private static string Advise(double noise, string? noisiest, int samples, Integrator integrator) => noise < Little
        ? "There is hardly any noise here."
        : noisiest switch
        {
            "chance" => "Most of the noise is of light that paths meet by chance only: integrators that trace light too (bidirectional, vcm) find it.",
            "direct" => "Most of the noise is of direct light: edges of shadows and large lights. Four times the samples halve it.",
            "indirect" or "met" when integrator.Has(IntegratorTraits.Guides) => "Most of the noise is of light that comes by several bounces: path guiding, or four times the samples, which halve it.",
            "merged" => "Most of the noise is of merges: more samples, or a larger radius of merging, which blurs.",
            _ => "Four times the samples halve the noise.",
        } + (samples < 8 ? " (Few samples: this is an estimate.)" : "");

    private static double Luminance(IReadOnlyList<double> c) => (0.2126 * c[0]) + (0.7152 * c[1]) + (0.0722 * c[2]);

    private readonly record struct Portion(int Sample, double Amount, string Light, string Thing, string Depth, string Technique);
}

/// <summary>A part of a pixel's light.</summary>
/// <param name="Name">The name of the part.</param>
/// <param name="Share">Its fraction of the light.</param>
/// <param name="Variance">Its fraction of the noise, if parts were independent.</param>
/// <param name="Samples">The samples that have such light.</param>
public sealed record LightShare(string Name, double Share, double Variance, IReadOnlyList<int> Samples);
