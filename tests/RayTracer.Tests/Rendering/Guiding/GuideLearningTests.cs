using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `GuideLearning`, `GuideRecorder` and `GuidedMaterial`.</summary>
public sealed class GuideLearningTests
{
    private static readonly Scene s_plain = TestScenes.Build(GuidedScenes.Screen);
    private static readonly Scene s_guided = GuidedScenes.Learned(s_plain);
    private static readonly string s_hash = new RTracer(s_guided).Render().Film.ComputeHash();

    [Theory]
    [InlineData(1, 1000)]
    [InlineData(2, 64)]
    [InlineData(5, 333)]
    public void What_is_learned_does_not_depend_on_how_it_is_computed(int threads, int stream) =>
        Assert.Equal(s_guided.Guide!.Hash, GuidedScenes.Learned(s_plain, new() { Threads = threads, StreamSize = stream, Crop = new(3, 2, 5, 5) }).Guide!.Hash);

    [Theory]
    [InlineData(1, 64)]
    [InlineData(2, 8)]
    [InlineData(5, 13)]
    public void Guided_pictures_have_the_same_bits_however_they_are_computed(int threads, int tile)
    {
        Assert.Equal(s_hash, new RTracer(s_guided, new() { Threads = threads, TileSize = tile, StreamSize = 100 }).Render().Film.ComputeHash());
        Assert.NotEqual(s_hash, new RTracer(s_plain).Render().Film.ComputeHash());
    }

    [Fact]
    public void Parts_of_guides_learned_apart_add_up_to_the_whole_which_has_no_other_samples()
    {
        Film sum = new(24, 16);
        foreach (SampleRange range in new SampleRange[] { new(5, 16), new(0, 2), new(2, 5) })
        {
            new RTracer(GuidedScenes.Learned(s_plain), new() { Samples = range }).Render(sum);
        }

        Assert.Equal(s_hash, sum.ComputeHash());
        Assert.Equal(24 * 16 * 16, sum.TotalSamples);
    }

    [Fact]
    public void More_samples_need_no_other_guide()
    {
        Scene longer = TestScenes.Build(GuidedScenes.Screen.Replace("\"samplesPerPixel\": 16", "\"samplesPerPixel\": 1024", StringComparison.Ordinal));
        Scene other = TestScenes.Build(GuidedScenes.Screen.Replace("\"samplesPerPixel\": 16", "\"seed\": 5", StringComparison.Ordinal));
        Assert.Equal(s_guided.Guide!.Hash, GuidedScenes.Learned(longer).Guide!.Hash);
        Assert.NotEqual(s_guided.Guide.Hash, GuidedScenes.Learned(other).Guide!.Hash);
    }

    [Fact]
    public void Guided_pictures_have_less_noise()
    {
        (double guided, double plain) = (MedianVariance(s_guided), MedianVariance(s_plain));
        Assert.True(guided < 0.75 * plain, $"{guided} against {plain}");
    }

    [Fact]
    public void Weights_of_recorded_paths_still_multiply_to_what_they_carry()
    {
        int guided = 0;
        foreach (TracedPath path in new PathTracing(s_guided).Trace(3, 2, new(0, 16)))
        {
            Assert.Equal(path.Vertices[^1].After, path.Radiance);
            for (int i = 0; i + 1 < Math.Min(path.Vertices.Count, 4); i++)
            {
                (PathVertex at, PathVertex next) = (path.Vertices[i], path.Vertices[i + 1]);
                Assert.Equal(at.Throughput.R * at.Weight.R, next.Throughput.R);
                Assert.Equal(at.Throughput.G * at.Weight.G, next.Throughput.G);
                guided += at.Pdf > 0 ? 1 : 0;
            }
        }

        Assert.True(guided > 16);
    }

    [Fact]
    public void A_scene_without_light_is_guided_nowhere()
    {
        Scene dark = TestScenes.Build(GuidedScenes.Screen.Replace("\"multiplier\": 40", "\"multiplier\": 0", StringComparison.Ordinal));
        Assert.Equal(0, new RTracer(GuidedScenes.Learned(dark)).Render().Film.Mean(12, 8).R);
    }

    [Theory]
    [InlineData("point", true)]
    [InlineData("lamp", false)]
    public void Light_that_is_asked_for_at_a_point_is_not_learned_there(string light, bool isAllAskedFor)
    {
        // No light comes by way of another surface, and directions do not meet a light without extent.
        string lamp = light == "point"
            ? """{ "type": "point", "position": [0, 1, 0], "intensity": [1, 1, 1] }"""
            : """{ "type": "sphere", "center": [0, 1, 0], "radius": 0.3, "material": { "type": "luminaire" } }""";
        PathGuide guide = GuidedScenes.Learned(TestScenes.Build($$"""
            {
              "camera": { "position": [0, 1, 3], "lookAt": [0, 0, 0], "fieldOfView": 30 },
              "render": { "integrator": "path", "width": 16, "height": 16 },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse" } } ],
              "lights": [ {{lamp}} ]
            }
            """)).Guide!;
        Assert.Equal(isAllAskedFor, guide.Nodes.Length == PathGuide.NodeWords);
    }

    private static double MedianVariance(Scene scene)
    {
        Film film = new RTracer(scene).Render().Film;
        return Enumerable.Range(0, 24 * 16).Select(i => (double)film.SampleVariance(i % 24, i / 24)).Order().ElementAt(24 * 16 / 2);
    }
}
