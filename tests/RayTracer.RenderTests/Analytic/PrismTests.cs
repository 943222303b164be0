using System.Globalization;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Spectra;

namespace RayTracer.RenderTests.Analytic;

/// <summary>
/// Dispersion against Snell's law at each wavelength, and against what must not depend on it.
/// Covers `Dispersion`, `Wavelengths` and `SurfaceShader`.
/// </summary>
[Trait("Category", "Thorough")]
public class PrismTests
{
    private static readonly int s_seeds = TestSettings.Scale(8, 64);

    // The prism's front is met at a right angle, its back, tilted by 30°, from inside.
    private const double Tilt = Math.PI / 6;
    private const double LampDepth = -5;

    [Theory]
    [InlineData(Glass.Bk7, 0.589f)]
    [InlineData(Glass.Sf11, 0.4f)]
    [InlineData(Glass.Sf11, 0.7f)]
    [InlineData(Glass.Diamond, 0.45f)]
    public void Each_wavelength_is_refracted_by_its_own_index(Glass glass, float wavelength)
    {
        DielectricMaterial material = new(1, Rgb.Black, FresnelModel.Exact, dispersion: glass.Dispersion());
        double index = Index(glass, wavelength);
        VertexSamples samples = new(SamplerKind.Sobol.Create(16));
        samples.Begin(7u, 0u, 0u);
        foreach (bool inside in new[] { false, true })
        {
            double angle = inside ? 0.3 : 0.8;
            SurfaceW surface = default;
            surface.Normal = new(0f, 0f, inside ? -1f : 1f);
            surface.Facing = new(0f, 0f, 1f);
            surface.Incoming = new((float)Math.Sin(angle), 0f, (float)-Math.Cos(angle));
            surface.Cosine = (float)Math.Cos(angle);
            surface.Inside = inside ? MaskW.All : MaskW.None;
            surface.Wavelength = wavelength;
            material.Scatter(surface, samples, out ScatterW scatter);
            Assert.True(scatter.Direction.Z[0] < 0, "the numbers choose refraction");
            Assert.Equal(Math.Sin(angle) * (inside ? index : 1 / index), scatter.Direction.X[0], 2e-6);
        }
    }

    [Theory]
    [InlineData(Glass.Bk7, 0.60)]
    [InlineData(Glass.Sf11, 0.65)]
    [InlineData(Glass.Sf11, 0.55)]
    [InlineData(Glass.Sf11, 0.47)]
    public void A_prism_sends_each_colour_where_Snells_law_says(Glass glass, double edgeWavelength)
    {
        // A lamp reaches from far above down to where light of one wavelength arrives: what is bent more passes below it.
        double edge = Arrival(Index(glass, edgeWavelength));
        string scene = Scene($"\"glass\": \"{glass.ToString().ToLowerInvariant()}\"", edge);
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        double[] sums = new double[3];
        double[] all = new double[3];
        for (double nanometres = CieTables.First + 0.05; nanometres < CieTables.Last; nanometres += 0.1)
        {
            double[] response = Response(nanometres);
            double index = Index(glass, nanometres / 1000);
            for (int channel = 0; channel < 3; channel++)
            {
                all[channel] += response[channel];
                sums[channel] += Arrival(index) > edge ? response[channel] * Transmitted(index) : 0;
            }
        }

        for (int channel = 0; channel < 3; channel++)
        {
            BlockEstimate estimate = images.Estimate(new(0, 0, images.Width, images.Height), channel);

            // The weights are the same within a step of the wavelengths, of which the edge cuts one; and weights are at most 3.
            double expected = sums[channel] / all[channel];
            double beyond = Math.Max(0, Math.Abs(estimate.Mean - expected) - (3.0 / Wavelengths.Steps / 4));
            ErrorBudget.Analytic.Check(BlockTest.Welch(estimate with { Mean = expected + beyond }, new(expected, 0, 1)), FormattableString.Invariant($"{glass}, channel {channel}: {estimate.Mean} ± {Math.Sqrt(estimate.Variance)}, expected {expected}"));
        }
    }

    [Theory]
    [InlineData("path", "dielectric")]
    [InlineData("report", "dielectric")]
    [InlineData("path", "roughDielectric")]
    public void Glass_that_could_disperse_but_does_not_looks_like_other_glass(string integrator, string type)
    {
        string scene = """
            { "camera": { "position": [0, 0.6, 4], "lookAt": [0, -0.2, 0], "fieldOfView": 38 },
              "render": { "width": 16, "height": 12, "samplesPerPixel": 64, "integrator": "INTEGRATOR", "maxDepth": 6, "maxSpecularDepth": 3, "maxDiffuseDepth": 1 },
              "background": [0.3, 0.5, 0.7],
              "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 0.8, "material": { "type": "TYPE", INDEX } },
                { "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.4, 0.2] } },
                { "type": "sphere", "center": [1, 2, 1], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 5 } } ] }
            """.Replace("INTEGRATOR", integrator, StringComparison.Ordinal).Replace("TYPE", type, StringComparison.Ordinal);
        ImageSamples even = SceneRuns.RenderText(scene.Replace("INDEX", "\"cauchy\": [1.6, 0]", StringComparison.Ordinal), s_seeds);
        ImageSamples plain = SceneRuns.RenderText(scene.Replace("INDEX", "\"refractiveIndex\": 1.6", StringComparison.Ordinal), s_seeds, firstSeed: 1001);
        BlockTest test = BlockTest.Compare(even, plain);
        ErrorBudget.Analytic.Check(test.P, $"{type} by {integrator}: {test}");
    }

    [Fact]
    public void Dispersing_glass_is_not_seen_in_an_even_light()
    {
        const string scene = """
            { "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0], "fieldOfView": 30 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 256, "integrator": "path" },
              "background": [1, 1, 1],
              "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "dielectric", "glass": "sf11" } } ] }
            """;
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        for (int channel = 0; channel < 3; channel++)
        {
            BlockEstimate all = images.Estimate(new(0, 0, 8, 8), channel);
            ErrorBudget.Analytic.Check(BlockTest.Welch(all, new(1, 0, 1)), FormattableString.Invariant($"channel {channel}: {all.Mean} ± {Math.Sqrt(all.Variance)}"));
        }
    }

    // What arrives along -z at y = 1 and leaves the back, there at z = -tan(30°), at the angle to its normal that Snell says; back at the lamp's depth.
    private static double Arrival(double index)
    {
        double down = Math.Asin(Math.Min(1, index * Math.Sin(Tilt))) - Tilt;
        double start = -Math.Tan(Tilt);
        return 1 - ((start - LampDepth) * Math.Tan(down));
    }

    // Fresnel's equations at both sides: Born & Wolf 1999, section 1.5.2, eq. 21.
    private static double Transmitted(double index)
    {
        double inside = Tilt;
        double outside = Math.Asin(Math.Min(1, index * Math.Sin(inside)));
        double front = 1 - Math.Pow((index - 1) / (index + 1), 2);
        double parallel = Math.Tan(inside - outside) / Math.Tan(inside + outside);
        double across = Math.Sin(inside - outside) / Math.Sin(inside + outside);
        return front * (1 - (((parallel * parallel) + (across * across)) / 2));
    }

    // Sellmeier's formula once more, from the table's own numbers.
    private static double Index(Glass glass, double micrometres)
    {
        Dispersion d = glass.Dispersion();
        double square = micrometres * micrometres;
        return Math.Sqrt(1 + Enumerable.Range(0, 4).Sum(i => d.Strengths[i] * square / (square - d.Resonances[i])));
    }

    private static double[] Response(double nanometres)
    {
        double x = CieTables.Between(CieTables.X, nanometres), y = CieTables.Between(CieTables.Y, nanometres), z = CieTables.Between(CieTables.Z, nanometres);
        return
        [
            Math.Max(0, (3.240479 * x) - (1.537150 * y) - (0.498535 * z)),
            Math.Max(0, (-0.969256 * x) + (1.875991 * y) + (0.041556 * z)),
            Math.Max(0, (0.055648 * x) - (0.204043 * y) + (1.057311 * z)),
        ];
    }

    private static string Scene(string index, double edge) => string.Create(CultureInfo.InvariantCulture, $$"""
        { "camera": { "position": [0, 1, 10], "lookAt": [0, 1, 0], "fieldOfView": 0.001 },
          "render": { "width": 4, "height": 4, "samplesPerPixel": 256, "integrator": "path", "maxDepth": 3 },
          "shapes": [
            { "type": "mesh", "material": { "type": "dielectric", {{index}} },
              "positions": [[-1, 0, 0], [-1, 2, 0], [-1, 0, {{-2 * Math.Tan(Tilt)}}], [1, 0, 0], [1, 2, 0], [1, 0, {{-2 * Math.Tan(Tilt)}}]],
              "triangles": [[0, 1, 2], [3, 5, 4], [0, 3, 4], [0, 4, 1], [1, 4, 5], [1, 5, 2], [0, 2, 5], [0, 5, 3]] },
            { "type": "rectangle", "corner": [-9, {{edge}}, {{LampDepth}}], "edgeU": [18, 0, 0], "edgeV": [0, 50, 0], "material": { "type": "luminaire" } } ] }
        """);
}
