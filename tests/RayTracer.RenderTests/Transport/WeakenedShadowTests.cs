using RayTracer.Description;

namespace RayTracer.RenderTests.Transport;

/// <summary>
/// Shadows of transparent things by the report's integrator, where they only weaken light (section 4.3.1).
/// Covers `ReportShader` and `Transmittance`.
/// </summary>
[Trait("Category", "Thorough")]
public class WeakenedShadowTests
{
    private static readonly int s_seeds = TestSettings.Scale(16, 64);

    [Theory]
    [InlineData("""{ "type": "thinDielectric", "refractiveIndex": 1.5, "specularTransmittance": [0.2, 0.5, 1] }""", 1.0)]
    [InlineData("""{ "type": "mask", "opacity": 0.3, "material": { "type": "diffuse" } }""", 0.0)]
    [InlineData("""{ "type": "invisible" }""", 0.0)]
    public void A_pane_before_a_lamp_leaves_what_it_lets_through(string material, double glass)
    {
        // Head-on, a pane of two faces reflects 2R/(1 + R) (Stokes 1862).
        double reflectance = Math.Pow(0.5 / 2.5, 2);
        double through = 1 - (glass * 2 * reflectance / (1 + reflectance));
        double[] expected = glass > 0 ? [0.2 * through, 0.5 * through, through] : material.Contains("mask", StringComparison.Ordinal) ? [0.7, 0.7, 0.7] : [1, 1, 1];
        double[] lit = Means("");
        double[] weakened = Means($$"""{ "type": "rectangle", "corner": [-1, 5, -1], "edgeU": [2, 0, 0], "edgeV": [0, 0, 2], "material": {{material}} },""");
        for (int channel = 0; channel < 3; channel++)
        {
            Assert.Equal(expected[channel], weakened[channel] / lit[channel], 2e-4);
        }
    }

    [Fact]
    public void A_slab_of_glass_leaves_what_both_faces_and_the_way_between_let_through()
    {
        const string slab = """{ "type": "box", "a": [-1, 5, -1], "b": [1, 7, 1], "material": { "type": "dielectric", "refractiveIndex": 1.5, "extinction": [0.1, 0.5, 0], "specularTransmittance": [1, 0.5, 1] } },""";
        double faces = Math.Pow(1 - Math.Pow(0.5 / 2.5, 2), 2);
        double[] lit = Means("");
        double[] weakened = Means(slab);
        Assert.Equal(faces * Math.Exp(-0.2), weakened[0] / lit[0], 2e-4);
        Assert.Equal(faces * Math.Exp(-1) * 0.25, weakened[1] / lit[1], 2e-4);
        Assert.Equal(faces, weakened[2] / lit[2], 2e-4);
        Assert.All(Means(slab, "false"), m => Assert.Equal(0, m));
    }

    [Theory]
    [InlineData("sf11", 1.78472)]
    [InlineData("diamond", 2.4175)]
    public void Glass_that_disperses_weakens_light_by_its_index_of_yellow_light(string glass, double index)
    {
        // No path has a wavelength where it asks for light: the index of the yellow line of helium holds (SCHOTT 2017; Peter 1923).
        string slab = $$"""{ "type": "box", "a": [-1, 5, -1], "b": [1, 7, 1], "material": { "type": "dielectric", "glass": "{{glass}}" } },""";
        double[] lit = Means("");
        double[] weakened = Means(slab);
        double faces = Math.Pow(1 - Math.Pow((index - 1) / (index + 1), 2), 2);
        Assert.All(weakened.Zip(lit), m => Assert.Equal(faces, m.First / m.Second, 2e-4));
    }

    [Fact]
    public void Where_nothing_bends_light_weakened_shadows_are_the_true_ones()
    {
        // Coloured things of index 1: without the option, paths find the lamp through them by chance; with it, no light is counted twice.
        const string scene = """
            { "camera": { "position": [0, 1.5, 5], "lookAt": [0, 0.3, 0], "fieldOfView": 40 },
              "render": { "width": 16, "height": 12, "samplesPerPixel": 256, "integrator": "report", "maxDiffuseDepth": 1, "maxSpecularDepth": 12, "weakenedShadows": WEAKENED },
              "background": [0.1, 0.2, 0.3],
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
                { "type": "sphere", "center": [-1, 0.8, 0], "radius": 0.6, "material": { "type": "dielectric", "refractiveIndex": 1, "extinction": [0.2, 0.9, 2] } },
                { "type": "rectangle", "corner": [0.3, 0.1, 0], "edgeU": [1.2, 0, 0.3], "edgeV": [0, 1.2, 0], "material": { "type": "thinDielectric", "refractiveIndex": 1, "specularTransmittance": [0.9, 0.4, 0.2] } },
                { "type": "sphere", "center": [0, 3, -2], "radius": 1.2, "material": { "type": "luminaire", "multiplier": 4 } } ] }
            """;
        BlockTest test = BlockTest.Compare(
            SceneRuns.RenderText(scene.Replace("WEAKENED", "true", StringComparison.Ordinal), s_seeds),
            SceneRuns.RenderText(scene.Replace("WEAKENED", "false", StringComparison.Ordinal), s_seeds, firstSeed: 1001));
        ErrorBudget.Transport.Check(test.P, test.ToString());
    }

    // A white floor straight below a small, distant lamp.
    private static double[] Means(string before, string weakened = "true")
    {
        string scene = $$"""
            { "camera": { "position": [3, 1, 0], "lookAt": [0, 0, 0], "fieldOfView": 0.01 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 16, "integrator": "report", "maxDiffuseDepth": 0, "weakenedShadows": {{weakened}} },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [1, 1, 1] } }, {{before}}
                { "type": "sphere", "center": [0, 100, 0], "radius": 0.1, "material": { "type": "luminaire", "multiplier": 1e5 } } ] }
            """;
        ImageSamples images = SceneRuns.RenderText(scene, 1);
        return [.. Enumerable.Range(0, 3).Select(c => images.Estimate(new(0, 0, 4, 4), c).Mean)];
    }
}
