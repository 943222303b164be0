using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session.Tests;

/// <summary>What the textbook edition did is shown as what the fast one did.</summary>
public sealed class TextbookPathTests
{
    private const int Size = 40;
    private const int Samples = 4;

    public static TheoryData<string, string> Scenes => new()
    {
        { "report/scene1.json", "textbook" },
        { "report/scene2.json", "textbook" },
        { "report/scene2.json", "textbook:whitted" },
        { "report/scene3.json", "textbook:printed" },
        { "cornell.json", "textbook" },
        { "primer/08-coloured-glass.json", "textbook:whitted" },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public async Task Contributions_add_up_to_the_pixels_of_the_film(string scene, string edition)
    {
        using TestSession test = new();
        test.Session.View.Change(s => s.WithEdition(edition));
        await test.OpenShipped(scene, Size, Samples);
        await test.FilmHash();
        int vertices = 0;
        int branches = 0;
        foreach ((int x, int y) in from x in Enumerable.Range(0, 4) from y in Enumerable.Range(0, 4) select (5 + (10 * x), 5 + (10 * y)))
        {
            InspectedPixel pixel = await test.Session.Part<PathInspector>().Inspect(x, y, 0, Samples);
            Assert.Equal(Samples, pixel.Samples.Count);
            Near(pixel.Pixel!.Value, pixel.Samples.Aggregate(default(Rgb), (sum, s) => sum + s.Radiance) * (1f / Samples));
            foreach (InspectedPath path in pixel.Samples)
            {
                Rgb sum = Sum(path.Ways.Count > 0 ? path.Ways.Select(w => w.Radiance) : path.Vertices.Select(Contribution));
                Near(path.Radiance, sum);
                Assert.Equal("camera", path.Vertices[0].Event);
                Assert.NotEmpty(path.Sentence);
                Assert.All(path.Vertices.SkipLast(1).Zip(path.Vertices.Skip(1)).Skip(1), pair => Near(pair.First.Throughput * pair.First.Weight * (1 / pair.First.Survival), pair.Second.Throughput));
                Assert.All(path.Vertices.Where(v => v.Lights.Count > 0), v => Near(new((float)v.Parts.Direct[0], (float)v.Parts.Direct[1], (float)v.Parts.Direct[2]), Sum(v.Lights.Select(l => l.Contribution))));
                vertices += path.Vertices.Count;
                branches += path.Ways.Count;
            }

            Assert.Equal(pixel.Samples[0].Vertices[1].Pointer is not null, pixel.Samples[0].Vertices[1].Event != "miss");
        }

        Assert.True(vertices > 16 * Samples * 2);
        Assert.Equal(edition == "textbook:whitted", branches > 0);
    }

    [Fact]
    public async Task Paths_from_lights_are_followed_back_from_the_pixel_they_end_in()
    {
        using TestSession test = new();
        test.Session.View.Change(s => s.WithEdition("textbook"));
        await test.Open("""
            {
              "render": { "width": 16, "height": 12, "samplesPerPixel": 4, "integrator": "light" },
              "camera": { "position": [0, 3, 6], "lookAt": [0, 0, 0] },
              "shapes": [
                { "type": "plane", "name": "floor", "point": [0, -1, 0], "normal": [0, 1, 0] },
                { "type": "sphere", "name": "ball", "center": [0, 0, 0], "material": { "type": "dielectric" } },
                { "type": "sphere", "name": "lamp", "center": [-3, 3, 2], "radius": 0.5, "material": { "type": "luminaire", "color": "white", "multiplier": 9 } }
              ]
            }
            """);
        await test.FilmHash();
        int through = 0;
        foreach ((int x, int y) in from x in Enumerable.Range(6, 8) from y in Enumerable.Range(5, 5) select (x, y))
        {
            InspectedPixel pixel = await test.Session.Part<PathInspector>().Inspect(x, y, 0, 4);
            Near(pixel.Pixel!.Value, pixel.Samples.Aggregate(default(Rgb), (sum, s) => sum + s.Radiance) * 0.25f);
            foreach (InspectedPath path in pixel.Samples)
            {
                Near(path.Radiance, Sum(path.Vertices.Select(Contribution)));
                InspectedWay[] seen = [.. path.Ways.Where(w => w.Event == "seen")];
                Near(Sum(seen.Select(w => w.Radiance)), Contribution(path.Vertices[0]));
                Assert.All(seen, w => Assert.Equal((w.Things.Count + 1, w.Things.Count + 2), (w.LightVertices, w.Points.Count)));
                Assert.All(seen, w => Assert.True(MathF.Abs(Vector3.Distance(w.Points[^1], new(-3, 3, 2)) - 0.5f) < 0.01f));
                through += seen.Count(w => w.Things is ["ball", .., "floor"]);
            }
        }

        Assert.True(through > 0);
    }

    [Fact]
    public async Task Names_and_places_are_those_of_the_fast_edition()
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped("report/scene2.json", Size, Samples);
        test.Session.View.Change(s => s.WithEdition("textbook"));
        for (int i = 2; i < Size; i += 4)
        {
            InspectedVertex met = (await test.Session.Part<PathInspector>().Inspect(i, i, 0, 1)).Samples[0].Vertices[1];
            PickResult picked = Picking.At(shown, i, i);
            if (met.Pointer == picked.Pointer && picked.Position is { } there)
            {
                Assert.True(Vector3.Distance(there, met.Position) < 0.5f, $"{i}: {met.Position} for {there}");
            }
        }

        PixelSummary summary = test.Session.Part<PathInspector>().Summarize(Size / 2, Size / 2);
        Assert.Equal(Samples, summary.Samples);
    }

    [Fact]
    public async Task A_ray_is_followed_through_every_tree_to_the_same_place()
    {
        using TestSession test = new();
        TreeWalks walks = test.Session.Part<TreeWalks>();
        await test.Open("""{ "render": { "width": 40, "height": 40 }, "shapes": [ { "type": "sphere", "center": [0, 0, 0] }, { "type": "box", "a": [2, 0, 0], "b": [3, 1, 1] }, { "type": "torus", "center": [0, 2, 0] }, { "type": "mesh", "positions": [[-4,-4,-4],[4,-4,-4],[0,4,-4],[0,0,-9]], "triangles": [[0,1,2],[0,2,3],[1,2,3]] } ] }""");
        TreeWalk[] all = [.. TreeWalks.Names.Select(name => walks.Walk(20, 20, 0, 1, name))];
        Assert.All(all, w =>
        {
            Assert.Equal((6, all[0].End, all[0].IsHit), (w.Shapes, w.End, w.IsHit));
            Assert.Equal(w.Tree == "plain loop" ? w.Tests : w.Visits, w.Steps.Count);
            Assert.Equal(w.Steps.Select(s => s.Tests), w.Steps.Select(s => s.Tests).Order());
            Assert.All(w.Steps.SelectMany(s => s.Lines).SelectMany(l => l), p => Assert.True(p.Length() < 100));

            // A shape that reaches into several cells may be asked in each.
            Assert.InRange(w.Tests, 1, 12);
        });
        Assert.True(all[0].IsHit);
        Assert.Contains(all, w => w.Tests < 6);
        Assert.Throws<SessionException>(() => walks.Walk(20, 20, 0, 1, "oak"));
        Assert.Throws<SessionException>(() => walks.Walk(-1, 20, 0, 1, "octree"));
    }

    [Fact]
    public void Every_tree_has_a_text() =>
        Assert.All(TreeWalks.Names, name => Assert.NotEmpty(SessionTexts.Of($"trees.names.{name}")));

    private static Rgb Contribution(InspectedVertex v) => new((float)v.Contribution[0], (float)v.Contribution[1], (float)v.Contribution[2]);

    private static Rgb Sum(IEnumerable<Rgb> colors) => colors.Aggregate(default(Rgb), (sum, c) => sum + c);

    private static void Near(Rgb expected, Rgb found)
    {
        float size = 1e-4f + (1e-4f * expected.Luminance);
        Assert.True(
            MathF.Abs(expected.R - found.R) < size && MathF.Abs(expected.G - found.G) < size && MathF.Abs(expected.B - found.B) < size, $"{found} for {expected}");
    }
}
