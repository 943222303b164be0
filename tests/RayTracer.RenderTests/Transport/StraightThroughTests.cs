namespace RayTracer.RenderTests.Transport;

/// <summary>
/// Panes, masks and invisible surfaces where what goes straight through them is no bounce.
/// Covers `PathShader` and `Transmittance`.
/// </summary>
[Trait("Category", "Thorough")]
public class StraightThroughTests
{
    private static readonly int s_seeds = TestSettings.Scale(16, 64);

    // Head-on, a pane of two faces reflects 2R/(1 + R) (Stokes 1862).
    private static readonly double s_pane = 1 - (2 * 0.04 / 1.04);

    public static TheoryData<string, double> Panes => new()
    {
        { """{ "type": "thinDielectric", "refractiveIndex": 1.5, "specularTransmittance": 0.5 }""", 0.5 * s_pane },
        { """{ "type": "mask", "opacity": 0.3, "material": { "type": "diffuse", "color": 0 } }""", 0.7 },
        { """{ "type": "mask", "opacity": 0.3, "material": { "type": "thinDielectric", "refractiveIndex": 1.5 } }""", 0.7 + (0.3 * s_pane) },
        { """{ "type": "mask", "opacity": 0.3, "material": { "type": "dielectric", "refractiveIndex": 1.5 } }""", 0.7 },
        { """{ "type": "mix", "weight": 0.25, "first": { "type": "invisible" }, "second": { "type": "diffuse", "color": 0 } }""", 0.75 },
        { """{ "type": "twoSided", "front": { "type": "diffuse" } }""", 0 },
        { """{ "type": "invisible" }""", 1 },
    };

    [Theory]
    [MemberData(nameof(Panes))]
    public void Point_lights_shine_through_what_lets_light_straight_through(string material, double through)
    {
        double lit = LitByPoint("", "true");
        Assert.Equal(through, LitByPoint(Before(material, 5), "true") / lit, 2e-4);
        Assert.Equal(through * through, LitByPoint(Before(material, 5) + Before(material, 6), "true") / lit, 2e-4);
        Assert.Equal(0, LitByPoint(Before(material, 5), "false"));
    }

    [Theory]
    [MemberData(nameof(Panes))]
    public void A_lamp_is_seen_through_many_panes_by_paths_of_one_edge(string material, double through)
    {
        string panes = string.Concat(Enumerable.Range(1, 3).Select(y => Before(material, y)));
        string scene = $$"""
            { "camera": { "position": [0, 9, 0], "lookAt": [0, 0, 0], "up": [0, 0, 1], "fieldOfView": 0.1 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 1024, "integrator": "volPath", "maxDepth": 1, "rouletteDepth": 1, "straightThrough": true },
              "shapes": [ {{panes}} { "type": "rectangle", "corner": [-5, 0, 5], "edgeU": [10, 0, 0], "edgeV": [0, 0, -10], "material": { "type": "luminaire" } } ] }
            """;
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        BlockEstimate mean = images.Estimate(new(0, 0, 8, 8), 0);
        double expected = through == 0 ? 0 : Math.Pow(through, 3);
        Assert.InRange(mean.Mean - expected, -(5 * Math.Sqrt(mean.Variance)) - 1e-6, (5 * Math.Sqrt(mean.Variance)) + 1e-6);
    }

    [Theory]
    [InlineData("", 1)]
    [InlineData("", 12)]
    [InlineData("""{ "type": "sphere", "center": [0.2, 1, 0.3], "radius": 0.7, "material": { "type": "invisible", "interior": { "extinction": [0.5, 1, 2], "albedo": [0.9, 0.8, 0.7], "anisotropy": 0.3 } } },""", 1)]
    public void The_light_of_whole_paths_is_the_same_either_way(string cloud, int lamps)
    {
        string lights = string.Concat(Enumerable.Range(0, lamps).Select(i => $$"""
            { "type": "rectangle", "corner": [{{-0.6 + (0.1 * i)}}, 3, -0.5], "edgeU": [{{(lamps == 1 ? 1 : 0.08)}}, 0, 0], "edgeV": [0, 0, 1], "material": { "type": "luminaire", "multiplier": 8 } },
            """));
        string scene = $$"""
            { "camera": { "position": [0, 2.4, 5], "lookAt": [0, 0.5, 0], "fieldOfView": 40 },
              "render": { "width": 16, "height": 12, "samplesPerPixel": 256, "integrator": "volPath", "straightThrough": STRAIGHT },
              "background": [0.1, 0.15, 0.2],
              "shapes": [ {{lights}} {{cloud}}
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.3 } },
                { "type": "sphere", "center": [-0.8, 0.6, 0], "radius": 0.6, "material": { "type": "mask", "opacity": 0.5, "material": { "type": "roughDielectric", "alpha": 0.3, "refractiveIndex": 1.3 } } },
                { "type": "sphere", "center": [0.8, 0.6, 0], "radius": 0.6, "material": { "type": "mix", "first": { "type": "thinDielectric" }, "second": { "type": "diffuse", "color": 0.7 } } },
                { "type": "rectangle", "corner": [-1.5, 1.6, -1], "edgeU": [3, 0.2, 0], "edgeV": [0, 0, 2], "material": { "type": "thinDielectric", "specularTransmittance": [0.9, 0.6, 0.3] } },
                { "type": "rectangle", "corner": [-1.5, 2, -1], "edgeU": [3, 0, 0], "edgeV": [0, 0.1, 2], "material": { "type": "mask", "opacity": 0.4, "material": { "type": "diffuse", "color": 0.6 } } } ] }
            """;
        BlockTest test = BlockTest.Compare(
            SceneRuns.RenderText(scene.Replace("STRAIGHT", "true", StringComparison.Ordinal), s_seeds),
            SceneRuns.RenderText(scene.Replace("STRAIGHT", "false", StringComparison.Ordinal), s_seeds, firstSeed: 1001));
        ErrorBudget.Transport.Check(test.P, test.ToString());
    }

    [Fact]
    public void Panes_inside_of_a_cloud_leave_paths_and_shadow_rays_in_it()
    {
        // Through 4 of fog at 0.2 and one pane, to the floor, and back up to the camera.
        const string fog = """{ "type": "box", "a": [-9, 2, -9], "b": [9, 6, 9], "material": { "type": "invisible", "interior": { "extinction": 0.2, "albedo": 0 } } },""";
        double lit = LitByPoint("", "true");
        double pane = s_pane * Math.Exp(-0.8);
        Assert.Equal(pane, LitByPoint(fog + Before("""{ "type": "thinDielectric", "refractiveIndex": 1.5 }""", 5), "true") / lit, 5e-4);
    }

    private static string Before(string material, double y) =>
        $$"""{ "type": "rectangle", "corner": [-9, {{y}}, 9], "edgeU": [0, 0, -18], "edgeV": [18, 0, 0], "material": {{material}} },""";

    // A white floor straight below a point light, seen by a camera below whatever is in between.
    private static double LitByPoint(string before, string isStraight)
    {
        string scene = $$"""
            { "camera": { "position": [0, 1, 0], "lookAt": [0, 0, 0], "up": [0, 0, 1], "fieldOfView": 0.1 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 64, "integrator": "volPath", "maxDepth": 2, "straightThrough": {{isStraight}} },
              "shapes": [ {{before}}
                { "type": "rectangle", "corner": [-5, 0, 5], "edgeU": [10, 0, 0], "edgeV": [0, 0, -10], "material": { "type": "diffuse", "color": 1 } },
                { "type": "point", "position": [0, 10, 0], "intensity": 100 } ] }
            """;
        return SceneRuns.RenderText(scene, 1).Estimate(new(0, 0, 4, 4), 0).Mean;
    }
}
