using RayTracer.Description;

namespace RayTracer.RenderTests.Transport;

/// <summary>Dielectrics that overlap, with priorities, against the same boundaries without overlap and against closed forms.</summary>
[Trait("Category", "Thorough")]
public class NestingTests
{
    private const double Glass = 1.5;
    private const double Water = 1.33;
    private static readonly int s_seeds = TestSettings.Scale(8, 32);

    // Glass from y = 2 to 3 over water; where the water reaches up into the glass to y = 2.5, the glass is there.
    private const string Overlapping = """
        { "type": "box", "a": [-50, 2, -50], "b": [50, 3, 50], "material": { "type": "GLASS", "refractiveIndex": 1.5, "priority": 7, "extinction": [0.1, 0.2, 0.3] } },
        { "type": "box", "a": [-50, 0, -50], "b": [50, 2.5, 50], "material": { "type": "WATER", "refractiveIndex": 1.33, "priority": 2, "extinction": [0.5, 0.2, 0.1] INTERIOR } }
        """;

    // The same water and glass, each boundary once, by indices relative to what is around. Both faces of the glass are its own.
    private const string Exact = """
        { "type": "plane", "point": [0, 3, 0], "normal": [0, 1, 0], "material": { "type": "GLASS", "refractiveIndex": 1.5 } },
        { "type": "plane", "point": [0, 2, 0], "normal": [0, 1, 0], "material": { "type": "GLASS", "refractiveIndex": 0.886666667 INTERIOR } }
        """;

    [Theory]
    [InlineData(2.5)]
    [InlineData(2.001)]
    [InlineData(2.999)]
    public void Light_straight_through_glass_and_water_is_what_Fresnel_and_Beer_say(double overlap)
    {
        // Camera, glass, water, lamp: what lies within the glass is no edge.
        string scene = $$"""
            { "camera": { "position": [0.1, 10, 0.2], "lookAt": [0.1, 0, 0.2], "up": [0, 0, 1], "fieldOfView": 0.001 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 1024, "integrator": "path", "maxDepth": 3 },
              "shapes": [ { "type": "rectangle", "corner": [-50, 1, -50], "edgeU": [0, 0, 100], "edgeV": [100, 0, 0], "material": { "type": "luminaire", "multiplier": 3 } },
                {{Plain(Overlapping).Replace("2.5", overlap.ToString(System.Globalization.CultureInfo.InvariantCulture), StringComparison.Ordinal)}} ] }
            """;
        double through = (1 - Reflectance(Glass)) * (1 - Reflectance(Glass / Water)) / (Water * Water);
        double[] depth = [0.1 + 0.5, 0.2 + 0.2, 0.3 + 0.1];
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        for (int channel = 0; channel < 3; channel++)
        {
            Check(images, channel, 3 * through * Math.Exp(-depth[channel]));
        }
    }

    [Theory]
    [InlineData("path", "dielectric", "dielectric", "")]
    [InlineData("path", "dielectric", "roughDielectric", "")]
    [InlineData("path", "roughDielectric", "dielectric", "")]
    [InlineData("volPath", "dielectric", "dielectric", """, "interior": { "extinction": [0.5, 1, 2], "albedo": [0.9, 0.8, 0.7], "anisotropy": 0.3 } """)]
    public void What_overlaps_by_priority_looks_as_what_fits(string integrator, string glass, string water, string interior)
    {
        // A lamp and a ball stand in the glass on both sides of the water's upper face, and another ball half in the water.
        BlockTest test = BlockTest.Compare(
            SceneRuns.RenderText(Scene(Overlapping), s_seeds),
            SceneRuns.RenderText(Scene(Exact), s_seeds, firstSeed: 1001));
        ErrorBudget.Transport.Check(test.P, $"{glass} over {water} by {integrator}: {test}");

        string Scene(string boundaries) => $$"""
            { "camera": { "position": [0, 7, 4], "lookAt": [0, 2, 0], "fieldOfView": 40 },
              "render": { "width": 16, "height": 12, "samplesPerPixel": 64, "integrator": "{{integrator}}", "maxDepth": 7 },
              "background": [0.5, 0.6, 0.7],
              "shapes": [ { "type": "plane", "point": [0, 1, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.8, 0.6, 0.4] } },
                { "type": "sphere", "center": [0.9, 2.25, 0], "radius": 0.2, "material": { "type": "luminaire", "multiplier": 9 } },
                { "type": "sphere", "center": [-0.4, 2.72, 0.3], "radius": 0.2, "material": { "type": "diffuse", "color": [0.9, 0.9, 0.9] } },
                { "type": "sphere", "center": [0.2, 1.9, 0.9], "radius": 0.4, "material": { "type": "diffuse", "color": [0.3, 0.9, 0.5] } },
                {{Colourless(boundaries).Replace("GLASS", glass, StringComparison.Ordinal).Replace("WATER", water, StringComparison.Ordinal).Replace("INTERIOR", interior, StringComparison.Ordinal)}} ] }
            """;
    }

    [Fact]
    public void Glass_with_a_priority_is_seen_in_fog()
    {
        // Fog as thin as this is nothing; only that its boundaries count as edges.
        const string fog = """{ "type": "sphere", "center": [0, 0, 0], "radius": 3, "material": { "type": "invisible", "interior": { "extinction": [1e-6, 1e-6, 1e-6] } } },""";
        string scene = $$"""
            { "camera": { "position": [0, 2, 7], "lookAt": [0, 0, 0], "fieldOfView": 30 },
              "render": { "width": 16, "height": 12, "samplesPerPixel": 64, "integrator": "path", "maxDepth": -1 },
              "background": [0.5, 0.6, 0.7],
              "shapes": [ {{fog}} { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "dielectric", "refractiveIndex": 1.5, "priority": 1, "extinction": [0.5, 1, 0] } },
                { "type": "plane", "point": [0, -1.5, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.8, 0.6, 0.4] } } ] }
            """;
        BlockTest test = BlockTest.Compare(
            SceneRuns.RenderText(scene, s_seeds),
            SceneRuns.RenderText(scene.Replace(fog, "", StringComparison.Ordinal), s_seeds, firstSeed: 1001));
        ErrorBudget.Transport.Check(test.P, test.ToString());
    }

    [Fact]
    public void Two_of_a_kind_that_overlap_are_one()
    {
        // Through two drops of one water, one edge in and one out.
        const string scene = """
            { "camera": { "position": [0, 0, 9], "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 1024, "integrator": "path", "maxDepth": 3 },
              "background": [1, 1, 1],
              "materials": { "water": { "type": "dielectric", "refractiveIndex": 1.33, "priority": 1, "extinction": [0.1, 0, 0.2] } },
              "shapes": [ { "type": "sphere", "center": [0, 0, 0.5], "radius": 1, "material": "water" }, { "type": "sphere", "center": [0, 0, -0.5], "radius": 1, "material": "water" } ] }
            """;
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        double through = Math.Pow(1 - Reflectance(Water), 2);
        Check(images, 0, (through * Math.Exp(-0.3)) + (Reflectance(Water) * 1));
        Check(images, 1, through + Reflectance(Water));
    }

    [Fact]
    public void Of_three_that_overlap_the_one_with_the_highest_priority_counts()
    {
        // Balls around one middle; the outer ones' insides count only where no other is.
        string scene = """
            { "camera": { "position": [0, 0, 9], "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 64, "integrator": "path", "maxDepth": 9 },
              "background": [1, 1, 1],
              "shapes": [ BALLS ] }
            """.Replace("BALLS", string.Join(',', new (double Radius, int Priority, double Extinction)[] { (3, 2, 0.1), (2, 3, 0.2), (1, 1, 5), (0.5, 2, 7) }.Select(Ball)), StringComparison.Ordinal);

        // The two in the middle are of no account; and as all indices are 1, nothing is reflected.
        Check(SceneRuns.RenderText(scene, s_seeds), 1, Math.Exp(-(2 * 0.1) - (4 * 0.2)));

        static string Ball((double Radius, int Priority, double Extinction) ball) => string.Create(
            System.Globalization.CultureInfo.InvariantCulture,
            $$"""{ "type": "sphere", "center": [0, 0, 0], "radius": {{ball.Radius}}, "material": { "type": "dielectric", "refractiveIndex": 1, "priority": {{ball.Priority}}, "extinction": [0, {{ball.Extinction}}, 0] } }""");
    }

    [Fact]
    public void A_dispersing_liquid_has_its_colours_against_the_glass_around()
    {
        // Of the same glass as the plate it cannot be seen, whatever the wavelength; so all that reflects is the plate's upper face.
        string boundaries = Plain(Overlapping).Replace("\"refractiveIndex\": 1.33", "\"glass\": \"sf11\"", StringComparison.Ordinal).Replace("\"refractiveIndex\": 1.5", "\"glass\": \"sf11\"", StringComparison.Ordinal)
            .Replace("[0.1, 0.2, 0.3]", "[0, 0, 0]", StringComparison.Ordinal).Replace("[0.5, 0.2, 0.1]", "[0, 0, 0]", StringComparison.Ordinal);
        string scene = $$"""
            { "camera": { "position": [0, 9, 5], "lookAt": [0, 3, 0], "fieldOfView": 1 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 256, "integrator": "path", "maxDepth": 12 },
              "background": [1, 1, 1],
              "shapes": [ { "type": "plane", "point": [0, 1, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0, 0, 0] } }, {{boundaries}} ] }
            """;
        string plate = scene.Replace("\"b\": [50, 2.5, 50]", "\"b\": [50, 1.5, 50]", StringComparison.Ordinal).Replace("\"a\": [-50, 2, -50]", "\"a\": [-50, 0, -50]", StringComparison.Ordinal);
        BlockTest test = BlockTest.Compare(SceneRuns.RenderText(scene, s_seeds), SceneRuns.RenderText(plate, s_seeds, firstSeed: 1001));
        ErrorBudget.Transport.Check(test.P, test.ToString());
    }

    private static void Check(ImageSamples images, int channel, double expected)
    {
        BlockEstimate all = images.Estimate(new(0, 0, images.Width, images.Height), channel);
        ErrorBudget.Transport.Check(BlockTest.Welch(all, new(expected, 0, 1)), FormattableString.Invariant($"channel {channel}: {all.Mean} ± {Math.Sqrt(all.Variance)}, expected {expected}"));
    }

    // Where light comes head-on: Born & Wolf 1999, section 1.5.3, eq. 36.
    private static double Reflectance(double index) => Math.Pow((index - 1) / (index + 1), 2);

    private static string Plain(string boundaries) =>
        boundaries.Replace("GLASS", "dielectric", StringComparison.Ordinal).Replace("WATER", "dielectric", StringComparison.Ordinal).Replace("INTERIOR", "", StringComparison.Ordinal);

    // Without priorities, absorption counts only where a ray ends at the boundary: so there is none where both are compared.
    private static string Colourless(string boundaries) =>
        boundaries.Replace(""", "extinction": [0.1, 0.2, 0.3]""", "", StringComparison.Ordinal).Replace(""", "extinction": [0.5, 0.2, 0.1]""", "", StringComparison.Ordinal);
}
