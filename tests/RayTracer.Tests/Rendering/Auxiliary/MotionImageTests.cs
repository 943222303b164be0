using RayTracer.Rendering;
using RayTracer.Testing;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `MotionImage`.</summary>
public sealed class MotionImageTests
{
    // 32 rows of 40 degrees at the distance 5.
    private static readonly double s_pixelsPerUnit = 16 / (5 * Math.Tan(20 * Math.PI / 180));
    private const string Moves = """, "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [0.5, 0.25, 0] }] }]""";

    [Theory]
    [InlineData("plane", 0, 1)]
    [InlineData("mesh", 0, 1)]
    [InlineData("mesh", 0.25, 0.75)]
    public void A_board_that_moves_goes_so_many_pixels(string shape, double opens, double closes)
    {
        Scene scene = Build(Board(shape, Moves), $"[{opens}, {closes}]");
        (double x, double y) = At(scene, 24, 16);
        Assert.Equal(0.5 * (closes - opens) * s_pixelsPerUnit, x, 1e-3);
        Assert.Equal(-0.25 * (closes - opens) * s_pixelsPerUnit, y, 1e-3);
    }

    [Fact]
    public void Where_the_camera_moves_what_is_nearer_goes_farther_the_other_way()
    {
        string near = """{ "type": "rectangle", "corner": [-9, -9, 2.5], "edgeU": [9, 0, 0], "edgeV": [0, 18, 0] }""";
        Scene scene = Build($"{Board("plane", null)}, {near}", "[0, 1]", Moves);
        Assert.Equal(-0.5 * s_pixelsPerUnit, At(scene, 30, 16).X, 1e-3);
        Assert.Equal(-0.5 * 2 * s_pixelsPerUnit, At(scene, 2, 16).X, 1e-3);
        Assert.Equal(0.25 * s_pixelsPerUnit, At(scene, 30, 16).Y, 1e-3);
    }

    // Both ends are seen through the same point of the lens: out of focus, the mean of its points is the way of the middle.
    [Fact]
    public void A_lens_leaves_the_mean_as_it_is()
    {
        Scene scene = Build(Board("plane", Moves), "[0, 1]", ""","lens": { "apertureRadius": 0.3, "focusDistance": 3 }""");
        Assert.Equal(0.5 * s_pixelsPerUnit, At(scene, 24, 16).X, 0.02);
    }

    [Fact]
    public void What_stands_still_or_is_nothing_has_none()
    {
        Scene scene = Build(Board("plane", null).Replace("9", "1", StringComparison.Ordinal), "[0, 1]");
        Assert.Equal((0, 0), At(scene, 24, 16));
        Assert.Equal((0, 0), At(scene, 0, 0));
    }

    [Fact]
    public void Without_time_or_a_place_in_the_picture_there_is_none_and_the_reason()
    {
        Assert.Contains("shutter", new MotionImage().Complaint(Build(Board("plane", Moves), "[0.5, 0.5]")), StringComparison.Ordinal);
        Assert.Null(new MotionImage().Complaint(Build(Board("plane", Moves), "[0, 1]")));
    }

    private static (double X, double Y) At(Scene scene, int x, int y)
    {
        MotionImage motion = new();
        AovFilm film = new(new(scene.Render.Width, scene.Render.Height), [motion]);
        new FirstHitPass(scene, new() { Threads = 1 }).Render(film);
        double[] row = new double[2 * film.Width];
        film.ReadRow(motion, y, row);
        return (row[2 * x], row[(2 * x) + 1]);
    }

    private static string Board(string shape, string? motion) => shape == "mesh"
        ? $$"""{ "type": "mesh", "positions": [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]{{motion}} }"""
        : $$"""{ "type": "rectangle", "corner": [-9, -9, 0], "edgeU": [18, 0, 0], "edgeV": [0, 18, 0]{{motion}} }""";

    private static Scene Build(string things, string shutter, string? camera = null) => TestScenes.Build($$"""
        { "render": { "width": 48, "height": 32, "samplesPerPixel": 64, "shutter": {{shutter}} },
          "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 40{{camera}} }, "background": [1, 1, 1],
          "shapes": [ {{things}} ] }
        """);
}
