using System.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Tests.Rendering;

/// <summary>
/// Meshes that are shaded with other normals than their triangles have.
/// Covers `SurfaceShader` and `MeshTable`.
/// </summary>
public class ShadingNormalTests
{
    [Theory]
    [InlineData(4)]
    [InlineData(-4)]
    public void The_normal_is_that_of_the_corners_mixed_on_the_rays_side(int height)
    {
        Scene scene = Load("[0.3, 1, 0.2], [0.3, 1, 0.2], [-0.1, 1, 0.2], [-0.1, 1, 0.2]", height, """{ "type": "diffuse" }""", "[0, 100, 0]");
        AovFilm film = new(new(16, 16), [new NormalImage(), new UvImage()]);
        new FirstHitPass(scene).Render(film);
        double[] normals = new double[16 * 3];
        double[] uv = new double[16 * 2];
        for (int y = 0; y < 16; y++)
        {
            film.ReadRow(new NormalImage(), y, normals);
            film.ReadRow(new UvImage(), y, uv);
            for (int x = 0; x < 16; x++)
            {
                // Corners of u = 1 have the second normal; both are unit vectors before they are mixed.
                var left = Vector3.Normalize(new(0.3f, 1, 0.2f));
                var right = Vector3.Normalize(new(-0.1f, 1, 0.2f));
                Vector3 expected = Vector3.Normalize(Vector3.Lerp(left, right, (float)uv[2 * x])) * Math.Sign(height);
                Assert.Equal(expected.X, normals[3 * x], 1e-4);
                Assert.Equal(expected.Y, normals[(3 * x) + 1], 1e-4);
                Assert.Equal(expected.Z, normals[(3 * x) + 2], 1e-4);
            }
        }
    }

    [Theory]
    [InlineData("phongMetal")]
    [InlineData("diffuse")]
    public void What_leans_lets_no_light_through_the_surface(string material)
    {
        // Straight down, mirrored by the leaning normal, goes on below the surface, to where the only lamp is.
        const string leaning = "[0.9, 0.3, 0], [0.9, 0.3, 0], [0.9, 0.3, 0], [0.9, 0.3, 0]";
        const string upright = "[0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 1, 0]";
        string made = $$"""{ "type": "{{material}}", "color": "white" }""";
        Assert.Equal(0, Brightness(Load(leaning, 4, made, "[12, -16, 0]")));
        Assert.True(Brightness(Load(upright, 4, made, "[0, 16, 0]")) > 0);
    }

    [Theory]
    [InlineData(4, true)]
    [InlineData(-4, false)]
    public void What_shines_is_decided_by_the_surface_itself_even_where_normals_are_taken_literally(int height, bool isSeen)
    {
        // The normals lean over to the other side, from where the surface then seems to be seen; its light still leaves it above.
        const string over = "[0.9, -0.3, 0], [0.9, -0.3, 0], [0.9, -0.3, 0], [0.9, -0.3, 0]";
        const string upright = "[0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 1, 0]";
        const string lamp = """{ "type": "luminaire", "multiplier": 3 }""";
        const string render = """ "integrator": "path", "maxDepth": 1, "shadingNormals": "literal" """;
        double seen = Brightness(Load(over, height, lamp, "[0, 100, 0]", render));
        Assert.Equal(isSeen, seen > 0);
        Assert.Equal(Brightness(Load(upright, height, lamp, "[0, 100, 0]", render)), seen);
    }

    [Theory]
    [InlineData("""{ "type": "dielectric", "refractiveIndex": 1.5 }""")]
    [InlineData("""{ "type": "conductor", "eta": [0.2, 0.9, 1.5], "k": [3, 2.5, 2] }""")]
    [InlineData("""{ "type": "roughDielectric", "refractiveIndex": 1.5, "alpha": 0.2 }""")]
    public void A_normal_that_is_flipped_into_view_looks_as_one_that_was_drawn_so(string material)
    {
        // The map leans away from the camera, which sees it at a shallow angle; the other one leans as far towards it.
        double flipped = Plate("[0.9, 0.5, 0.8]");
        Assert.Equal(Plate("[0.1, 0.5, 0.8]"), flipped, flipped * 1e-3);

        double Plate(string map) => Brightness(TestScenes.Build(
            $$"""
            {
              "camera": { "position": [-5, 0.7, 0], "lookAt": [0, 0, 0], "fieldOfView": 4 },
              "render": { "width": 16, "height": 16, "samplesPerPixel": 16, "integrator": "path", "maxDepth": 3 },
              "shapes": [
                { "type": "rectangle", "corner": [-2, 0, 1], "edgeU": [4, 0, 0], "edgeV": [0, 0, -2],
                  "material": { "type": "normalMap", "turned": "flip", "map": { "type": "solid", "color": {{map}} }, "material": {{material}} } },
                { "type": "plane", "point": [0, 9, 0], "normal": [0, -1, 0], "size": [30, 30], "material": { "type": "luminaire" } },
                { "type": "plane", "point": [0, -9, 0], "normal": [0, 1, 0], "size": [30, 30], "material": { "type": "luminaire", "multiplier": 0.3 } }
              ]
            }
            """));
    }

    [Theory]
    [InlineData("MAP", true)]
    [InlineData("""{ "type": "twoSided", "front": MAP, "back": MAP }""", true)]
    [InlineData("""{ "type": "luminaire", "multiplier": 0.1, "material": MAP }""", true)]
    [InlineData("""{ "type": "mask", "opacity": 0.8, "material": MAP }""", true)]
    [InlineData("""{ "type": "normalMap", "turned": "back", "map": { "type": "solid", "color": [1, 0.5, 0.6] }, "material": { "type": "phongMetal" } }""", false)]
    public void Normals_that_are_mirrored_into_view_leave_nothing_to_take_literally(string material, bool isSame)
    {
        // What metal that leans aside reflects goes on below the surface: taken literally, that is where the floor is.
        string made = material.Replace("MAP", """{ "type": "normalMap", "map": COLOR, "material": { "type": "phongMetal" } }""", StringComparison.Ordinal)
            .Replace("COLOR", """{ "type": "solid", "color": [0.5, 1, 0.6] }""", StringComparison.Ordinal);
        string[] hashes = [.. new[] { "literal", "mended" }.Select(n => new RTracer(TestScenes.Build(
            $$"""
            {
              "camera": { "position": [-3, 1, 0], "lookAt": [0, 0, 0], "fieldOfView": 12 },
              "render": { "width": 16, "height": 16, "samplesPerPixel": 4, "integrator": "path", "maxDepth": 3, "shadingNormals": "{{n}}" },
              "background": [0.5, 0.5, 0.5],
              "shapes": [
                { "type": "rectangle", "corner": [-1, 0, 1], "edgeU": [2, 0, 0], "edgeV": [0, 0, -2], "material": {{made}} },
                { "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0] }
              ]
            }
            """)).Render().Film.ComputeHash())];
        Assert.Equal(isSame, hashes[0] == hashes[1]);
    }

    private static double Brightness(Scene scene)
    {
        Film film = new RTracer(scene).Render().Film;
        return Enumerable.Range(0, 256).Sum(i => (double)film.Mean(i % 16, i / 16).Luminance);
    }

    // A square around the origin with normals at its corners, seen from above or below, and a lamp.
    private static Scene Load(string normals, int height, string material, string lamp, string render = """ "integrator": "report", "maxDiffuseDepth": 3, "maxSpecularDepth": 3 """)
    {
        SceneLoadResult result = SceneLoader.Build(
            SceneReader.ReadText(
                $$"""
                {
                  "camera": { "position": [0, {{height}}, 0], "lookAt": [0, 0, 0], "up": [0, 0, 1], "fieldOfView": 12 },
                  "render": { "width": 16, "height": 16, "samplesPerPixel": 16, {{render}} },
                  "shapes": [
                    { "type": "mesh", "positions": [[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]], "normals": [{{normals}}],
                      "uv": [[0, 0], [0, 1], [1, 1], [1, 0]], "triangles": [[0, 1, 2], [0, 2, 3]], "material": {{material}} },
                    { "type": "sphere", "center": {{lamp}}, "radius": 6, "material": { "type": "luminaire", "multiplier": 5 } }
                  ]
                }
                """,
                "test.json"),
            ".");
        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        return result.Scene!;
    }
}
