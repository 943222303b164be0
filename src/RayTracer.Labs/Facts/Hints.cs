using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.Labs;

/// <summary>What is often the reason, by the factor that something is off.</summary>
internal static class Hints
{
    /// <summary>Of a pdf whose integral is so many times what it should be.</summary>
    public static string OfPdf(double factor) => factor switch
    {
        _ when Is(factor, 2) => "Your pdf is 2.0 times too large: did you forget that only one hemisphere is sampled?",
        _ when Is(factor, 0.5) => "Your pdf is half of what it should be: over one hemisphere a uniform density is 1/2π, over the whole sphere 1/4π.",
        _ when Is(factor, Math.PI) => "Your pdf is π times too large: the cosine's integral over the hemisphere is π.",
        _ when Is(factor, 1 / Math.PI) => "Your pdf is π times too small: is it divided by π once too often?",
        _ when Is(factor, 4 * Math.PI) => "Your pdf is 4π times too large: a uniform density over the sphere is 1/4π.",
        _ when Is(factor, 2 * Math.PI) => "Your pdf is 2π times too large: a uniform density over the hemisphere is 1/2π.",
        _ when Is(factor, 1) => "The pdf is right on the whole, but not everywhere.",
        0 => "Your pdf is zero wherever samples go.",
        _ => $"Your pdf is {Fact.Text(factor)} times what it should be.",
    };

    /// <summary>Of energy that is created.</summary>
    public static string OfEnergy(double factor, double mirrored) => factor switch
    {
        _ when mirrored > 1 => "The single directions alone carry more than all: is the weight of particles (ParticleWeight) without the squared refractive index?",
        _ when factor < Math.PI * 1.01 => "The cosine's integral over the hemisphere is π, so that a diffuse BRDF is colour/π: is the division missing?",
        _ => "The integral of BSDF · cosine must not be above one.",
    };

    /// <summary>Of directions that do not follow the pdf.</summary>
    public static string OfDirections(Histogram found, MaterialCase at, IMaterial material)
    {
        bool isLow = found.Worst.At.Y < 0;
        bool isUniform = Math.Abs(material.Pdf(at.Hit, at.From, new(0.6, 0, 0.8)) - material.Pdf(at.Hit, at.From, new(0.8, 0, 0.6))) < 1e-9;
        return isLow ? "Do samples go below the surface?"
            : isUniform ? "The pdf is the same everywhere above the surface: are the samples?"
            : "Compare the drawings: do both have their brightest place where you expect it?";
    }

    /// <summary>Of weights that are not BSDF · cosine / pdf.</summary>
    /// <param name="wrong">Samples, and what their weights should be.</param>
    public static string OfWeights((Scattering Sample, Rgb Expected)[] wrong)
    {
        (string Name, Func<Scattering, double> Factor)[] reasons =
        [
            ("The cosine is missing.", s => 1 / Math.Abs(s.Direction.Z)),
            ("The cosine is in it twice.", s => Math.Abs(s.Direction.Z)),
            ("It is not divided by the pdf.", s => s.Pdf),
            ("It is the BSDF alone, without cosine and pdf.", s => s.Pdf / Math.Abs(s.Direction.Z)),
            ("It is π times too large.", _ => Math.PI),
            ("It is π times too small.", _ => 1 / Math.PI),
        ];
        (string Name, Func<Scattering, double> Factor) fits =
            Array.Find(reasons, r => wrong.All(w => Is(w.Sample.Weight.G, w.Expected.G * r.Factor(w.Sample))));
        return fits.Name ?? "";
    }

    // As near as noise lets it be.
    private static bool Is(double a, double b) => Math.Abs(a - b) <= 0.03 * Math.Abs(b);
}
