using System.Globalization;
using System.Text.RegularExpressions;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.RenderTests.Stress;

/// <summary>Things of all kinds that touch a floor, far from the origin, and very large or small. Covers `SceneAssembler` and `InstanceMaps`.</summary>
public class FarScenesTests
{
    private const string Things = """
        { "type": "rectangle", "corner": <-5, 0, 5>, "edgeU": [10s, 0, 0], "edgeV": [0, 0, -10s] },
        { "type": "sphere", "center": <-1.6, 0.7, 0>, "radius": 0.7s },
        { "type": "box", "a": <-0.5, 0, -0.3>, "b": <0.3, 1, 0.5> },
        { "type": "mesh", "positions": [<0.6, 0, 0.6>, <1.8, 0, 0.6>, <1.2, 0, 1.6>, <1.2, 1.2, 0.9>],
          "triangles": [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]] },
        { "type": "torus", "center": <2.4, 0.18, -0.6>, "axis": [0, 1, 0], "radius": 0.5s, "tubeRadius": 0.18s },
        { "type": "cylinder", "bottom": <-2.9, 0, -1>, "top": <-2.9, 1.4, -1>, "radius": 0.4s },
        { "type": "cone", "bottom": <0.9, 0, -1.5>, "top": <0.9, 1.6, -1.5>, "radius": 0.5s },
        { "type": "disk", "center": <-1.5, 4.5, 2.5>, "normal": [0.3, -1, -0.4], "radius": 0.5s,
          "material": { "type": "luminaire", "multiplier": 20 } }
        """;

    [Theory]
    [InlineData(1e6, 0, 0)]
    [InlineData(1e-6, 0, 0)]
    [InlineData(1e12, 0, 0.001)]
    [InlineData(1e-12, 0, 0.005)]
    [InlineData(1, 1e3, 0.002)]
    [InlineData(1, 1e4, 0.01)]
    public void A_scene_looks_alike_at_every_scale_and_place_that_is_not_warned_of(double scale, double offset, double tolerance)
    {
        Scene scene = Load(Write(Things, scale, offset, scale, offset), out Diagnostic[] diagnostics);
        Assert.Empty(diagnostics);
        Assert.InRange(Difference(scene), 0, tolerance + 0.0005);
    }

    [Theory]
    [InlineData(1e5)]
    [InlineData(1e6)]
    public void Things_that_lie_where_numbers_are_coarse_for_them_are_warned_of(double offset)
    {
        Load(Write(Things, 1, offset, 1, offset), out Diagnostic[] diagnostics);
        Diagnostic warning = Assert.Single(diagnostics);
        Assert.Equal(Severity.Warning, warning.Severity);
        Assert.Contains("where single-precision numbers are", warning.Message, StringComparison.Ordinal);
        Assert.Contains(" wide and lies at 1e+0", warning.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1e4)]
    [InlineData(1e5)]
    public void Things_of_an_instance_touch_one_another_wherever_it_stands(double offset)
    {
        string place = offset.ToString("r", CultureInfo.InvariantCulture);
        string moved = $$"""
            { "type": "instance", "transform": [{ "translate": [{{place}}, {{place}}, {{place}}] }], "of": { "type": "group", "shapes": [{{Points(Things, 1, 0)}}] } }
            """;
        Scene scene = Load(Write(moved, 1, 0, 1, offset), out Diagnostic[] diagnostics);
        Assert.Empty(diagnostics);
        Assert.InRange(Difference(scene), 0, offset * 2.3e-8);
    }

    [Fact]
    public void Things_of_another_size_touch_one_another_in_an_instance_that_is_made_large()
    {
        const string Made = """{ "type": "instance", "transform": [{ "scale": 1e6 }], "of": { "type": "group", "shapes": [SHAPES] } }""";
        Scene scene = Load(Write(Made.Replace("SHAPES", Points(Things, 1, 0), StringComparison.Ordinal), 1, 0, 1e6, 0), out _);
        Assert.InRange(Difference(scene), 0, 0.0005);
    }

    private static Scene Load(string json, out Diagnostic[] diagnostics)
    {
        SceneLoadResult result = SceneLoader.Build(SceneReader.ReadText(json, "far.json"), ".");
        diagnostics = [.. result.Diagnostics];
        return result.Scene ?? throw new InvalidOperationException(Diagnostic.Format(result.Diagnostics));
    }

    private static double Difference(Scene scene)
    {
        float[] expected = Pixels(Load(Write(Things, 1, 0, 1, 0), out _));
        float[] actual = Pixels(scene);
        return expected.Zip(actual, (e, a) => Math.Abs(e - a)).Sum() / expected.Sum();
    }

    private static float[] Pixels(Scene scene)
    {
        Film film = new RTracer(scene).Render().Film;
        float[] pixels = new float[3 * film.Width * film.Height];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(y, pixels.AsSpan(3 * film.Width * y, 3 * film.Width));
        }

        return pixels;
    }

    // Numbers with an s, and points between angles, at their scale and place; the camera at another, if it is to be.
    private static string Write(string shapes, double scale, double offset, double cameraScale, double cameraOffset) => $$"""
        {
          "camera": { "position": {{Points("<0, 2.2, 6.5>", cameraScale, cameraOffset)}}, "lookAt": {{Points("<0, 0.7, 0>", cameraScale, cameraOffset)}}, "fieldOfView": 36 },
          "render": { "width": 32, "height": 24, "samplesPerPixel": 64, "integrator": "path", "maxDepth": 6 },
          "background": [0.25, 0.3, 0.4],
          "shapes": [{{Points(shapes, scale, offset)}}]
        }
        """;

    private static string Points(string text, double scale, double offset)
    {
        string Number(double value) => value.ToString("r", CultureInfo.InvariantCulture);
        string points = Regex.Replace(text, "<([^>]*)>", m =>
            $"[{string.Join(", ", m.Groups[1].Value.Split(',').Select(c => Number((double.Parse(c, CultureInfo.InvariantCulture) * scale) + offset)))}]");
        return Regex.Replace(points, "([0-9.]+|-[0-9.]+)s", m =>
            Number(double.Parse(m.Groups[1].Value, CultureInfo.InvariantCulture) * scale));
    }
}
