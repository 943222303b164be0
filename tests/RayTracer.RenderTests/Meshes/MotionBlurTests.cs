using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.RenderTests.Meshes;

/// <summary>The blur of what moves, against what it must be. Covers `Motion`, `MotionSegment` and `RayGenerator`.</summary>
[Trait("Category", "Thorough")]
public class MotionBlurTests
{
    private const int Width = 64;
    private const int Height = 4;

    // A shining half plane far away, whose edge goes from x = −½ to x = ½ of the picture while the shutter is open, at constant speed. So
    // the radiance of a column is the share of the time that the edge is to the right of it: a straight ramp, with constant ends.
    [Theory]
    [InlineData("sobol")]
    [InlineData("jittered")]
    [InlineData("independent")]
    public void An_edge_at_constant_speed_is_a_ramp(string sampler)
    {
        string mesh = """
            { "type": "mesh", "positions": [[-64, -8, 0], [0, -8, 0], [0, 8, 0], [-64, 8, 0]], "triangles": [[0, 1, 2], [0, 2, 3]], "material": { "type": "luminaire" },
              "motion": [{ "time": 1, "transform": [{ "translate": [-0.5, 0, 0] }] }, { "time": 3, "transform": [{ "translate": [0.5, 0, 0] }] }] }
            """;
        AssertRamp(sampler, mesh, "", "an edge");
    }

    [Fact]
    public void An_edge_before_a_moving_camera_is_a_ramp()
    {
        string mesh = """
            { "type": "plane", "point": [-64, 0, 0], "normal": [0, 0, 1], "size": [128, 16], "material": { "type": "luminaire" } }
            """;
        string motion = """, "motion": [{ "time": 1, "transform": [{ "translate": [0.5, 0, 0] }] }, { "time": 3, "transform": [{ "translate": [-0.5, 0, 0] }] }]""";
        AssertRamp("sobol", mesh, motion, "a camera");
    }

    [Fact]
    public void A_shining_thing_that_moves_lights_like_the_mean_of_all_its_places()
    {
        // Where it shines at 8 times, each an eighth as bright, sampled midway: the light on the floor is smooth in time.
        string floor = """{ "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": { "type": "diffuse", "color": [0.8, 0.8, 0.8] } }""";
        string moving = Lamp(1, """, "motion": [{ "time": 0, "transform": [{ "translate": [-1, 0, 0] }] }, { "time": 1, "transform": [{ "translate": [1, 0, 0] }] }]""");
        string places = string.Join(", ", Enumerable.Range(0, 32).Select(i => Lamp(1f / 32, $$""", "transform": [{ "translate": [{{(i + 0.5) / 16 - 1:R}}, 0, 0] }]""")));
        BlockTest test = BlockTest.Compare(Run(moving, 1), Run(places, 1001));
        ErrorBudget.Geometry.Check(test.P, $"a lamp that moves: {test}");

        ImageSamples Run(string lamps, long seed) => SceneRuns.RenderText($$"""
            {
              "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "render": { "integrator": "report", "width": 24, "height": 16, "samplesPerPixel": 16, "maxDiffuseDepth": 0, "shutter": [0, 1] },
              "shapes": [{{floor}}, {{lamps}}]
            }
            """, TestSettings.Scale(24, 128), firstSeed: seed);

        // It shines towards the floor, and its back, which the camera sees, is black; so are all of it where they hide the floor: lamps far above do not.
        string Lamp(float multiplier, string place) => $$"""
            { "type": "mesh", "positions": [[-0.3, -0.3, 5], [0.3, -0.3, 5], [0.3, 0.3, 5], [-0.3, 0.3, 5]], "triangles": [[0, 2, 1], [0, 3, 2]],
              "material": { "type": "luminaire", "multiplier": {{50 * multiplier:R}} }{{place}} }
            """;
    }

    private static void AssertRamp(string sampler, string shape, string camera, string what)
    {
        int samples = TestSettings.Scale(256, 4096);
        string json = $$"""
            {
              "camera": { "position": [0, 0, 1000], "lookAt": [0, 0, 0], "fieldOfView": {{2 * Math.Atan(2 / 1000.0 * Height / Width) * 180 / Math.PI:R}}{{camera}} },
              "render": { "integrator": "report", "width": {{Width}}, "height": {{Height}}, "samplesPerPixel": {{samples}}, "sampler": "{{sampler}}", "seed": {{TestSettings.Seed}}, "shutter": [1, 3] },
              "shapes": [{{shape}}]
            }
            """;
        SceneLoadResult result = SceneLoader.Build(SceneReader.ReadText(json, "test.json"), ".");
        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        Film film = new RTracer(result.Scene!).Render().Film;
        double smallest = 1;
        for (int x = 0; x < Width; x++)
        {
            // The picture shows x from −2 to 2.
            double expected = (Share(x) + Share(x + 1)) / 2;
            double hits = Enumerable.Range(0, Height).Sum(y => (double)film.Mean(x, y).R) * samples;
            smallest = Math.Min(smallest, PValues.Binomial((int)Math.Round(hits), samples * Height, expected));
        }

        ErrorBudget.Analytic.Check(Math.Min(1, smallest * Width), $"{what} at constant speed with {sampler}");
        double Share(int column) => Math.Clamp(0.5 - ((column * 4.0 / Width) - 2), 0, 1);
    }
}
