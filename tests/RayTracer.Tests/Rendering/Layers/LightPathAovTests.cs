using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Layers of light: that they add up to the picture, and that each has what its name says.</summary>
public sealed class LightPathAovTests
{
    // Every kind of source, and surfaces and media of every kind.
    private const string Everything = """
        {
          "camera": { "position": [0, 1.2, 5], "lookAt": [0, 0.8, 0], "fieldOfView": 50 },
          "render": { "width": 24, "height": 16, "samplesPerPixel": 16, "integrator": "INTEGRATOR", "filter": { "shape": "FILTER" } },
          "ENVIRONMENT": LIGHT,
          "ambient": [0.05, 0.04, 0.03],
          "objects": { "bulb": { "type": "sphere", "center": [0, 0, 0], "radius": 0.1, "material": { "type": "luminaire", "multiplier": 5 } } },
          "materials": { "neon": { "type": "luminaire", "multiplier": 3, "exponent": 1 } },
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "principled", "baseColor": [0.6, 0.5, 0.4] } },
            { "type": "sphere", "center": [-1.2, 0.6, 0], "radius": 0.6, "material": { "type": "dielectric", "interior": { "extinction": [1, 1, 1], "albedo": [0.9, 0.8, 0.7] } } },
            { "type": "sphere", "center": [0.2, 0.6, -0.6], "radius": 0.6, "material": { "type": "phong", "diffuse": [0.4, 0.3, 0.2], "specular": [0.5, 0.5, 0.5] } },
            { "type": "sphere", "center": [1.4, 0.5, 0.4], "radius": 0.5, "material": { "type": "mask", "opacity": 0.6, "material": { "type": "translucent" } } },
            { "type": "sphere", "center": [-0.4, 1.6, 1], "radius": 0.4, "material": { "type": "invisible", "interior": { "extinction": [2, 2, 3], "albedo": [0.9, 0.8, 0.7] } } },
            { "type": "plane", "point": [0, 1, 2], "normal": [0, 0, 1], "size": [1.5, 1.5], "material": { "type": "thinDielectric" } },
            { "type": "mesh", "name": "tube", "positions": [[-1, 2, -1], [1, 2, -1], [0, 2, 0]], "triangles": [[0, 1, 2]], "material": "neon" },
            { "type": "mesh", "lightGroup": "strip", "positions": [[-2, 2, -1], [-1.5, 2, -1], [-1.5, 2, 0]], "triangles": [[0, 1, 2]], "material": "neon" },
            { "type": "group", "name": "chandelier", "shapes": [
              { "type": "instance", "of": "bulb", "lightGroup": "left bulb", "transform": [{ "translate": [-0.5, 2, 0.5] }] },
              { "type": "instance", "of": "bulb", "transform": [{ "translate": [0.5, 2, 0.5] }] } ] },
            { "type": "point", "name": "key", "position": [2, 3, 2], "intensity": [4, 4, 5] },
            { "type": "directional", "name": "fill", "direction": [1, -1, -1], "irradiance": [0.2, 0.3, 0.2] }
            MORE
          ],
          "lights": [
            { "type": "sphere", "center": [1, 3, 2], "radius": 0.3, "material": { "type": "luminaire", "multiplier": FACTOR, "material": { "type": "phongMetal", "exponent": 20 } } }
          ]
        }
        """;

    private static readonly LightPathAov[] s_all = Enum.GetValues<LightPathAov>();
    private static readonly string[] s_lights =
        ["light.unnamed", "light.tube", "light.strip", "light.left_bulb", "light.chandelier", "light.key", "light.fill", "light.background"];

    [Theory]
    [InlineData("report")]
    [InlineData("path")]
    [InlineData("direct")]
    [InlineData("volPath")]
    public void Layers_add_up_to_the_picture_to_the_last_unit_and_change_nothing_of_it(string integrator)
    {
        Scene scene = Of(integrator);
        (Film film, LightPathAovFilm layers) = Render(scene);
        AssertAddUp(film, layers);
        Assert.Equal(new RTracer(scene).Render().Film.ComputeHash(), film.ComputeHash());
        string[] lights = integrator == "report" ? [.. s_lights, "light.ambient"] : s_lights;
        Assert.Equal([.. s_all[..^1].Select(l => l.ToString().ToLowerInvariant()), .. lights], layers.Names);
        string[] black = integrator is "path" or "volPath" ? [] : ["volume"];
        Assert.Equal([.. black, .. integrator == "direct" ? ["indirect"] : Array.Empty<string>()], layers.Names.Where((_, i) => Total(film, layers, i) == 0).Order().Reverse());
    }

    [Theory]
    [InlineData("report")]
    [InlineData("path")]
    [InlineData("volPath")]
    public void Of_many_lights_layers_add_up_too(string integrator)
    {
        string more = string.Concat(Enumerable.Range(0, 20).Select(i => $$"""
            , { "type": "sphere", "name": "star {{i % 4}}", "center": [{{i - 10}}, 2.5, -1], "radius": 0.05, "material": { "type": "luminaire", "multiplier": 9 } }
            """));
        (Film film, LightPathAovFilm layers) = Render(Of(integrator, more: more, environment: "environment", light: """{ "type": "constant", "radiance": [0.3, 0.2, 0.4] }"""));
        AssertAddUp(film, layers);
        Assert.Equal(["light.star_0", "light.star_1", "light.star_2", "light.star_3", "light.environment"], layers.Names.Where(n => n.Contains("star", StringComparison.Ordinal) || n == "light.environment"));
    }

    [Fact]
    public void Layers_are_the_same_however_they_are_computed()
    {
        Scene scene = Of("path");
        (Film film, LightPathAovFilm layers) = Render(scene);
        foreach (RenderOptions options in new RenderOptions[] { new() { Threads = 3, TileSize = 5, StreamSize = 7 }, new() { Threads = 1, TileSize = 64, StreamSize = 5000 } })
        {
            (Film _, LightPathAovFilm other) = Render(scene, options: options);
            Assert.All(Enumerable.Range(0, layers.Names.Count), i => Assert.Equal(layers.Content(i), other.Content(i)));
        }

        // Ranges of samples, as a denoiser renders them; and layers that are asked for alone.
        LightPathAovFilm parts = new(film, scene, [LightPathAov.Lights, LightPathAov.Specular]);
        foreach (SampleRange range in new SampleRange[] { new(0, 5), new(5, 16) })
        {
            new RTracer(scene, new() { Samples = range, Layers = parts }).Render(new Film(24, 16));
        }

        Assert.Equal(["specular", .. s_lights], parts.Names);
        Assert.All(parts.Names, (name, i) => Assert.Equal(layers.Content(layers.Names.ToList().IndexOf(name)), parts.Content(i)));
    }

    [Theory]
    [InlineData("report")]
    [InlineData("path")]
    [InlineData("volPath")]
    public void A_lamp_twice_as_bright_is_its_layer_twice(string integrator)
    {
        (Film film, LightPathAovFilm before) = Render(Of(integrator, filter: "box"));
        (Film brighter, LightPathAovFilm after) = Render(Of(integrator, factor: 40, filter: "box"));
        int lamp = before.Names.ToList().IndexOf("light.unnamed");
        ForEachChannel(film, (x, y, channel) =>
        {
            // Each sample is rounded where layers are balanced: to floats as large as it, beside the units of the film.
            double slack = 16 + ((double)brighter.Sum(x, y, channel) * 1e-6);
            for (int i = LightPathAovFilm.FirstLight; i < before.Names.Count; i++)
            {
                Int128 expected = before.Sum(i, x, y, channel) * (i == lamp ? 2 : 1);
                Assert.InRange((double)(after.Sum(i, x, y, channel) - expected), -slack, slack);
            }

            Int128 balanced = film.Sum(x, y, channel) + before.Sum(lamp, x, y, channel);
            Assert.InRange((double)(brighter.Sum(x, y, channel) - balanced), -slack, slack);
        });
    }

    [Theory]
    [InlineData("\"type\": \"diffuse\"", "point", "direct", "diffuse")]
    [InlineData("\"type\": \"translucent\"", "point", "direct indirect", "diffuse")]
    [InlineData("\"type\": \"roughConductor\"", "point", "direct", "specular")]
    [InlineData("\"type\": \"conductor\"", "background", "direct", "specular")]
    [InlineData("\"type\": \"diffuse\"", "background", "direct", "diffuse")]
    [InlineData("\"type\": \"invisible\", \"interior\": { \"extinction\": [9, 9, 9], \"albedo\": [0.5, 0.5, 0.5] }", "point", "direct indirect", "volume")]
    [InlineData("\"type\": \"mask\", \"opacity\": \"black\", \"material\": { \"type\": \"diffuse\" }", "background", "emission", "emission")]
    [InlineData("\"type\": \"thinDielectric\", \"specularReflectance\": \"black\"", "background", "emission", "emission")]
    [InlineData("\"type\": \"luminaire\"", "point", "emission", "emission")]
    public void Light_of_a_single_kind_is_in_its_layers_alone(string material, string source, string byOrder, string byLobe)
    {
        string light = source == "point" ? """, { "type": "point", "name": "key", "position": [0, 2, 5], "intensity": [5, 5, 5] }""" : "";
        Scene scene = TestScenes.Build($$"""
            {
              "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 20 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 64, "integrator": "volPath" },
              "background": {{(source == "point" ? "\"black\"" : "\"white\"")}},
              "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1.5, "material": { {{material}} } } {{light}} ]
            }
            """);
        (Film film, LightPathAovFilm layers) = Render(scene);
        Assert.NotEqual(0, film.Sum(4, 4, 1));
        string[] expected = [.. byOrder.Split(' '), byLobe];
        Assert.Equal(expected.Distinct().Order(), layers.Names.Where((name, i) => !name.StartsWith("light.", StringComparison.Ordinal) && Total(film, layers, i) != 0).Order());
    }

    [Fact]
    public void Light_by_two_mirrors_is_indirect_and_specular()
    {
        Scene scene = TestScenes.Build("""
            {
              "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 1 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 4, "integrator": "path" },
              "background": "white",
              "shapes": [
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 1], "size": [2, 2], "material": { "type": "conductor" } },
                { "type": "plane", "point": [0, 3, 0], "normal": [0, -1, 1], "size": [2, 2], "material": { "type": "conductor" } } ]
            }
            """);
        (Film film, LightPathAovFilm layers) = Render(scene);
        Assert.Equal(["indirect", "specular", "light.background"], layers.Names.Where((_, i) => Total(film, layers, i) != 0));
        Assert.Equal(1, film.Mean(2, 2).G, 1e-6);
    }

    [Fact]
    public void Too_many_names_and_integrators_without_light_are_refused()
    {
        string more = string.Concat(Enumerable.Range(0, 80).Select(i => $$"""
            , { "type": "point", "name": "lamp{{i}}", "position": [0, 2, 0] }
            """));
        Scene scene = Of("path", more: more);
        Film film = new(24, 16);
        Assert.Contains("88 names", Assert.Throws<ArgumentException>(() => new LightPathAovFilm(film, scene, s_all)).Message, StringComparison.Ordinal);
        Assert.Equal(2, new LightPathAovFilm(film, scene, [LightPathAov.Direct, LightPathAov.Diffuse]).Names.Count);
        Assert.Throws<ArgumentException>(() => new LightPathAovFilm(film, Of("normals"), s_all));
    }

    private static Scene Of(string integrator, string more = "", string environment = "background", string light = "[0.3, 0.4, 0.5]", int factor = 20, string filter = "mitchell") => TestScenes.Build(Everything
        .Replace("INTEGRATOR", integrator, StringComparison.Ordinal)
        .Replace("FILTER", filter, StringComparison.Ordinal)
        .Replace("MORE", more, StringComparison.Ordinal)
        .Replace("ENVIRONMENT", environment, StringComparison.Ordinal)
        .Replace("LIGHT", light, StringComparison.Ordinal)
        .Replace("FACTOR", $"{factor}", StringComparison.Ordinal));

    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void Sums_of_passes_exceed_64_bits_and_the_latest_is_taken_back(int sign)
    {
        Film film = new(2, 2);
        LightPathAovFilm layers = new(film, Of("path"), [LightPathAov.Direct]);
        Tile tile = new(0, 1, 2, 1);
        const long most = 1L << 62;
        Int128 sum = 0;
        for (int pass = 0; pass < 9; pass++)
        {
            layers.Begin(tile);
            layers.Add((int)LightPathAov.Direct, 3, 2, sign * most);
            sum += sign * most;
            Assert.Equal(sum, layers.Sum(0, 1, 1, 2));
        }

        layers.TakeBack(tile);
        Assert.Equal(sum - (sign * most), layers.Sum(0, 1, 1, 2));
        Assert.Equal(0, layers.Sum(0, 0, 1, 2));
    }

    private static (Film Film, LightPathAovFilm Layers) Render(Scene scene, RenderOptions? options = null)
    {
        Film film = new(scene.Render.Width, scene.Render.Height);
        LightPathAovFilm layers = new(film, scene, s_all);
        new RTracer(scene, (options ?? new()) with { Layers = layers }).Render(film);
        return (film, layers);
    }

    private static void AssertAddUp(Film film, LightPathAovFilm layers)
    {
        Int128 all = 0;
        ForEachChannel(film, (x, y, channel) =>
        {
            Int128 Sum(int first, int last) => Enumerable.Range(first, last - first + 1).Aggregate((Int128)0, (sum, i) => sum + layers.Sum(i, x, y, channel));
            Int128 picture = film.Sum(x, y, channel);
            Int128 emission = Sum(0, 0);
            all += picture;
            Assert.Equal(picture, emission + Sum((int)LightPathAov.Direct, (int)LightPathAov.Indirect));
            Assert.Equal(picture, emission + Sum((int)LightPathAov.Diffuse, (int)LightPathAov.Volume));
            Assert.Equal(picture, Sum(LightPathAovFilm.FirstLight, layers.Names.Count - 1));
        });
        Assert.NotEqual(0, all);
    }

    private static double Total(Film film, LightPathAovFilm layers, int layer)
    {
        double total = 0;
        ForEachChannel(film, (x, y, channel) => total += double.Abs((double)layers.Sum(layer, x, y, channel)));
        return total;
    }

    private static void ForEachChannel(Film film, Action<int, int, int> action)
    {
        for (int i = 0; i < film.Width * film.Height * 3; i++)
        {
            action(i / 3 % film.Width, i / 3 / film.Width, i % 3);
        }
    }
}
