using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Testing;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers <see cref="FilmPlane.Alpha"/>: what films know of what is behind everything.</summary>
public class AlphaTests
{
    private const string Lamp = """{ "type": "sphere", "center": [0.3, 0, 0], "radius": 0.6, "material": { "type": "luminaire", "multiplier": 2 } }""";
    private const string Boundary = """{ "type": "plane", "point": [0, 0, 1], "normal": [0.1, 0, 1], "size": [1, 3], "material": { "type": "invisible" } }""";
    private const string Holes = """{ "type": "plane", "point": [0, 0, 2], "normal": [0, 0, 1], "size": [3, 1], "material": { "type": "mask", "opacity": 0.4, "material": { "type": "diffuse", "color": [0, 0, 0] } } }""";
    private static readonly Rgb s_sky = new(0.25f, 0.5f, 1);
    private static readonly Rgb s_other = new(1, 0.125f, 0.5f);

    public static TheoryData<string> Integrators => [.. Integrator.Known.All.Select(i => i.Name)];

    [Theory]
    [InlineData("box")]
    [InlineData("mitchell")]
    public void Over_another_background_it_is_the_picture_with_that_background(string filter)
    {
        string things = $"{Lamp}, {Boundary}, {Holes}";
        Film film = Rendered(Build("path", things, s_sky, filter));
        Film expected = Rendered(Build("path", things, s_other, filter), hasAlpha: false);
        int between = 0;
        for (int pixel = 0; pixel < film.Width * film.Height; pixel++)
        {
            (int y, int x) = int.DivRem(pixel, film.Width);
            AssertNear(expected.Mean(x, y), Over(film, x, y, s_other), 2e-5f);
            between += film.Alpha(x, y) is > 0.05f and < 0.95f ? 1 : 0;
        }

        Assert.InRange(between, 50, film.Width * film.Height);
        Assert.Equal(0, film.Alpha(0, 0), filter == "box" ? 1e-9 : 0.5);
        Assert.Equal(1, film.Alpha(13, 8), 1e-9);
        Assert.Equal(film.Mean(0, 0), film.Backdrop(0, 0));
        Assert.Equal(Rgb.Black, film.Backdrop(13, 8));
    }

    [Theory]
    [MemberData(nameof(Integrators))]
    public void Every_integrator_finds_the_same_alpha_and_the_same_light(string integrator)
    {
        Scene scene = Build(integrator, $"{Lamp}, {Boundary}", s_sky);
        Film film = Rendered(scene);
        Assert.Equal(Rendered(scene, hasAlpha: false).ComputeHash(), film.ComputeHash(FilmPlane.Needed(scene.Render.Integrator)));

        // What is behind the boundary is seen by paths alone.
        bool shows = scene.Render.Integrator.Has(IntegratorTraits.Light);
        Assert.Equal(0, film.Alpha(0, 0));
        Assert.Equal(shows ? 0 : 1, film.Alpha(12, 2));
        Assert.Equal(1, film.Alpha(13, 8));
        AssertNear(film.Mean(0, 0), film.Backdrop(0, 0), 0);
    }

    [Theory]
    [InlineData("path")]
    [InlineData("bidirectional")]
    public void Through_a_pane_it_is_what_the_glass_reflects_and_in_a_mirror_it_is_all(string integrator)
    {
        string Pane(string material) => $$"""{ "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "size": [9, 9], "material": { "type": "{{material}}" } }""";
        Film pane = Rendered(Build(integrator, Pane("thinDielectric"), s_sky, samples: 64));
        Film mirror = Rendered(Build(integrator, Pane("conductor"), s_sky));

        // Fresnel's equations at normal incidence: 2 R / (1 + R) of the two sides, where R is 0.04.
        Assert.InRange(Mean(pane, (x, y) => pane.Alpha(x, y)), 0.9 * 2 * 0.04 / 1.04, 1.3 * 2 * 0.04 / 1.04);
        AssertNear(s_sky, Over(pane, 12, 8, s_sky), 1e-4f);
        Assert.Equal(1, Mean(mirror, (x, y) => mirror.Alpha(x, y)));
        Assert.Equal(0, Mean(mirror, (x, y) => mirror.Backdrop(x, y).G));
    }

    [Fact]
    public void A_ball_of_glass_lets_the_background_through_but_for_what_it_absorbs()
    {
        const string ball = """{ "type": "sphere", "center": [0, 0, 0], "radius": 1.2, "material": { "type": "dielectric", "extinction": [EXTINCTION, EXTINCTION, EXTINCTION] } }""";
        Film clear = Rendered(Build("path", ball.Replace("EXTINCTION", "0", StringComparison.Ordinal), s_sky, samples: 64));
        Film dark = Rendered(Build("path", ball.Replace("EXTINCTION", "1", StringComparison.Ordinal), s_sky, samples: 64));
        Assert.InRange(clear.Alpha(11, 8), 0.02, 0.2);
        Assert.InRange(dark.Alpha(11, 8), 0.85, 0.95);
        AssertNear(dark.Mean(11, 8), Over(dark, 11, 8, s_sky), 1e-4f);
    }

    [Fact]
    public void Tiles_threads_and_parts_in_any_order_have_the_same_bits()
    {
        Scene scene = Build("path", $"{Lamp}, {Boundary}, {Holes}", s_sky, "mitchell");
        string expected = Rendered(scene).ComputeHash();
        foreach ((int tile, int threads) in ((int, int)[])[(8, 1), (0, 2), (5, 5)])
        {
            Film film = new(24, 16, FilmPlane.Alpha);
            foreach (SampleRange part in (SampleRange[])[new(11, 16), new(0, 3), new(3, 11)])
            {
                Film more = new(24, 16, FilmPlane.Alpha);
                new RTracer(scene, new() { Samples = part, TileSize = tile, Threads = threads }).Render(more);
                film.Merge(more);
            }

            Assert.Equal(expected, film.ComputeHash());
        }
    }

    [Fact]
    public void Layers_of_light_go_along()
    {
        Scene scene = Build("path", $"{Lamp}, {Holes}", s_sky);
        LightPathAovFilm[] layers = new LightPathAovFilm[2];
        Film[] films = [new(24, 16, FilmPlane.Alpha), new(24, 16)];
        for (int i = 0; i < films.Length; i++)
        {
            layers[i] = new(films[i], scene, Enum.GetValues<LightPathAov>());
            new RTracer(scene, new() { Layers = layers[i] }).Render(films[i]);
        }

        Assert.Equal(Rendered(scene).ComputeHash(), films[0].ComputeHash());
        for (int layer = 0; layer < layers[0].Names.Count; layer++)
        {
            Assert.Equal(Row(layers[1], layer), Row(layers[0], layer));
        }
    }

    [Fact]
    public void Pixels_with_different_numbers_of_samples_have_alpha_too()
    {
        Scene scene = Build("path", $"{Lamp}, {Boundary}", s_sky);
        SamplePlan plan = new(new(0, 0, 24, 16), [new(0, 0, 10, 16), new(10, 0, 14, 16)], [5, 16], 0, new());
        Film film = new(24, 16, FilmPlane.Alpha);
        new PlannedRender(scene, new(), plan).Render(film);
        Assert.Equal((0f, 1f), (film.Alpha(0, 0), film.Alpha(13, 8)));
        Assert.Equal((5u, 16u), (film.SampleCount(0, 0), film.SampleCount(13, 8)));
    }

    [Fact]
    public void What_a_pass_gave_is_taken_back_and_what_is_not_finite_left_out()
    {
        Film film = new(2, 1, FilmPlane.Alpha);
        SampleAccumulator accumulator = new(2);
        PassCell cell = new(new(0, 0, 2, 1));
        accumulator.Begin(film, new(0, 0, 2, 1), samples: 2);
        Add(new(1, 1, 1), 1, new(1, 1, 1));
        Add(new(float.NaN, 1, 1), 1, new(1, 1, 1));
        string empty = film.ComputeHash();
        accumulator.End(cell: cell);
        Assert.Equal((0f, new(1, 1, 1)), (film.Alpha(1, 0), film.Backdrop(1, 0)));
        cell.TakeBack(film, (0, 0, 2), 2, isOfHalf: false);
        Assert.Equal(empty, film.ComputeHash());
        cell.Free();

        void Add(Rgb radiance, float through, Rgb light)
        {
            accumulator.Add(1, 1u, 0u, radiance);
            accumulator.AddBackdrop(MaskW.First(1), 1u, radiance, through, light);
        }
    }

    private static float[] Row(LightPathAovFilm film, int layer)
    {
        float[] row = new float[3 * 24];
        film.Image(layer).ReadRow(10, row);
        return row;
    }

    private static Rgb Over(Film film, int x, int y, Rgb background) =>
        film.Mean(x, y) + (film.Backdrop(x, y) * -1) + (background * (1 - film.Alpha(x, y)));

    private static void AssertNear(Rgb expected, Rgb actual, float tolerance)
    {
        Assert.Equal(expected.R, actual.R, tolerance);
        Assert.Equal(expected.G, actual.G, tolerance);
        Assert.Equal(expected.B, actual.B, tolerance);
    }

    private static double Mean(Film film, Func<int, int, float> value) =>
        Enumerable.Range(0, film.Width * film.Height).Average(i => value(i % film.Width, i / film.Width));

    private static Film Rendered(Scene scene, bool hasAlpha = true)
    {
        Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator, alpha: hasAlpha));
        new RTracer(scene, new() { Threads = 1 }).Render(film);
        return film;
    }

    private static Scene Build(string integrator, string things, Rgb background, string filter = "box", int samples = 16) => TestScenes.Build($$"""
        { "render": { "integrator": "{{integrator}}", "width": 24, "height": 16, "samplesPerPixel": {{samples}}, "filter": { "shape": "{{filter}}" } },
          "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 40 }, "background": [{{background.R}}, {{background.G}}, {{background.B}}],
          "shapes": [ {{things}} ] }
        """);
}
