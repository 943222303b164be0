using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// What each way to make paths brings: with weights, together, the picture; alone, the same light by all ways (Veach 1997, figure 10.4).
/// Covers `StrategyFilm`, `StrategyRecorder` and `PathStrategy`.
/// </summary>
[Trait("Category", "Thorough")]
public class StrategyFilmTests
{
    // A room in which all ways find all light: matt, and the lamp is large.
    private const string Room = """
        { "camera": { "position": [0, 1, 2.4], "lookAt": [0, 0.9, 0], "fieldOfView": 50 },
          "render": { "width": 16, "height": 16, "samplesPerPixel": 8, "maxDepth": 5, "rouletteDepth": 9 },
          "shapes": [
            { "type": "box", "a": [-1.5, 0, -1.5], "b": [1.5, 2.5, 2.5], "material": { "type": "diffuse", "color": [0.7, 0.6, 0.5] } },
            { "type": "rectangle", "corner": [-0.9, 2.3, -0.9], "edgeU": [1.8, 0, 0], "edgeV": [0, 0, 1.8], "material": { "type": "luminaire", "multiplier": 2 } } ] }
        """;

    private static readonly int s_seeds = TestSettings.Scale(16, 64);

    [Theory]
    [InlineData("light", "two edges, from a camera that moves")]
    [InlineData("bidirectional", "a room with a ball of glass")]
    [InlineData("bidirectional", "an even sky and negative lobes of the filter")]
    [InlineData("bidirectional", "many lights")]
    [InlineData("photons", "prisms")]
    [InlineData("vcm", "prisms")]
    [InlineData("vcm", "sky and sun above a plane without end")]
    [InlineData("vcm", "a mesh that shines, moves, and is stretched")]
    public void With_their_weights_all_ways_add_up_to_the_picture(string integrator, string name)
    {
        Scene scene = Build(LightPathScene.All.Single(s => s.Name == name).Text, integrator, seed: 3);
        (Film film, StrategyFilm ways) = Render(scene, new() { Threads = 3 });
        AssertAddUp(film, ways);
        Assert.True(ways.Strategies.Count(s => Mean(ways.Image(s, isWeighted: true)) > 0) > ways.Strategies.Count / 3);
    }

    [Fact]
    public void Layers_have_the_same_bits_whatever_the_threads_and_the_streams()
    {
        Scene scene = Build(LightPathScene.All[0].Text, "vcm", seed: 5);
        (Film film, StrategyFilm ways) = Render(scene, new() { Threads = 1 });
        (Film other, StrategyFilm others) = Render(scene, new() { Threads = 3, StreamSize = 77, TileSize = 8 });
        Assert.Equal(film.ComputeHash(), other.ComputeHash());
        Assert.Equal(ways.Layers.Select(l => Pixels(l.Image)), others.Layers.Select(l => Pixels(l.Image)));
        Assert.Equal(film.ComputeHash(), new RTracer(scene).Render().Film.ComputeHash());
    }

    [Fact]
    public void Ctrl_c_leaves_whole_passes()
    {
        using CancellationTokenSource source = new();
        Scene scene = Build(Room, "bidirectional", seed: 2);
        (Film film, StrategyFilm ways, RenderStatistics statistics) = Render(scene, new() { AfterPass = _ => Cancel(source) }, source.Token);
        Assert.True(statistics.Cancelled);
        Assert.Equal((1, 256L), (statistics.SamplesPerPixel, film.TotalSamples));
        AssertAddUp(film, ways);
    }

    [Theory]
    [InlineData("bidirectional", 2)]
    [InlineData("bidirectional", 3)]
    [InlineData("bidirectional", 4)]
    [InlineData("bidirectional", 5)]
    [InlineData("vcm", 3)]
    [InlineData("light", 3)]
    public void Alone_every_way_finds_the_same_light(string integrator, int edges)
    {
        Dictionary<PathStrategy, ImageSamples> images = [];
        ImageSamples asked = new(16, 16);
        for (int seed = 0; seed < s_seeds; seed++)
        {
            foreach ((PathStrategy way, IImageRows image) in Alone(integrator, edges, 1 + seed))
            {
                images.TryAdd(way, new(16, 16));
                images[way].Add(image);
            }

            // With seeds of its own, so that nothing is compared with itself.
            asked.Add(Alone("bidirectional", edges, 1001 + seed).Single(w => w.Way.Light == 1).Image);
        }

        Assert.Equal(integrator == "light" ? 1 : edges + 1, images.Count);
        foreach ((PathStrategy way, ImageSamples samples) in images)
        {
            BlockTest test = BlockTest.Compare(samples, asked);
            ErrorBudget.Transport.Check(test.P, $"{way.Name} of {integrator}: {test}");
        }
    }

    [Fact]
    public void Alone_merges_find_the_same_light_but_for_their_blur()
    {
        StrategyFilm ways = Render(Build(Room.Replace("\"samplesPerPixel\": 8", "\"samplesPerPixel\": 512", StringComparison.Ordinal), "vcm", seed: 4), new()).Ways;
        foreach (PathStrategy merge in ways.Strategies.Where(s => s is { IsMerge: true, Edges: <= 4 }))
        {
            double asked = Mean(ways.Image(new(1, merge.Edges, false), isWeighted: false));
            Assert.InRange(Mean(ways.Image(merge, isWeighted: false)) / asked, 0.85, 1.1);
        }
    }

    [Fact]
    public void A_mirror_is_no_end_of_a_subpath()
    {
        // All that the camera sees is in a mirror: the second of its vertices.
        string text = Room.Replace("\"shapes\": [", """
            "shapes": [{ "type": "rectangle", "corner": [-2, -1, -1], "edgeU": [4, 0, 0], "edgeV": [0, 4, 0], "material": { "type": "conductor", "metal": "silver" } },
            """, StringComparison.Ordinal).Replace("\"fieldOfView\": 50", "\"fieldOfView\": 20", StringComparison.Ordinal);
        StrategyFilm ways = Render(Build(text, "vcm", seed: 6), new()).Ways;
        Assert.All(ways.Strategies.Where(s => s.Edges > 2), s => Assert.Equal(s.Camera > 2, Mean(ways.Image(s, isWeighted: false)) > 0));
    }

    private static IEnumerable<(PathStrategy Way, IImageRows Image)> Alone(string integrator, int edges, long seed)
    {
        StrategyFilm ways = Render(Build(Room, integrator, seed + (TestSettings.Seed * 1_000_000L)), new()).Ways;
        return ways.Strategies.Where(s => s.Edges == edges && !s.IsMerge && (integrator != "light" || s.Camera == 1)).Select(s => (s, ways.Image(s, isWeighted: false)));
    }

    private static Scene Build(string text, string integrator, long seed) => SceneLoader.Build(SceneReader.ReadText(text, "test.json"), ".", d => d with
    {
        Render = d.Render with
        {
            Integrator = Integrator.Known.All.Single(i => i.Name == integrator),
            Seed = seed,
            SamplesPerPixel = Math.Max(4, d.Render.SamplesPerPixel),
            MergeRadius = 0.05f,
        },
    }).Scene!;

    private static (Film Film, StrategyFilm Ways) Render(Scene scene, RenderOptions options)
    {
        (Film film, StrategyFilm ways, _) = Render(scene, options, default);
        return (film, ways);
    }

    private static (Film Film, StrategyFilm Ways, RenderStatistics Statistics) Render(Scene scene, RenderOptions options, CancellationToken cancellation)
    {
        Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator));
        StrategyFilm ways = new(film, scene);
        return (film, ways, new RTracer(scene, options with { Strategies = ways }).Render(film, cancellation: cancellation));
    }

    private static TimeSpan Cancel(CancellationTokenSource source)
    {
        source.Cancel();
        return TimeSpan.FromSeconds(1);
    }

    private static void AssertAddUp(Film film, StrategyFilm ways)
    {
        IEnumerable<IImageRows> weighted = ways.Layers.Where(l => !l.Name.EndsWith(".unweighted", StringComparison.Ordinal)).Select(l => l.Image);
        float[] picture = Pixels(film);
        double[] sum = new double[picture.Length];
        double[] most = new double[picture.Length];
        foreach (float[] layer in weighted.Select(Pixels))
        {
            for (int i = 0; i < layer.Length; i++)
            {
                sum[i] += layer[i];
                most[i] += Math.Abs(layer[i]);
            }
        }

        Assert.All(Enumerable.Range(0, sum.Length), i => Assert.Equal(picture[i], sum[i], 1e-8 + (2e-6 * most[i])));
        Assert.True(picture.Average() > 0.01);
    }

    private static double Mean(IImageRows image) => Pixels(image).Average();

    private static float[] Pixels(IImageRows image)
    {
        float[] pixels = new float[3 * image.Width * image.Height];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, pixels.AsSpan(3 * y * image.Width, 3 * image.Width));
        }

        return pixels;
    }
}
