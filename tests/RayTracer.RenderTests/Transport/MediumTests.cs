using RayTracer.Description;

namespace RayTracer.RenderTests.Transport;

/// <summary>Media against closed forms.</summary>
[Trait("Category", "Thorough")]
public class MediumTests
{
    private static readonly int s_seeds = TestSettings.Scale(16, 96);

    [Theory]
    [InlineData("""{ "type": "invisible", "interior": { "extinction": [0.5, 2, 8], "albedo": [1, 1, 1], "anisotropy": 0 } }""", 1e-4)]
    [InlineData("""{ "type": "invisible", "interior": { "extinction": [3, 3, 3], "albedo": [1, 1, 1], "anisotropy": 0.8 } }""", 1e-4)]
    [InlineData("""{ "type": "invisible", "interior": { "extinction": [1, 0, 3], "albedo": [1, 1, 1], "anisotropy": -0.5 } }""", 1e-4)]
    [InlineData("""{ "type": "invisible", "interior": { "extinction": [1, 2, 3], "albedo": [1, 1, 1], "phase": { "shape": "mix", "weight": 1, "weightGrid": { "size": [2, 1, 1], "values": [0, 1], "box": [[-1, -1, -1], [1, 1, 1]] }, "first": { "shape": "rayleigh" }, "second": { "shape": "table", "values": [1, 0, 0, 4] } } } }""", 1e-4)]
    [InlineData("""{ "type": "invisible", "interior": { "extinction": [4, 2, 1], "albedo": [1, 1, 1], "phase": { "shape": "sggx", "matrix": [0.9, 0.3, 0.15, 0.2, -0.1, 0.05] } } }""", 1e-4)]
    [InlineData("""{ "type": "dielectric", "refractiveIndex": 1.5, "interior": { "extinction": [2, 1, 0.5], "albedo": [1, 1, 1] } }""", 1e-3)]
    public void What_only_scatters_is_not_seen_in_an_even_light(string material, double tolerance)
    {
        ImageSamples images = SceneRuns.RenderText(Ball(material, "[1, 1, 1]", ""), s_seeds);
        for (int channel = 0; channel < 3; channel++)
        {
            // Paths that are cut off at the depth limit are missing.
            BlockEstimate all = images.Estimate(new(0, 0, images.Width, images.Height), channel);
            Assert.InRange(all.Mean, 1 - tolerance - (6 * Math.Sqrt(all.Variance)), 1 + 1e-4 + (6 * Math.Sqrt(all.Variance)));
        }
    }

    [Fact]
    public void No_path_is_brighter_than_its_channels_together_are_at_first()
    {
        // A flight makes none of three channels brighter without making the others darker; only the roulette makes up for paths that end.
        const string fog = """{ "type": "invisible", "interior": { "extinction": [0.5, 2, 8], "albedo": [1, 1, 1] } }""";
        string scene = Ball(fog, "[1, 1, 1]", "").Replace("\"volPath\"", "\"volPath\", \"rouletteDepth\": 30000", StringComparison.Ordinal);
        ImageSamples images = SceneRuns.RenderText(scene, 2);
        Assert.All(Enumerable.Range(0, images.Count), i => Assert.All(Enumerable.Range(0, 3 * images.Width * images.Height), at => Assert.InRange(images.Value(i, at), 0, 3.001f)));
    }

    [Fact]
    public void What_only_absorbs_lets_through_what_Beers_law_says()
    {
        // Straight through the middle of a ball of radius 1, and of one within it whose medium counts there instead.
        const string ball = """{ "type": "invisible", "interior": { "extinction": [0.5, 1, 0.1] } }""";
        const string inner = """, { "type": "sphere", "center": [0, 0, 0], "radius": 0.25, "material": { "type": "invisible", "interior": { "extinction": [2, 0, 1e-9] } } }""";
        Check(SceneRuns.RenderText(Ball(ball, "[1, 1, 1]", "", fieldOfView: 1e-3), 2), [Math.Exp(-1), Math.Exp(-2), Math.Exp(-0.2)]);
        Check(SceneRuns.RenderText(Ball(ball, "[1, 1, 1]", inner, fieldOfView: 1e-3), 2), [Math.Exp(-0.75 - 1), Math.Exp(-1.5), Math.Exp(-0.15)]);
    }

    [Fact]
    public void Flakes_let_through_what_Beers_law_says_of_how_large_they_look()
    {
        // Along z, half as large as along x.
        const string ball = """{ "type": "invisible", "interior": { "extinction": [0.5, 1, 0.1], "phase": { "shape": "sggx", "matrix": [1, 0.5, 0.25, 0, 0, 0.1] } } }""";
        Check(SceneRuns.RenderText(Ball(ball, "[1, 1, 1]", "", fieldOfView: 1e-3), 2), [Math.Exp(-0.5), Math.Exp(-1), Math.Exp(-0.1)]);
        string aside = Ball(ball, "[1, 1, 1]", "", fieldOfView: 1e-3).Replace("\"position\": [0, 0, 4]", "\"position\": [4, 0, 0]", StringComparison.Ordinal);
        Check(SceneRuns.RenderText(aside, 2), [Math.Exp(-1), Math.Exp(-2), Math.Exp(-0.2)]);
    }

    [Theory]
    [InlineData("path")]
    [InlineData("volPath")]
    public void What_shines_is_as_bright_as_the_integral_along_the_ray(string integrator)
    {
        // Over a way of 2, (1 - e^(-extinction · 2))/extinction; of a light behind, the rest is left.
        const string flame = """{ "type": "invisible", "interior": { "extinction": [0, 0.5, 4], "emission": [1, 0.5, 3] } }""";
        string scene = Ball(flame, "[0, 0, 1]", "", fieldOfView: 1e-3).Replace("volPath", integrator, StringComparison.Ordinal);
        Check(SceneRuns.RenderText(scene, 2), [2, 1 - Math.Exp(-1), (0.75 * (1 - Math.Exp(-8))) + Math.Exp(-8)]);
        const string thin = """{ "type": "invisible", "interior": { "extinction": [1e-7, 1e-3, 0.0149], "emission": [0.5, 0.5, 0.5] } }""";
        Check(SceneRuns.RenderText(Ball(thin, "[0, 0, 0]", "", fieldOfView: 1e-3), 2), [1, 0.5 * (1 - Math.Exp(-2e-3)) / 1e-3, 0.5 * (1 - Math.Exp(-0.0298)) / 0.0149]);
    }

    [Theory]
    [InlineData("""{ "type": "invisible", "interior": { "extinction": [0.5, 2, 8], "albedo": [0.8, 0.5, 0], "emission": [0.1, 1, 8], "anisotropy": 0.3 } }""")]
    [InlineData("""{ "type": "invisible", "interior": { "extinction": [0.5, 2, 8], "emission": [0.5, 2, 8] } }""")]
    public void What_shines_as_much_as_it_absorbs_is_not_seen_in_an_even_light(string material)
    {
        ImageSamples images = SceneRuns.RenderText(Ball(material, "[1, 1, 1]", ""), s_seeds);
        for (int channel = 0; channel < 3; channel++)
        {
            BlockEstimate all = images.Estimate(new(0, 0, images.Width, images.Height), channel);
            Assert.InRange(all.Mean, 1 - 1e-4 - (6 * Math.Sqrt(all.Variance)), 1 + 1e-4 + (6 * Math.Sqrt(all.Variance)));
            Assert.True(Math.Sqrt(all.Variance) < 0.01);
        }
    }

    [Fact]
    public void Shadows_of_media_are_as_dark_as_Beers_law_says()
    {
        // A lamp straight above the point looked at, with two balls in between: directly through both middles.
        const string scene = """
            { "camera": { "position": [3, 0.5, 0], "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
              "render": { "width": 2, "height": 2, "samplesPerPixel": 4, "integrator": "volPath", "maxDepth": 2 },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [1, 1, 1] } },
                BALLS { "type": "sphere", "center": [0, 20, 0], "radius": 0.05, "material": { "type": "luminaire", "multiplier": 1e5 } } ] }
            """;
        const string balls = """
            { "type": "sphere", "center": [0, 2, 0], "radius": 0.5, "material": { "type": "invisible", "interior": { "extinction": [1, 2, 3] } } },
            { "type": "box", "a": [-1, 4, -1], "b": [1, 6, 1], "material": { "type": "invisible", "interior": { "extinction": [0.5, 0, 0.1], "albedo": [0.5, 0.5, 0.5] } } },
            """;
        double[] lit = Means(SceneRuns.RenderText(scene.Replace("BALLS", "", StringComparison.Ordinal), 1));
        double[] dark = Means(SceneRuns.RenderText(scene.Replace("BALLS", balls, StringComparison.Ordinal), 1));
        double[] depth = [1 + 1, 2, 3 + 0.2];
        for (int channel = 0; channel < 3; channel++)
        {
            Assert.Equal(Math.Exp(-depth[channel]), dark[channel] / lit[channel], 2e-3);
        }
    }

    [Theory]
    [InlineData("\"anisotropy\": 0", 1)]
    [InlineData("\"anisotropy\": 0.7", 0.2804082)]
    [InlineData("\"anisotropy\": -0.6", 0.4035261)]
    [InlineData("\"phase\": { \"anisotropy\": 0.7 }", 0.2804082)]
    [InlineData("\"phase\": { \"shape\": \"rayleigh\" }", 0.75)]
    [InlineData("\"phase\": { \"shape\": \"table\", \"values\": [1, 2, 6] }", 2 / 2.75)]
    [InlineData("\"phase\": { \"shape\": \"mix\", \"weight\": 0.2, \"first\": { \"shape\": \"rayleigh\" }, \"second\": { \"anisotropy\": 0.7 } }", (0.8 * 0.75) + (0.2 * 0.2804082))]
    [InlineData("\"phase\": { \"shape\": \"sggx\", \"matrix\": [1, 0.0625, 1, 0, 0, 0] }", 4)]
    public void A_thin_cloud_scatters_once_as_the_phase_function_says(string scattering, double beside)
    {
        // Light along +x meets a thin ball; seen along -z, the light that is scattered by a right angle: extinction · albedo · way · phase(0) · irradiance. Of Henyey and Greenstein's,
        // that is (1 - g²)/(1 + g²)^1.5 of what is scattered evenly. Fibres along y of the roughness r look as large from all sides beside, and have all their mirrors around: 1/r of it.
        string scene = $$"""
            { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 0.01 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 256, "integrator": "volPath", "maxDepth": 2 },
              "lights": [{ "type": "directional", "direction": [1, 0, 0], "irradiance": [1, 1, 1] }],
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "invisible", "interior": { "extinction": [0.02, 0.02, 0.02], "albedo": [1, 0.5, 0.25], {{scattering}} } } }] }
            """;
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        double phase = beside / (4 * Math.PI);

        // Out of the depth z of the ball's diameter, on the way there and from the light, the rest is lost: integrated by the midpoint rule.
        const int steps = 2000;
        double ways = Enumerable.Range(0, steps).Select(i => -1 + ((i + 0.5) * 2 / steps)).Sum(z => Math.Exp(-0.02 * ((1 - z) + Math.Sqrt(1 - (z * z)))) * 2 / steps);
        double[] albedo = [1, 0.5, 0.25];
        for (int channel = 0; channel < 3; channel++)
        {
            BlockEstimate all = images.Estimate(new(0, 0, 4, 4), channel);
            double expected = 0.02 * albedo[channel] * phase * ways;
            ErrorBudget.Analytic.Check(BlockTest.Welch(all, new(expected, 0, 1)), $"{all.Mean} ± {Math.Sqrt(all.Variance)}, expected {expected}");
        }
    }

    private static void Check(ImageSamples images, double[] expected)
    {
        double[] means = Means(images);
        for (int channel = 0; channel < 3; channel++)
        {
            Assert.Equal(expected[channel], means[channel], 1e-5);
        }
    }

    private static double[] Means(ImageSamples images) => [.. Enumerable.Range(0, 3).Select(c => images.Estimate(new(0, 0, images.Width, images.Height), c).Mean)];

    private static string Ball(string material, string background, string more, double fieldOfView = 40) => $$"""
        { "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0], "fieldOfView": {{fieldOfView.ToString(System.Globalization.CultureInfo.InvariantCulture)}} },
          "render": { "width": 16, "height": 16, "samplesPerPixel": 16, "integrator": "volPath" },
          "background": {{background}},
          "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": {{material}} } {{more}} ] }
        """;
}
