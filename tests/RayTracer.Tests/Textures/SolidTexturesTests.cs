using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Tests.Textures;

/// <summary>Textures that depend on more than uv, through scenes. Covers `Texture` and `GradientNoise`.</summary>
public class SolidTexturesTests
{
    private const string Noise = """{ "type": "noise", "scale": 2.3, "octaves": 2, "first": [0.1, 0.5, 0.9], "second": [0.9, 0.3, 0.2] }""";
    private const string Turn = """[{ "rotate": 40, "axis": [1, 2, 0.5], "translate": [3, -1, 2] }]""";
    private const string Stretch = """[{ "scale": [1, 1.5, 0.8] }, { "rotate": 40, "axis": [1, 2, 0.5], "translate": [3, -1, 2] }]""";

    public static TheoryData<string> Shapes => new(
        """{ "type": "sphere", "center": [0.1, 0.2, 0], "radius": 3 """,
        """{ "type": "box", "a": [-3, -3, -3], "b": [3, 3, 0.5] """,
        """{ "type": "mesh", "positions": [[-9, -9, 0], [9, -9, 0.3], [0, 9, 0]], "triangles": [[0, 1, 2]] """,
        """{ "type": "group", "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 2.5, "material": MATERIAL, "transform": [{ "translate": [0.3, 0, 0] }] }] """,
        """{ "type": "instance", "of": "ball" """);

    [Theory]
    [MemberData(nameof(Shapes))]
    public void A_texture_in_space_goes_with_the_shape(string shape)
    {
        // The camera is moved as the shape is, so that it sees the same.
        Film still = Render(shape, Noise, "[]", "[]");
        Film moved = Render(shape, Noise, Turn, Turn);
        double largest = 0;
        double contrast = 0;
        for (int y = 0; y < still.Height; y++)
        {
            for (int x = 0; x < still.Width; x++)
            {
                largest = Math.Max(largest, Math.Abs(still.Mean(x, y).R - moved.Mean(x, y).R));
                contrast = Math.Max(contrast, Math.Abs(still.Mean(x, y).R - still.Mean(0, 0).R));
            }
        }

        Assert.InRange(largest, 0, 1e-4);
        Assert.InRange(contrast, 0.1, 1);
    }

    [Theory]
    [MemberData(nameof(Shapes))]
    public void A_texture_of_the_world_does_not(string shape)
    {
        string noise = Noise.Replace("\"scale\"", "\"space\": \"world\", \"scale\"", StringComparison.Ordinal);
        Film still = Render(shape, noise, "[]", "[]");
        Film moved = Render(shape, noise, Turn, Turn);
        Assert.Contains(Enumerable.Range(0, still.Width), x => Math.Abs(still.Mean(x, 7).R - moved.Mean(x, 7).R) > 0.05);
    }

    [Fact]
    public void Its_own_transform_moves_the_texture_in_the_shape()
    {
        string placed = Noise.Replace("\"scale\"", $"\"transform\": {Stretch}, \"scale\"", StringComparison.Ordinal);
        const string sphere = """{ "type": "sphere", "center": [0, 0, 0], "radius": 900 """;
        Scene scene = TestScenes.Build(Text(sphere, placed, "[]", """[{ "translate": [0, 0, 899] }]"""));
        Film film = new RTracer(scene).Render().Film;

        // By hand: the point seen, taken back through the steps.
        SurfaceHit hit = new SurfaceProbe(scene).Describe(8.5f, 8.5f)!;
        Transform steps = Transform.Translation(new(3, -1, 2))
            * Transform.Rotation(new(1, 2, 0.5f), 40) * Transform.Scaling(new(1, 1.5f, 0.8f));
        System.Numerics.Vector3 inside = steps.Inverse().Point(hit.Position) * 2.3f;
        float amount = (GradientNoise.Sum((Vec3W)inside, 0, 2, 0.5f, isTurbulent: false)[0] * 0.5f) + 0.5f;
        Assert.Equal(0.1f + (0.8f * amount), film.Mean(8, 8).R, 5e-3f);
    }

    [Fact]
    public void Vertex_colours_are_shown_once_and_are_white_where_there_are_none()
    {
        const string colors = """, "colors": [[0.25, 0.5, 1], [0.25, 0.5, 1], [0.25, 0.5, 1]] """;
        const string mesh = """{ "type": "mesh", "positions": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]], "triangles": [[0, 1, 2]] """;
        const string texture = """{ "type": "vertexColor" }""";
        Assert.Equal(new(0.25f, 0.5f, 1), Render(mesh + colors, texture, "[]", "[]").Mean(8, 8));
        Assert.Equal(new(0.25f, 0.5f, 1), Render(mesh + colors, texture, Stretch, Turn).Mean(8, 8));
        Assert.Equal(new(0.125f, 0.25f, 0.5f), Render(mesh + colors, "[0.5, 0.5, 0.5]", "[]", "[]").Mean(8, 8));
        Assert.Equal(Rgb.White, Render(mesh, texture, "[]", "[]").Mean(8, 8));
        Assert.Equal(Rgb.White, Render("""{ "type": "sphere", "center": [0, 0, 0], "radius": 3 """, texture, "[]", "[]").Mean(8, 8));
    }

    private static Film Render(string shape, string texture, string place, string camera) => new RTracer(TestScenes.Build(Text(shape, texture, place, camera))).Render().Film;

    private static string Text(string shape, string texture, string place, string camera)
    {
        string material = $$"""{ "type": "diffuse", "color": {{texture}} }""";
        return $$"""
            {
              "camera": { "position": [0, 0, 8], "lookAt": [0, 0, 0], "fieldOfView": 20, "transform": {{camera}} },
              "render": { "width": 16, "height": 16, "samplesPerPixel": 1, "sampler": "regular", "integrator": "albedo" },
              "objects": { "ball": { "type": "sphere", "center": [0, 0, 0], "radius": 2.5, "material": {{material}} } },
              "shapes": [{{shape.Replace("MATERIAL", material, StringComparison.Ordinal)}}{{(shape.Contains("\"of\"", StringComparison.Ordinal) ? "" : $", \"material\": {material}")}}, "transform": {{place}} }]
            }
            """;
    }
}
