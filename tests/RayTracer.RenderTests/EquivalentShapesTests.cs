namespace RayTracer.RenderTests;

/// <summary>
/// Shapes that can be made of others: both ways look the same, whether they are seen, cast shadows, shine, or are of glass.
/// Covers `TurnedBox`, `BoxKernel`, `ConicalKernel` and `TorusKernel`.
/// </summary>
[Trait("Category", "Thorough")]
public class EquivalentShapesTests
{
    private const string Faces = """
        { "type": "plane", "point": [0.4, 0.5, 0], "normal": [1, 0, 0], "size": [0.6, 1], MATERIAL },
        { "type": "plane", "point": [-0.4, 0.5, 0], "normal": [-1, 0, 0], "size": [0.6, 1], MATERIAL },
        { "type": "plane", "point": [0, 1, 0], "normal": [0, 1, 0], "size": [0.8, 0.6], MATERIAL },
        { "type": "plane", "point": [0, 0, 0], "normal": [0, -1, 0], "size": [0.8, 0.6], MATERIAL },
        { "type": "plane", "point": [0, 0.5, 0.3], "normal": [0, 0, 1], "size": [0.8, 1], MATERIAL },
        { "type": "plane", "point": [0, 0.5, -0.3], "normal": [0, 0, -1], "size": [0.8, 1], MATERIAL },
        """;

    private const string Checker = """{ "type": "checker", "scale": [3, 2], "even": [0.9, 0.4, 0.1], "odd": [0.1, 0.3, 0.8] }""";
    private const string Matt = $$"""{ "type": "diffuse", "color": {{Checker}} }""";
    private const string Lamp = $$"""{ "type": "luminaire", "multiplier": 3, "color": {{Checker}} }""";
    private const string Glass = """{ "type": "dielectric", "extinction": [0.3, 0.6, 1] }""";
    private const string Turned = """{ "scale": [0.7, 1.2, -0.9] }, { "rotate": 33, "axis": [0.3, 1, 0.2], "translate": [0.1, 0.05, -0.1] }""";
    private static readonly int s_seeds = TestSettings.Scale(32, 128);

    [Theory]
    [InlineData("matt", Matt)]
    [InlineData("lamp", Lamp)]
    [InlineData("glass", Glass)]
    public void A_box_looks_like_its_six_faces(string name, string material) =>
        AssertSame($"{name} box", """{ "type": "box", "a": [0.4, 0, -0.3], "b": [-0.4, 1, 0.3], MATERIAL },""", Faces, material);

    [Theory]
    [InlineData("matt turned", Matt, Turned)]
    [InlineData("lamp turned", Lamp, Turned)]
    [InlineData("glass turned", Glass, Turned)]
    [InlineData("matt sheared", Matt, """{ "rotate": 33, "axis": [0.3, 1, 0.2] }, { "scale": [0.7, 1.2, -0.9] }""")]
    public void A_box_that_is_turned_looks_like_one_whose_rays_are(string name, string material, string steps)
    {
        const string box = """{ "type": "box", "a": [0.4, 0, -0.3], "b": [-0.4, 1, 0.3], MATERIAL""";
        AssertSame(
            $"{name} box",
            $$"""{{box}}, "transform": [{{steps}}] },""",
            $$"""{ "type": "instance", "of": {{box}} }, "transform": [{{steps}}] },""",
            material);
    }

    [Theory]
    [InlineData("matt", Matt)]
    [InlineData("lamp", Lamp)]
    public void A_capped_cylinder_looks_like_a_pipe_between_two_disks(string name, string material) => AssertSame(
        $"{name} cylinder",
        """{ "type": "cylinder", "bottom": [0, 0.1, 0], "top": [0, 1, 0], "radius": 0.4, MATERIAL },""",
        """
        { "type": "cylinder", "bottom": [0, 0.1, 0], "top": [0, 1, 0], "radius": 0.4, "caps": false, MATERIAL },
        { "type": "disk", "center": [0, 1, 0], "normal": [0, 1, 0], "radius": 0.4, MATERIAL },
        { "type": "disk", "center": [0, 0.1, 0], "normal": [0, -1, 0], "radius": 0.4, MATERIAL },
        """,
        material);

    [Theory]
    [InlineData("matt", Matt)]
    [InlineData("lamp", Lamp)]
    public void A_rectangle_by_its_edges_looks_like_one_by_its_centre(string name, string material) => AssertSame(
        $"{name} rectangle",
        """{ "type": "rectangle", "corner": [-0.5, 0.1, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0.8, -0.6], MATERIAL },""",
        """{ "type": "plane", "point": [0, 0.5, -0.3], "normal": [0, 0.6, 0.8], "size": [1, 1], MATERIAL },""",
        material);

    private static void AssertSame(string what, string one, string other, string material)
    {
        BlockTest test = BlockTest.Compare(Render(one, material, 1), Render(other, material, 1001));
        ErrorBudget.Geometry.Check(test.P, $"{what}: {test}");
    }

    private static ImageSamples Render(string shapes, string material, int firstSeed) => SceneRuns.RenderText($$"""
        { "camera": { "position": [0.9, 1.3, 2.6], "lookAt": [0, 0.4, 0], "fieldOfView": 36 },
          "render": { "integrator": "report", "width": 32, "height": 24, "samplesPerPixel": 16, "seed": {{firstSeed}} },
          "background": [0.2, 0.3, 0.5],
          "shapes": [
            {{shapes.Replace("MATERIAL", $"\"material\": {material}", StringComparison.Ordinal)}}
            { "type": "plane", "point": [0, -0.05, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.5, 0.4] } },
          ],
          "lights": [ { "type": "sphere", "center": [1.5, 2.5, 1], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 12 } } ] }
        """, s_seeds);
}
