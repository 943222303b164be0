using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.Labs.Tests.Facts;

/// <summary>The facts hold for the textbook edition's materials, and each mistake is found by the fact that is about it.</summary>
public class MaterialFactsTests
{
    private static readonly Dictionary<string, IMaterial> s_right = new()
    {
        ["diffuse"] = new Diffuse(Grey(0.8)),
        ["mirror"] = new Conductor(new(Rgb.Black, Rgb.Black, Grey(1))),
        ["copper"] = new Conductor(new(new(0.2, 0.9, 1.1), new(3.9, 2.4, 2.1), Grey(1))),
        ["glass"] = new Dielectric(1.5, Rgb.Black, isSchlick: false, Grey(1), Grey(1)),
        ["air in glass"] = new Dielectric(0.7, Rgb.Black, isSchlick: true, Grey(1), Grey(1)),
        ["ggx 0.03"] = new Ggx(Grey(0.03), new(Rgb.Black, Rgb.Black, Grey(1))),
        ["ggx 0.5"] = new Ggx(Grey(0.5), new(new(0.2, 0.9, 1.1), new(3.9, 2.4, 2.1), Grey(1))),
        ["ggx 1"] = new Ggx(Grey(1), new(Rgb.Black, Rgb.Black, Grey(1))),
        ["phong"] = new Phong(Grey(0.4), Grey(0.6), 20, null),
        ["phongMetal"] = new Phong(Grey(0), Grey(1), 300, null),
        ["coat"] = new Coated(new Diffuse(Grey(1)), new Phong(Grey(0), Grey(1), 50, null), 0.04),
        ["plastic"] = new Coated(new Diffuse(Grey(1)), new Conductor(new(Rgb.Black, Rgb.Black, Grey(1))), 0.04),
        ["sided"] = new Sided(new Diffuse(Grey(0.3)), null),
    };

    // Each with the fact that names it, and a word of the sentence.
    private static readonly Dictionary<string, (IMaterial Material, string Fact, string Word)> s_wrong = new()
    {
        ["pdf of the sphere"] = (new Edited { PdfFactor = _ => 0.5 }, MaterialFacts.PdfIntegral, "half of what it should be"),
        ["pdf too large"] = (new Edited { PdfFactor = _ => 2 }, MaterialFacts.PdfIntegral, "did you forget that only one hemisphere is sampled?"),
        ["pdf without π"] = (new Edited { PdfFactor = _ => Math.PI }, MaterialFacts.PdfIntegral, "π times too large"),
        ["uniform pdf"] = (new Edited { PdfFactor = d => d.Z > 0 ? 0.5 / d.Z : 1 }, MaterialFacts.Directions, "same everywhere above the surface"),
        ["azimuth"] = (new Edited { Turn = d => new(d.X, Math.Abs(d.Y), d.Z) }, MaterialFacts.Directions, "Samples do not follow the pdf"),
        ["through the surface"] = (new Edited { Turn = d => d with { Z = d.X > 0 ? d.Z : -d.Z } }, MaterialFacts.Directions, "below the surface"),
        ["weight without cosine"] = (new Edited { WeightFactor = d => 1 / d.Z }, MaterialFacts.Weights, "The cosine is missing"),
        ["cosine twice"] = (new Edited { WeightFactor = d => d.Z }, MaterialFacts.Weights, "The cosine is in it twice"),
        ["weight without pdf"] = (new Edited { WeightFactor = d => d.Z / Math.PI }, MaterialFacts.Weights, "not divided by the pdf"),
        ["brdf without π"] = (new Edited { BsdfFactor = (_, _) => Math.PI }, MaterialFacts.Energy, "colour/π"),
        ["not reciprocal"] = (new Edited { BsdfFactor = (viewer, _) => 1 - (0.5 * viewer.Z) }, MaterialFacts.Reciprocity, "with both directions exchanged"),
        ["light from below"] = (new Edited { FromBelow = true }, MaterialFacts.Support, "below the surface"),
        ["not a unit vector"] = (new Edited { Turn = d => d * 1.1 }, MaterialFacts.Numbers, "length is not 1"),
        ["negative"] = (new Edited { WeightFactor = _ => -1 }, MaterialFacts.Numbers, "weight of"),
        ["throws"] = (new Edited { WeightFactor = _ => throw new InvalidOperationException("there is no colour") }, MaterialFacts.Numbers, "threw InvalidOperationException: there is no colour"),
        ["mirrors' shares"] = (new Shares(1.5, false), MaterialFacts.Mirrors, "chosen with a probability"),
        ["particles' weight"] = (new Shares(1, true), MaterialFacts.Energy, "ParticleWeight"),
    };

    public static TheoryData<string> Right => [.. s_right.Keys];

    public static TheoryData<string> Wrong => [.. s_wrong.Keys];

    [Theory]
    [MemberData(nameof(Right))]
    [Trait("Category", "Thorough")]
    public void The_facts_hold_for_materials_that_are_right(string name)
    {
        string? exception = s_right[name] is Phong or Coated ? "the lobe stands for BRDF · cosine" : null;
        for (int seed = 0; seed < TestSettings.Scale(1, 4); seed++)
        {
            IReadOnlyList<Fact> facts = new MaterialFacts(s_right[name], new() { ReciprocityException = exception }, TestSettings.Seed + seed, 1 << 13).All();
            Assert.All(facts, f => Assert.True(f.Holds, $"{name}, seed {seed}: {f}"));
            Assert.Equal(8, facts.Count);
        }
    }

    [Theory]
    [MemberData(nameof(Wrong))]
    public void A_mistake_is_named_by_the_fact_that_is_about_it(string name)
    {
        (IMaterial material, string about, string word) = s_wrong[name];
        Fact fact = new MaterialFacts(material, null, TestSettings.Seed, 1 << 13).All().First(f => f.Name == about);
        Assert.False(fact.Holds, fact.Sentence);
        Assert.Contains(word, fact.Sentence, StringComparison.Ordinal);
        Assert.Contains("from the normal", fact.Case, StringComparison.Ordinal);
    }

    [Fact]
    public void What_is_not_reciprocal_is_found_out()
    {
        Fact fact = new MaterialFacts(s_right["phong"], null, TestSettings.Seed, 1 << 10).All().First(f => f.Name == MaterialFacts.Reciprocity);
        Assert.False(fact.Holds);
        Assert.NotEqual(fact.Expected, fact.Found, 1e-6);
    }

    [Fact]
    public void Directions_that_are_off_are_drawn()
    {
        Fact fact = new MaterialFacts(s_wrong["uniform pdf"].Material, null, TestSettings.Seed, 1 << 13).All().First(f => f.Name == MaterialFacts.Directions);
        string drawing = fact.Drawing!.ToString();
        Assert.Contains("red: too many, blue: too few", drawing, StringComparison.Ordinal);
        Assert.True(drawing.Split("<rect").Length > 3 * 128, "three panels of cells");
    }

    private static Solid Grey(double value) => new(new(value));

    /// <summary>A diffuse material with a mistake.</summary>
    private sealed class Edited : IMaterial
    {
        private readonly Diffuse _right = new(Grey(0.8));

        public Func<Vector, double> PdfFactor { get; init; } = _ => 1;

        public Func<Vector, double> WeightFactor { get; init; } = _ => 1;

        public Func<Vector, Vector, double> BsdfFactor { get; init; } = (_, _) => 1;

        public Func<Vector, Vector> Turn { get; init; } = d => d;

        public bool FromBelow { get; init; }

        public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) =>
            _right.Evaluate(hit, toViewer, FromBelow ? toLight with { Z = Math.Abs(toLight.Z) } : toLight) * BsdfFactor(toViewer, toLight);

        public double Pdf(in Hit hit, Vector from, Vector to) => _right.Pdf(hit, from, to) * PdfFactor(to);

        public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
        {
            Scattering right = _right.Sample(hit, from, sampler)!.Value;
            Vector to = Turn(right.Direction);
            return right with { Direction = to, Weight = right.Weight * WeightFactor(to), Pdf = Pdf(hit, from, to) };
        }
    }

    /// <summary>Glass with a mistake: samples weigh too much, or particles of light as much as radiance.</summary>
    private sealed class Shares(double factor, bool countsSquare) : IMaterial
    {
        private readonly Dielectric _right = new(1.5, Rgb.Black, isSchlick: false, Grey(1), Grey(1));

        public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => default;

        public double Pdf(in Hit hit, Vector from, Vector to) => 0;

        public Scattering? Sample(in Hit hit, Vector from, ISampler sampler) => _right.Sample(hit, from, sampler) is { } s ? Edit(s with { Weight = s.Weight * factor }) : null;

        public IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from) => [.. _right.Mirrors(hit, from).Select(Edit)];

        private Scattering Edit(Scattering s) => countsSquare ? s with { ParticleWeight = s.Weight } : s;
    }
}
