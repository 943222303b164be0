namespace RayTracer.RenderTests.Transport;

/// <summary>
/// Lamps and backgrounds that the camera does not see.
/// Covers `PathShader`.
/// </summary>
[Trait("Category", "Thorough")]
public class HiddenLightTests
{
    private const string Lamp = """{ "type": "rectangle", "corner": [-1, 2, -1], "edgeU": [2, 0, 0], "edgeV": [0, 0, 2], "material": { "type": "luminaire", "multiplier": 2 } },""";
    private const string Fog = """{ "type": "box", "a": [-9, 1, -9], "b": [9, 3, 9], "material": { "type": "invisible", "interior": { "extinction": 0.3, "albedo": 0 } } },""";

    [Theory]
    [InlineData("path", "")]
    [InlineData("direct", "")]
    [InlineData("volPath", "")]
    [InlineData("path", """{ "type": "mesh", "positions": [[-9, -1, -9], [9, -1, -9], [0, -1, 9]], "triangles": [[0, 1, 2]] },""")]
    public void A_hidden_lamp_lights_what_is_seen_through_it(string integrator, string more)
    {
        // From above, the lamp's dark back is before what it lights; from the side, nothing is before that.
        double above = Seen("\"hideLights\": true", more + Lamp, integrator, "[0, 9, 0]");
        double beside = Seen("", more + Lamp, integrator, "[8, 1, 0]");
        Assert.InRange(above / beside, 0.995, 1.005);
        Assert.Equal(0, Seen("", more + Lamp, integrator, "[0, 9, 0]"));
    }

    [Theory]
    [InlineData("path")]
    [InlineData("direct")]
    [InlineData("volPath")]
    public void A_hidden_lamp_that_shines_at_the_camera_adds_nothing(string integrator)
    {
        const string lit = """{ "type": "point", "position": [0, 0.5, 0], "intensity": 1 },""";
        const string upwards = """{ "type": "rectangle", "corner": [-1, 2, 1], "edgeU": [2, 0, 0], "edgeV": [0, 0, -2], "material": { "type": "luminaire", "multiplier": 2 } },""";
        Assert.Equal(2, Seen("", lit + upwards, integrator, "[0, 9, 0]"), 1e-3);
        Assert.InRange(Seen("\"hideLights\": true", lit + upwards, integrator, "[0, 9, 0]") / Seen("", lit, integrator, "[0, 9, 0]"), 0.995, 1.005);
    }

    [Fact]
    public void Fog_around_a_hidden_lamp_is_as_thick_as_without_it()
    {
        const string lit = """{ "type": "point", "position": [0, 0.5, 0], "intensity": 1 },""";
        const string small = """{ "type": "sphere", "center": [0, 2, 0], "radius": 0.4, "material": { "type": "luminaire", "color": 1e-9 } },""";
        double fog = Math.Exp(-0.6);
        Assert.InRange(Seen("\"hideLights\": true", lit + Fog + small, "volPath", "[0, 9, 0]") / Seen("", lit, "volPath", "[0, 9, 0]"), 0.995 * fog, 1.005 * fog);
    }

    [Fact]
    public void Mirrors_show_what_is_hidden_from_the_camera()
    {
        const string mirror = """{ "type": "disk", "center": [0, 0.5, 0], "normal": [0, 1, 0], "radius": 2, "material": { "type": "conductor" } },""";
        Assert.Equal(2, Seen("\"hideLights\": true", mirror + Lamp, "path", "[0, 9, 0]"), 1e-3);
    }

    [Theory]
    [InlineData("true", 0)]
    [InlineData("false", 0.7)]
    public void A_hidden_background_is_black(string isHidden, double expected)
    {
        string scene = $$"""
            { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0] }, "background": 0.7,
              "render": { "width": 4, "height": 4, "samplesPerPixel": 16, "hideLights": {{isHidden}} }, "shapes": [] }
            """;
        Assert.Equal(expected, SceneRuns.RenderText(scene, 1).Estimate(new(0, 0, 4, 4), 0).Mean, 1e-6);
    }

    // A floor below a lamp that shines down, its middle seen from a place.
    private static double Seen(string setting, string things, string integrator, string from)
    {
        string scene = $$"""
            { "camera": { "position": {{from}}, "lookAt": [0, 0, 0], "up": [0, 0, 1], "fieldOfView": 0.1 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 4096, "integrator": "{{integrator}}" {{(setting.Length > 0 ? ", " + setting : "")}} },
              "shapes": [ {{things}} { "type": "rectangle", "corner": [-5, 0, 5], "edgeU": [10, 0, 0], "edgeV": [0, 0, -10], "material": { "type": "diffuse", "color": 0.5 } } ] }
            """;
        return SceneRuns.RenderText(scene, 1).Estimate(new(0, 0, 4, 4), 0).Mean;
    }
}
