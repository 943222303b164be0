namespace RayTracer.RenderTests.Transport;

/// <summary>
/// Light of lamps that are meshes, on a large triangle of a mesh, whose rays start far from it: as on a plane.
/// Covers `DirectLight` and `MeshLight`.
/// </summary>
public class ShadowRayTests
{
    private const string Plane = """ "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1] """;
    private const string Mesh =
        """
           "type": "mesh", "positions": [[-10, -10, 0], [10, -10, 0], [10, 10, 0], [-10, 10, 0]], "triangles": [[0, 1, 2], [0, 2, 3]],
           "shading": "smooth"
        """;

    private const string Diffuse = """{ "type": "diffuse", "color": [0.8, 0.8, 0.8] }""";
    private const string Translucent = """{ "type": "translucent", "color": [0.2, 0.2, 0.2], "transmittance": [0.7, 0.7, 0.7] }""";
    private const string Frosted = """{ "type": "roughDielectric", "alpha": 0.5 }""";

    [Theory]
    [InlineData("direct", "literal", Diffuse, 1)]
    [InlineData("path", "literal", Diffuse, 1)]
    [InlineData("path", "literal", Translucent, 1)]
    [InlineData("path", "literal", Translucent, -1)]
    [InlineData("path", "mended", Translucent, 1)]
    [InlineData("path", "mended", Translucent, -1)]
    [InlineData("path", "mended", Frosted, 1)]
    [InlineData("path", "mended", Frosted, -1)]
    [InlineData("volPath", "literal", Diffuse, 1)]
    [InlineData("volPath", "mended", Translucent, -1)]
    public void A_large_triangle_gets_as_much_light_of_a_mesh_as_a_plane(string integrator, string normals, string material, int side)
    {
        double expected = Mean(Plane, integrator, normals, material, side);
        double found = Mean(Mesh, integrator, normals, material, side);
        Assert.True(
            Math.Abs((found / expected) - 1) < 0.02,
            $"{integrator}, {normals} normals, {material}, seen from z = {side}: {found:G5} in place of {expected:G5}");
    }

    // The middle of a wall, seen from one side, with the lamp on the positive one and a wisp of fog far away.
    private static double Mean(string wall, string integrator, string normals, string material, int side)
    {
        ImageSamples images = SceneRuns.RenderText(
            $$"""
            {
              "camera": { "position": [5, 0.3, {{4 * side}}], "lookAt": [0.5, 0.3, 0], "fieldOfView": 1 },
              "render": {
                "width": 8, "height": 8, "samplesPerPixel": 256, "integrator": "{{integrator}}", "maxDepth": 2, "shadingNormals": "{{normals}}"
              },
              "shapes": [
                { {{wall}}, "material": {{material}} },
                { "type": "sphere", "center": [0, 50, 0], "radius": 1, "material": { "type": "invisible", "interior": { "extinction": [1, 1, 1] } } },
                {
                  "type": "mesh", "positions": [[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]], "triangles": [[0, 2, 1], [0, 3, 2]],
                  "material": { "type": "luminaire", "multiplier": 30 }
                }
              ]
            }
            """,
            1);
        return images.Estimate(new(0, 0, images.Width, images.Height), 1).Mean;
    }
}
