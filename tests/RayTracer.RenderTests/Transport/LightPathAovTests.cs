using System.Globalization;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.RenderTests.Transport;

/// <summary>The expectations of layers of light: what a picture shows that has nothing else.</summary>
[Trait("Category", "Thorough")]
public class LightPathAovTests
{
    private static readonly int s_seeds = TestSettings.Scale(8, 48);

    [Fact]
    public void The_layer_of_some_of_many_lights_is_the_picture_without_the_others()
    {
        string Scene(Func<int, bool> shines) => $$"""
            { "camera": { "position": [0, 1, 4], "lookAt": [0, 0.6, 0], "fieldOfView": 45 },
              "render": { "width": 16, "height": 12, "samplesPerPixel": 16, "integrator": "path", "maxDepth": 4 },
              "shapes": [
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.5, 0.4] } },
                { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5, "material": { "type": "roughPlastic" } }
                {{string.Concat(Enumerable.Range(0, 12).Where(shines).Select(i => $$""", { "type": "sphere", "name": "star {{i % 3}}", "center": [{{((i * 0.4) - 2).ToString(CultureInfo.InvariantCulture)}}, 1.6, {{(i % 2) - 1}}], "radius": 0.1, "material": { "type": "luminaire", "multiplier": 9 } }"""))}} ] }
            """;
        Check(Render(Scene(_ => true), "light.star_1", 1), Render(Scene(i => i % 3 == 1), null, 1001), "the layer of four of twelve lights");
    }

    [Theory]
    [InlineData("path")]
    [InlineData("report")]
    public void The_diffuse_layer_is_what_a_surface_without_gloss_shows(string integrator)
    {
        // Only light that the board scatters once: what other surfaces send it is black.
        string Scene(string specular) => $$"""
            { "camera": { "position": [0, 1, 3], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "render": { "width": 16, "height": 12, "samplesPerPixel": 16, "integrator": "{{integrator}}", "maxDepth": 2, "maxDiffuseDepth": 0 },
              "shapes": [
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "phong", "diffuse": [0.4, 0.3, 0.1], "specular": {{specular}}, "exponent": 20 } },
                { "type": "plane", "point": [0, 1.5, -1.5], "normal": [0, -1, 1], "size": [2, 1], "material": { "type": "luminaire", "multiplier": 3 } } ] }
            """;
        Check(Render(Scene("[0.5, 0.4, 0.6]"), "diffuse", 1), Render(Scene("[0, 0, 0]"), "diffuse", 1001), $"the diffuse layer by {integrator}");
    }

    private static void Check(ImageSamples layer, ImageSamples reference, string what)
    {
        BlockTest test = BlockTest.Compare(layer, reference);
        ErrorBudget.Transport.Check(test.P, $"{what}: {test}");
        Assert.True(reference.Mean().Pixels.Max() > 0.01f);
    }

    // Of a name, the layer; else the picture.
    private static ImageSamples Render(string json, string? name, int firstSeed)
    {
        ImageSamples images = new(16, 12);
        for (int seed = 0; seed < s_seeds; seed++)
        {
            long own = firstSeed + seed + (TestSettings.Seed * 1_000_000L);
            Scene scene = SceneLoader.Build(SceneReader.ReadText(json, "test.json"), ".", d => d with { Render = d.Render with { Seed = (uint)own } }).Scene!;
            Film film = new(16, 12);
            LightPathAovFilm layers = new(film, scene, Enum.GetValues<LightPathAov>());
            new RTracer(scene, new() { Layers = layers }).Render(film);
            images.Add(name is null ? film : layers.Image(layers.Names.ToList().IndexOf(name)));
        }

        return images;
    }
}
