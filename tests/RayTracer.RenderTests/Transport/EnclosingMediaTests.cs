using System.Globalization;

namespace RayTracer.RenderTests.Transport;

/// <summary>Cameras inside of media, and media inside of all that lets light in, against Beer's law.</summary>
public class EnclosingMediaTests
{
    [Theory]
    [InlineData("a ball", """{ "type": "sphere", "center": [0, 0.5, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }""", "0, 0, 0", 2.5)]
    [InlineData("a ball beside it", """{ "type": "sphere", "center": [5, 0, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }""", "0, 0, 0", 0)]
    [InlineData("a half space", """{ "type": "plane", "point": [0, 3, 0], "normal": [0, 1, 0], "material": { "type": "invisible", "interior": FOG } }""", "0, 0, 0", 3)]
    [InlineData("above a half space", """{ "type": "plane", "point": [0, -3, 0], "normal": [0, 1, 0], "material": { "type": "invisible", "interior": FOG } }""", "0, 0, 0", 0)]
    [InlineData("between two balls", """{ "type": "sphere", "center": [0, 0, 0], "radius": 3, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "invisible", "interior": { "extinction": [1e-9, 0, 0] } } }""", "0, 2, 0", 1)]
    [InlineData("in the inner ball", """{ "type": "sphere", "center": [0, 0, 0], "radius": 3, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "invisible", "interior": { "extinction": [1e-9, 0, 0] } } }""", "0, 0, 0", 2)]
    [InlineData("a box that is shown by an instance", """{ "type": "instance", "of": { "type": "box", "a": [-1, -1, -1], "b": [1, 1, 1], "material": { "type": "invisible", "interior": FOG } }, "transform": [{ "scale": [3, 3, 3], "translate": [0, 1, 0] }] }""", "0, 0, 0", 4)]
    [InlineData("a ring, in its hole", """{ "type": "torus", "center": [0, 0, 0], "axis": [0, 1, 0], "radius": 2, "tubeRadius": 0.5, "material": { "type": "invisible", "interior": FOG } }""", "0, 0, 0", 0)]
    [InlineData("a ring, in its tube", """{ "type": "torus", "center": [0, 0, 0], "axis": [0, 1, 0], "radius": 2, "tubeRadius": 0.5, "material": { "type": "invisible", "interior": FOG } }""", "2, 0, 0", 0.5)]
    [InlineData("two balls of one fog that overlap", """{ "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, 1, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }""", "0, 0.5, 0", 2.5)]
    [InlineData("three of them, in all", """{ "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, 1, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, -1, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }""", "0, 0.5, 0", 2.5)]
    [InlineData("three of them, in the last", """{ "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, 1, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, -1, 0], "radius": 2, "material": { "type": "invisible", "interior": FOG } }""", "0, -2.5, 0", 5.5)]
    [InlineData("two glasses of one priority", """{ "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": GLASS }, { "type": "sphere", "center": [0, 1, 0], "radius": 2, "material": GLASS }""", "0, 0.5, 0", 2.5)]
    [InlineData("two glasses and fog around", """{ "type": "sphere", "center": [0, 0, 0], "radius": 5, "material": { "type": "invisible", "interior": FOG } }, { "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": GLASS }, { "type": "sphere", "center": [0, 1, 0], "radius": 2, "material": GLASS }""", "0, 0.5, 0", 4.5)]
    public void What_the_camera_stands_in_is_found(string what, string shapes, string position, double way)
    {
        double[] left = Means(Up(
            shapes.Replace("FOG", """{ "extinction": [0.1, 0.2, 0.4] }""", StringComparison.Ordinal)
                .Replace("GLASS", """{ "type": "dielectric", "refractiveIndex": 1, "priority": 1, "extinction": [0.1, 0.2, 0.4] }""", StringComparison.Ordinal),
            position));
        double[] extinction = [0.1, 0.2, 0.4];
        for (int channel = 0; channel < 3; channel++)
        {
            double expected = Math.Exp(-extinction[channel] * way);
            Assert.True(Math.Abs(left[channel] - expected) < 1e-5, FormattableString.Invariant($"{what}, channel {channel}: {left[channel]}, expected {expected}"));
        }
    }

    [Fact]
    public void A_camera_that_moves_stands_where_it_is_when_the_shutter_opens()
    {
        const string fog = """{ "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": { "type": "invisible", "interior": { "extinction": [1, 1, 1] } } }""";
        string scene = Up(fog, "20, 0, 0").Replace("\"fieldOfView\"", "\"transform\": [{ \"translate\": [-20, 0, 0] }], \"fieldOfView\"", StringComparison.Ordinal);
        Assert.Equal(Math.Exp(-2), Means(scene)[0], 1e-5);
    }

    [Fact]
    public void From_within_water_the_sky_is_brighter_by_the_square_of_the_index()
    {
        // Head-on, with a priority: what is reflected finds the black bottom. Born & Wolf 1999, section 1.5.3, eq. 36.
        const string water = """
            { "type": "box", "a": [-9, -2, -9], "b": [9, 1, 9], "material": { "type": "dielectric", "refractiveIndex": 1.33, "priority": 1, "extinction": [0.5, 0, 0] } },
            { "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0, 0, 0] } }
            """;
        double[] seen = Means(Up(water, "0, 0, 0").Replace("volPath", "path", StringComparison.Ordinal).Replace("\"samplesPerPixel\": 4", "\"samplesPerPixel\": 4096", StringComparison.Ordinal));
        double expected = 1.33 * 1.33 * (1 - Math.Pow(0.33 / 2.33, 2));
        Assert.Equal(expected, seen[1], 2e-3);
        Assert.Equal(expected * Math.Exp(-0.5), seen[0], 2e-3);
    }

    [Theory]
    [InlineData("""{ "type": "thinDielectric", "refractiveIndex": 1, "interior": FOG }""")]
    [InlineData("""{ "type": "mask", "opacity": 0, "material": { "type": "diffuse" }, "interior": FOG }""")]
    [InlineData("""{ "type": "mask", "opacity": 0, "material": { "type": "invisible", "interior": FOG } }""")]
    [InlineData("""{ "type": "mask", "opacity": 0, "material": { "type": "invisible", "interior": FOG }, "interior": { "extinction": [9, 9, 9] } }""")]
    [InlineData("""{ "type": "dielectric", "refractiveIndex": 1, "interior": FOG }""")]
    [InlineData("""{ "type": "mix", "first": { "type": "dielectric", "refractiveIndex": 1, "interior": FOG }, "second": { "type": "thinDielectric", "refractiveIndex": 1 } }""")]
    public void Whatever_lets_light_straight_in_shows_what_is_inside(string material)
    {
        string ball = $$"""{ "type": "sphere", "center": [0, 5, 0], "radius": 1, "material": {{material.Replace("FOG", """{ "extinction": [0.1, 0.2, 0.4] }""", StringComparison.Ordinal)}} }""";
        double[] left = Means(Up(ball, "0, 0, 0"));
        Assert.Equal(Math.Exp(-0.2), left[0], 1e-5);
        Assert.Equal(Math.Exp(-0.8), left[2], 1e-5);
    }

    [Theory]
    [InlineData("""{ "type": "roughDielectric", "alpha": 0.3 INTERIOR }""")]
    [InlineData("""{ "type": "principled", "transmission": 1, "baseColor": [1, 1, 1], "roughness": 0.5 INTERIOR }""")]
    [InlineData("""{ "type": "translucent", "color": [0, 0, 0], "transmittance": [1, 1, 1] INTERIOR }""")]
    public void What_absorbs_inside_darkens_whatever_lets_light_in(string material)
    {
        // What the way through the ball takes is between that of the shortest ways and that of the longest.
        double[] clear = Means(Up(Ball(""), "0, 0, 0"));
        double[] tinted = Means(Up(Ball(""", "interior": { "extinction": [0, 0.2, 100] }"""), "0, 0, 0"));
        Assert.Equal(clear[0], tinted[0], 1e-6);
        Assert.InRange(tinted[1] / clear[1], 0.3, 0.95);
        Assert.InRange(tinted[2] / clear[2], 0, 0.6);

        string Ball(string interior) => $$"""{ "type": "sphere", "center": [0, 5, 0], "radius": 1, "material": {{material.Replace("INTERIOR", interior, StringComparison.Ordinal)}} }""";
    }

    [Theory]
    [InlineData(255)]
    [InlineData(256)]
    public void As_many_insides_as_have_numbers_are_distinguished(int count)
    {
        // The camera stands in the last one.
        string balls = string.Join(",\n", Enumerable.Range(1, count).Select(i => string.Create(
            CultureInfo.InvariantCulture,
            $$"""{ "type": "sphere", "center": [{{10 * (count - i)}}, 0, 0], "radius": 2, "material": { "type": "invisible", "interior": { "extinction": [0.1, 0.2, {{i * 0.01}}] } } }""")));
        if (count <= 255)
        {
            Assert.Equal(Math.Exp(-2 * count * 0.01), Means(Up(balls, "0, 0, 0"))[2], 1e-5);
            return;
        }

        string message = Assert.Throws<InvalidOperationException>(() => Means(Up(balls, "0, 0, 0"))).Message;
        Assert.Contains("256 different insides", message, StringComparison.Ordinal);
        Assert.Contains("at most 255 are possible", message, StringComparison.Ordinal);
    }

    private static string Up(string shapes, string position) => string.Create(CultureInfo.InvariantCulture, $$"""
        { "camera": { "position": [{{position}}], "lookAt": [{{position.Split(',')[0]}}, 1000, 0], "up": [0, 0, 1], "fieldOfView": 0.001 },
          "render": { "width": 4, "height": 4, "samplesPerPixel": 4, "integrator": "volPath", "maxDepth": 30 },
          "background": [1, 1, 1],
          "shapes": [ {{shapes}} ] }
        """);

    private static double[] Means(string scene)
    {
        ImageSamples images = SceneRuns.RenderText(scene, 1);
        return [.. Enumerable.Range(0, 3).Select(c => images.Estimate(new(0, 0, images.Width, images.Height), c).Mean)];
    }
}
