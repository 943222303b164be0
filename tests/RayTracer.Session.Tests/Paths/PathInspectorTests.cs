using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class PathInspectorTests
{
    private const int Size = 60;
    private const int Samples = 16;

    public static TheoryData<string> Scenes => ["report/scene1.json", "report/scene2.json", "report/scene3.json", "shapes.json"];

    [Theory]
    [MemberData(nameof(Scenes))]
    public async Task Contributions_add_up_to_what_the_film_gets(string path)
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped(path, Size, Samples);
        await test.Done();
        foreach ((int x, int y) in Pixels())
        {
            InspectedPixel pixel = await test.Session.Part<PathInspector>().Inspect(x, y, 0, Samples);
            Assert.Equal(Samples, pixel.Samples.Count);
            Int128[] sums = new Int128[3];
            foreach (InspectedPath traced in pixel.Samples)
            {
                AssertAddsUp(traced);
                AssertIsSample(shown.Scene, x, y, traced);
                Add(sums, traced.Radiance);
            }

            // The film's units and its rounding, from the paths alone.
            Assert.Equal(pixel.Pixel, new Rgb(Mean(sums[0]), Mean(sums[1]), Mean(sums[2])));
        }
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public async Task Throughput_is_the_product_of_the_weights_before(string path)
    {
        using TestSession test = new();
        await test.OpenShipped(path, Size, Samples);
        foreach ((int x, int y) in Pixels())
        {
            foreach (InspectedPath traced in (await Inspect(test, x, y)).Samples)
            {
                Rgb throughput = Rgb.White;
                foreach (InspectedVertex vertex in traced.Vertices)
                {
                    Assert.Equal(throughput, vertex.Throughput);
                    throughput *= vertex.Weight;
                }
            }
        }
    }

    [Fact]
    public async Task Ways_lead_from_where_they_are_joined_back_to_lights()
    {
        using TestSession test = new();
        await test.OpenShipped("gallery/tea.json", 24, Samples);
        HashSet<string> events = [];
        foreach ((int x, int y) in new[] { (12, 16), (4, 18), (12, 12) })
        {
            InspectedPixel pixel = await test.Session.Part<PathInspector>().Inspect(x, y, 2, Samples);
            Assert.Equal((4, Samples), (pixel.Samples.Count, pixel.Total));
            foreach (InspectedPath traced in pixel.Samples)
            {
                AssertAddsUpNearly(traced);
                events.UnionWith(traced.Ways.Select(w => w.Event));
                Assert.All(traced.Ways.Where(w => w.Event is not "met"), w => Assert.Equal(w.Things.Count + 2, w.Points.Count));
                Assert.All(traced.Ways, w => Assert.All(w.Things, name => Assert.NotEqual("background", name)));
            }
        }

        Assert.All(new[] { "met", "asked", "connected", "merged" }, e => Assert.Contains(e, events));
    }

    [Fact]
    public async Task Events_tell_what_happened()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene2.json", Size, Samples);
        HashSet<string> events = [];
        foreach ((int x, int y) in Pixels())
        {
            foreach (InspectedPath traced in (await Inspect(test, x, y)).Samples)
            {
                Assert.Equal("camera", traced.Vertices[0].Event);
                Assert.All(traced.Vertices.Skip(1).SkipLast(1), v => Assert.Contains(v.Event, new[] { "diffuse", "specular" }));
                Assert.Contains(traced.Vertices[^1].Event, new[] { "emission", "absorbed", "end", "miss" });
                Assert.All(traced.Vertices.Where(v => v.Event == "diffuse"), v => Assert.True(v.Pdf > 0));
                Assert.All(traced.Vertices.Where(v => v.Event == "specular"), v => Assert.Null(v.Pdf));
                events.UnionWith(traced.Vertices.Select(v => v.Event));
            }
        }

        Assert.All(new[] { "camera", "diffuse", "specular", "end" }, e => Assert.Contains(e, events));
    }

    [Fact]
    public async Task Pixels_and_samples_that_there_are_not_are_refused()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene1.json", Size, Samples);
        foreach ((int x, int y, int first) in new[] { (-1, 0, 0), (Size, 0, 0), (0, Size, 0), (0, 0, Samples), (0, 0, -1) })
        {
            await Assert.ThrowsAsync<SessionException>(() => test.Session.Part<PathInspector>().Inspect(x, y, first, 1));
        }
    }

    [Fact]
    public async Task A_sentence_names_what_happened_and_sums_say_where_the_light_came_from()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene2.json", Size, Samples);
        List<string> sentences = [];
        foreach ((int x, int y) in Pixels())
        {
            InspectedPixel pixel = await Inspect(test, x, y);
            sentences.AddRange(pixel.Samples.Select(s => s.Sentence));
            PixelSummary sums = test.Session.Part<PathInspector>().Summarize(x, y);
            Assert.Equal(Samples, sums.Samples);
            Assert.Equal(pixel.Samples.Average(s => s.Radiance.Luminance), sums.Mean, 1e-6);
            foreach (IReadOnlyList<LightShare> shares in new[] { sums.Lights, sums.Things, sums.Depths, sums.Techniques })
            {
                Assert.Equal(sums.Mean > 0 ? 1 : 0, shares.Sum(s => s.Share), 1e-3);
            }
        }

        Assert.Contains(sentences, s => s.StartsWith("Light of *", StringComparison.Ordinal) && s.Contains("was reflected by *", StringComparison.Ordinal));
        Assert.Contains(sentences, s => s.Contains("came through *glass ball*", StringComparison.Ordinal));
        Assert.All(sentences, s => Assert.EndsWith(".", s));
    }

    [Theory]
    [InlineData("bidirectional")]
    [InlineData("vcm")]
    [InlineData("light")]
    [InlineData("photons")]
    public async Task Where_light_is_traced_too_sentences_and_sums_name_the_lights(string integrator)
    {
        using TestSession test = new();
        await test.Open(await Shipped("report/scene2.json", integrator));
        HashSet<string> lights = [];
        List<InspectedPath> paths = [];
        foreach ((int x, int y) in Pixels())
        {
            paths.AddRange((await Inspect(test, x, y)).Samples);
            lights.UnionWith(test.Session.Part<PathInspector>().Summarize(x, y).Lights.Select(l => l.Name));
        }

        string[] lamps = ["left front lamp", "right front lamp", "left back lamp", "right back lamp"];
        Assert.Empty(lights.Except([.. lamps, "background", "surroundings"]));
        Assert.True(lights.Intersect(lamps).Count() > 1);
        Assert.All(paths, p => Assert.StartsWith(p.Ways.Count > 0 ? "Light of " : "No light came: ", p.Sentence));
        Assert.Contains(paths, p => p.Sentence.Contains(" lamp* was reflected by *floor*", StringComparison.Ordinal));

        // The lens is connected with no place behind glass.
        Assert.True(integrator == "light" || paths.Exists(p => p.Sentence.Contains("came through *glass ball*", StringComparison.Ordinal)));

        // What is met has the weight with which it counts, and what nobody asked is not blocked.
        InspectedVertex[] vertices = [.. paths.SelectMany(p => p.Vertices)];
        Assert.All(vertices.Where(v => v.Emission is not null), v =>
            Assert.Equal(v.Parts.Emitted[1], v.Throughput.G * v.Emission!.Radiance.G * v.Emission.Weight, 1e-6 + (1e-3 * v.Parts.Emitted[1])));
        Assert.All(vertices.SelectMany(v => v.Lights).Where(l => l.Outcome == "blocked"), l => Assert.NotNull(l.Blocker));
        Assert.Equal(integrator is "light" or "photons", vertices.Any(v => v.End == "gathered"));
    }

    [Fact]
    public async Task Light_of_a_sky_is_found_by_chance_only_through_glass()
    {
        using TestSession test = new();
        await test.Open(await Shipped("animation/01-turn.json", "path"));
        List<string> sentences = [];
        foreach ((int x, int y) in Pixels())
        {
            sentences.AddRange((await Inspect(test, x, y)).Samples.Select(s => s.Sentence));
        }

        Assert.Contains(sentences, s => s == "Light of the surroundings was reflected by *plane*.");
        Assert.All(sentences.Where(s => s.Contains("by chance", StringComparison.Ordinal)), s => Assert.Contains("*glass ball*", s, StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_spot_says_what_is_outside_of_its_cone_and_leaves_are_shone_through()
    {
        using TestSession test = new();
        await test.Open("""
            {
              "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "render": { "width": 60, "height": 60, "samplesPerPixel": 1, "integrator": "path" },
              "shapes": [{ "type": "rectangle", "name": "leaf", "corner": [-4, -4, 0], "edgeU": [8, 0, 0], "edgeV": [0, 8, 0], "material": { "type": "translucent" } }],
              "lights": [{ "type": "spot", "position": [0, 0, -3], "direction": [0, 0, 1], "intensity": 50, "cutoffAngle": 15 }]
            }
            """);
        Assert.Equal("Light of *spot* came through *leaf*.", (await test.Session.Part<PathInspector>().Inspect(30, 30, 0, 1)).Samples[0].Sentence);
        InspectedPath outside = (await test.Session.Part<PathInspector>().Inspect(2, 2, 0, 1)).Samples[0];
        Assert.Equal("outsideCone", Assert.Single(outside.Vertices[1].Lights).Outcome);
    }

    private static async Task<string> Shipped(string path, string integrator)
    {
        string text = await File.ReadAllTextAsync(ProjectFolder.PathOf("scenes", path));
        JsonText scene = JsonText.Of(text);
        scene = scene.Root.Find("ambient") is null ? scene : scene.Remove("/ambient");

        // Most of all paths from the lights would be the background's.
        scene = integrator == "light" ? scene.Set("/background", "black") : scene;
        return scene.Set("/render/integrator", integrator).Set("/render/width", Size).Set("/render/height", Size).Set("/render/samplesPerPixel", Samples).Text;
    }

    private static async Task<InspectedPixel> Inspect(TestSession test, int x, int y)
    {
        await test.Until(() => test.Session.View.Loop.Status.Status != "idle" ? test : null);
        return await test.Session.Part<PathInspector>().Inspect(x, y, 0, Samples);
    }

    private static IEnumerable<(int X, int Y)> Pixels() =>
        from y in Enumerable.Range(0, 6)
        from x in Enumerable.Range(0, 6)
        select ((x * 10) + 5, (y * 10) + 5);

    private static void AssertAddsUp(InspectedPath path)
    {
        double[] sum = new double[3];
        foreach (InspectedVertex vertex in path.Vertices)
        {
            for (int c = 0; c < 3; c++)
            {
                sum[c] += vertex.Contribution[c];
                Assert.Equal(sum[c], (float)sum[c]);
                Assert.Equal(vertex.Contribution[c], vertex.Parts.Emitted[c] + vertex.Parts.Ambient[c] + vertex.Parts.Direct[c], 1e-12);
            }
        }

        Assert.Equal(path.Radiance, new Rgb((float)sum[0], (float)sum[1], (float)sum[2]));
    }

    private static void AssertAddsUpNearly(InspectedPath path)
    {
        double sum = path.Vertices.Sum(v => v.Contribution[1]);
        Assert.Equal(path.Radiance.G, sum, 1e-9 + (1e-5 * sum));
        Assert.InRange(path.Ways.Sum(w => (double)w.Radiance.G), 0.5 * sum, (sum * (1 + 1e-5)) + 1e-9);
    }

    private static void AssertIsSample(Scene scene, int x, int y, InspectedPath path)
    {
        Film film = new(Size, Size);
        new RTracer(scene, new() { Threads = 1, Crop = new(x, y, 1, 1), Samples = new(path.Sample, path.Sample + 1) }).Render(film);
        Int128[] sums = new Int128[3];
        Add(sums, path.Radiance);
        Assert.Equal(film.Mean(x, y), new Rgb(Unit(sums[0]), Unit(sums[1]), Unit(sums[2])));
    }

    private static void Add(Int128[] sums, Rgb radiance)
    {
        sums[0] += (Int128)double.Round(radiance.R * 4294967296.0);
        sums[1] += (Int128)double.Round(radiance.G * 4294967296.0);
        sums[2] += (Int128)double.Round(radiance.B * 4294967296.0);
    }

    private static float Unit(Int128 sum) => (float)((double)sum / 4294967296.0);

    private static float Mean(Int128 sum) => (float)((double)sum * (1 / (4294967296.0 * Samples)));
}
