using System.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Tests.Rendering;

/// <summary>Meshes that are shaded with other normals than their triangles have.</summary>
public class ShadingNormalTests
{
    [Theory]
    [InlineData(4)]
    [InlineData(-4)]
    public void The_normal_is_that_of_the_corners_mixed_on_the_rays_side(int height)
    {
        Scene scene = Load("[0.3, 1, 0.2], [0.3, 1, 0.2], [-0.1, 1, 0.2], [-0.1, 1, 0.2]", height, """{ "type": "diffuse" }""", "[0, 100, 0]");
        AovFilm film = new(new(16, 16), [Aov.Normal, Aov.Uv]);
        new FirstHitPass(scene).Render(film);
        double[] normals = new double[16 * 3];
        double[] uv = new double[16 * 2];
        for (int y = 0; y < 16; y++)
        {
            film.ReadRow(Aov.Normal, y, normals);
            film.ReadRow(Aov.Uv, y, uv);
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

    private static double Brightness(Scene scene)
    {
        Film film = new RTracer(scene).Render().Film;
        return Enumerable.Range(0, 256).Sum(i => (double)film.Mean(i % 16, i / 16).Luminance);
    }

    // A square around the origin with normals at its corners, seen from above or below, and a lamp.
    private static Scene Load(string normals, int height, string material, string lamp)
    {
        SceneLoadResult result = SceneLoader.Build(
            SceneReader.ReadText(
                $$"""
                {
                  "camera": { "position": [0, {{height}}, 0], "lookAt": [0, 0, 0], "up": [0, 0, 1], "fieldOfView": 12 },
                  "render": { "width": 16, "height": 16, "samplesPerPixel": 16, "maxDiffuseDepth": 3, "maxSpecularDepth": 3 },
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
