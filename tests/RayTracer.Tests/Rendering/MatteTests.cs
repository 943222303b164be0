using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Testing;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers <see cref="FilmPlane.Matte"/>: holdouts and shadow catchers.</summary>
public class MatteTests
{
    private const string White = """{ "type": "diffuse", "color": [0.5, 0.5, 0.5] }""";
    private const string Black = """{ "type": "diffuse", "color": [0, 0, 0] }""";

    [Theory]
    [InlineData("path")]
    [InlineData("volPath")]
    [InlineData("report")]
    public void A_catcher_alone_shows_nothing(string integrator)
    {
        Film film = Rendered(Build(Floor("shadowCatcher"), integrator: integrator, lights: Point));
        Assert.Equal(0, Mean(film, (x, y) => Math.Abs(film.Alpha(x, y))), 1e-6);
        Assert.Equal(0, Mean(film, (x, y) => Math.Abs(film.Mean(x, y).G - film.Backdrop(x, y).G)), 1e-6);
        Assert.InRange(Mean(film, (x, y) => film.Mean(x, y).G), 0.05, 10);
    }

    // The photograph is rendered here: laid over it, the new things make the picture that is rendered at once.
    [Fact]
    public void Laid_over_the_photograph_it_is_the_whole_picture()
    {
        string glass = """{ "type": "sphere", "center": [0.5, 0.5, 0.4], "radius": 0.3, "material": { "type": "plastic", "color": [0.8, 0.3, 0.1] } }""";
        string Things(bool isMatte, string? more) => $"{Floor(isMatte ? "shadowCatcher" : null)}, {Ball(isMatte ? "holdout" : null)}{more}";
        Film film = Rendered(Build(Things(true, ", " + glass), samples: 64, lights: Point));
        Film whole = Rendered(Build(Things(false, ", " + glass), samples: 64, lights: Point));
        Film photograph = Rendered(Build(Things(false, null), samples: 64, lights: Point));
        double worst = 0;
        for (int i = 0; i < 16 * 16; i++)
        {
            (int y, int x) = int.DivRem(i, 16);
            float over = film.Mean(x, y).G - film.Backdrop(x, y).G + ((1 - film.Alpha(x, y)) * photograph.Mean(x, y).G);
            worst = Math.Max(worst, Math.Abs(over - whole.Mean(x, y).G) / whole.Mean(x, y).G);
        }

        // Beside the holdout's edge, what the photograph shows in a pixel is light of both; its own shading is not the new thing's to change.
        Assert.InRange(worst, 0, 0.12);
        Assert.InRange(Mean(film, (x, y) => film.Alpha(x, y)), 0.05, 0.9);
    }

    // A ball straight above a point hides the part (r / d)² of the light of an even sky (the form factor of a sphere): so much of the shadow is laid over the photograph.
    [Theory]
    [InlineData(0.5, 1.5)]
    [InlineData(1, 1.25)]
    public void Under_a_black_ball_the_shadow_is_its_form_factor(double radius, double height)
    {
        string ball = string.Create(CultureInfo.InvariantCulture, $$"""{ "type": "sphere", "center": [0, {{height}}, 0], "radius": {{radius}}, "material": {{Black}} }""");
        Film film = Rendered(Build($"{Floor("shadowCatcher")}, {ball}", samples: 4096, size: 1, fieldOfView: 0.2f, camera: "0, 0.3, 4"));
        double expected = radius * radius / (height * height);
        Assert.InRange(film.Alpha(0, 0), expected - 0.02, expected + 0.02);
        Assert.Equal(film.Mean(0, 0).G, film.Backdrop(0, 0).G, 1e-5f);
    }

    [Fact]
    public void Light_that_things_throw_on_a_catcher_is_added()
    {
        const string wall = $$"""{ "type": "plane", "point": [2, 0, 0], "normal": [-1, 0, 0], "size": [8, 8], "material": {{White}} }""";
        Scene scene = Build($"{Floor("shadowCatcher")}, {wall}", background: 0, samples: 64, lights: Point);
        Film film = Rendered(scene);
        Film floor = Rendered(Build(Floor("shadowCatcher"), background: 0, samples: 64, lights: Point));
        (float with, float alone) = (film.Mean(8, 8).G, floor.Mean(8, 8).G);
        Assert.InRange(with / alone, 1.02, 2);
        Assert.Equal(0, film.Alpha(8, 8), 1e-6f);
        Assert.Equal(with - alone, film.Mean(8, 8).G - film.Backdrop(8, 8).G, 1e-4f);
    }

    [Fact]
    public void A_holdout_leaves_a_hole_and_still_throws_its_shadow()
    {
        string ball = Ball("holdout");
        Scene scene = Build($"{Floor(null)}, {ball}", lights: Point);
        Film film = Rendered(scene);
        Film plain = Rendered(Build($"{Floor(null)}, {Ball(null)}", lights: Point));
        Assert.Equal(plain.ComputeHash([]), film.ComputeHash([]));
        Assert.Equal(0, film.Alpha(8, 8), 1e-6f);
        Assert.Equal(0, film.Mean(8, 8).G - film.Backdrop(8, 8).G, 1e-6f);
        Assert.Equal(1, film.Alpha(0, 0), 1e-6f);
        Assert.Equal(Rgb.Black, film.Backdrop(0, 0));
    }

    [Fact]
    public void The_shadow_of_a_holdout_is_the_photographs_own()
    {
        Film film = Rendered(Build($"{Floor("shadowCatcher")}, {Ball("holdout")}", lights: Point));
        Assert.Equal(0, Mean(film, (x, y) => Math.Abs(film.Alpha(x, y))), 1e-6);
    }

    // The same things as instances, in motion that brings nothing elsewhere, through a lens and among more lights than are all asked at each point.
    [Fact]
    public void Instances_catch_shadows_as_things_do()
    {
        string Instance(string thing) => $$"""{ "type": "instance", "of": {{thing}}, "motion": [{ "time": 0 }, { "time": 1 }] }""";
        string lamps = string.Join(", ", Enumerable.Range(0, 12).Select(i => $$"""{ "type": "point", "position": [{{i - 5}}, 4, 1], "intensity": [3, 3, 3] }"""));
        string lights = $$""", "lights": [{{lamps}}]""";
        const string board = """{ "type": "rectangle", "corner": [-9, 0, 9], "edgeU": [18, 0, 0], "edgeV": [0, 0, -18], "material": { "type": "shadowCatcher" } }""";
        Film things = Rendered(Build($"{board}, {Ball(null)}", samples: 256, lights: lights));
        Film instances = Rendered(Build($"{Instance(board)}, {Instance(Ball(null))}", samples: 256, lights: lights));
        Assert.InRange(Mean(things, (x, y) => things.Alpha(x, y)), 0.1, 0.6);
        Assert.Equal(Mean(things, (x, y) => things.Alpha(x, y)), Mean(instances, (x, y) => instances.Alpha(x, y)), 0.005);
        Assert.Equal(0, Mean(instances, (x, y) => Math.Abs(instances.Alpha(x, y) - things.Alpha(x, y))), 0.02);
    }

    [Fact]
    public void What_stands_before_hides_both()
    {
        string ball = Ball(null).Replace("0.4", "2.2", StringComparison.Ordinal);
        Film film = Rendered(Build($"{Floor("shadowCatcher")}, {ball}", lights: Point));
        Assert.Equal(1, film.Alpha(8, 8), 1e-6f);
        Assert.Equal(Rgb.Black, film.Backdrop(8, 8));
    }

    // Through a pane, paths come straight to the catcher, as to what is behind everything; through a ball of glass they do not, and see a thing.
    [Fact]
    public void Through_a_pane_a_catcher_is_the_photograph_and_through_a_ball_of_glass_a_thing()
    {
        const string pane = """{ "type": "plane", "point": [0, 2, 0], "normal": [0, 1, 0], "size": [9, 9], "material": { "type": "thinDielectric" } }""";
        const string ball = """{ "type": "sphere", "center": [0, 2, 0], "radius": 1, "material": { "type": "dielectric" } }""";
        Film film = Rendered(Build($"{Floor("shadowCatcher")}, {pane}", samples: 256));
        Film glass = Rendered(Build($"{Floor("shadowCatcher")}, {ball}", samples: 256, fieldOfView: 10));

        // Fresnel's equations: 2 R / (1 + R) of the two sides, where R is 0.04 near normal incidence; and the pane reflects as much of the floor's light back to it.
        Assert.InRange(Mean(film, (x, y) => film.Alpha(x, y)), 0.9 * 2 * 0.04 / 1.04, 1.6 * 2 * 0.04 / 1.04);
        Assert.InRange(Mean(glass, (x, y) => glass.Alpha(x, y)), 0.9, 1);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Tiles_threads_and_parts_in_any_order_have_the_same_bits(bool hasMesh)
    {
        const string mesh = """{ "type": "mesh", "positions": [[-1, 0.5, -1], [1, 0.5, -1], [0, 0.5, 1]], "triangles": [[0, 2, 1]], "transform": [{ "translate": [0, 0.1, 0] }] }""";
        Scene scene = Build($"{Floor("shadowCatcher")}, {Ball("holdout")}{(hasMesh ? ", " + mesh : null)}", lights: Point);
        string expected = Rendered(scene).ComputeHash();
        IReadOnlyList<FilmPlane> planes = Planes(scene);
        foreach ((int tile, int threads) in ((int, int)[])[(8, 1), (0, 2), (5, 5)])
        {
            Film film = new(16, 16, planes);
            foreach (SampleRange part in (SampleRange[])[new(11, 16), new(0, 3), new(3, 11)])
            {
                Film more = new(16, 16, planes);
                new RTracer(scene, new() { Samples = part, TileSize = tile, Threads = threads }).Render(more);
                film.Merge(more);
            }

            Assert.Equal(expected, film.ComputeHash());
        }

        SamplePlan plan = new(new(0, 0, 16, 16), [new(0, 0, 16, 16)], [16], 0, new());
        Film planned = new(16, 16, planes);
        new PlannedRender(scene, new(), plan).Render(planned);
        Assert.Equal(expected, planned.ComputeHash());
    }

    [Fact]
    public void Another_view_of_a_scene_has_the_catchers_of_it()
    {
        Scene scene = Build($"{Floor("shadowCatcher")}, {Ball(null)}", lights: Point);
        Scene seen = scene.Guided(null);
        Assert.Equal(Rendered(scene).ComputeHash(), Rendered(seen).ComputeHash());
        Assert.Null(Build(Floor("holdout")).MattesAlone);
    }

    [Fact]
    public void A_film_without_the_plane_leaves_a_hole_for_a_catcher()
    {
        Scene scene = Build($"{Floor("shadowCatcher")}, {Ball(null)}", lights: Point);
        Film film = new(16, 16, FilmPlane.Alpha);
        new RTracer(scene, new() { Threads = 1 }).Render(film);
        Assert.Equal(0, film.Alpha(0, 0), 1e-6f);
        Assert.Equal(1, film.Alpha(8, 8), 1e-6f);
    }

    [Fact]
    public void What_a_pass_gave_is_taken_back()
    {
        Film film = new(2, 1, FilmPlane.Alpha, FilmPlane.Matte);
        SampleAccumulator accumulator = new(2);
        PassCell cell = new(new(0, 0, 2, 1));
        accumulator.Begin(film, new(0, 0, 2, 1), samples: 1);
        accumulator.Add(1, 1u, 0u, (Rgb)new(1, 1, 1));
        accumulator.AddBackdrop(MaskW.First(1), 1u, (Rgb)new(1, 1, 1), 1, (Rgb)new(1, 1, 1));
        accumulator.AddCaught(MaskW.First(1), 1u, 1, (Rgb)new(1, 1, 1));
        accumulator.AddAlone(MaskW.First(1), 1u, (Rgb)new(4, 4, 4));
        accumulator.AddAlone(MaskW.First(1), 1u, (Rgb)new(float.NaN, 4, 4));
        string empty = film.ComputeHash();
        accumulator.End(cell: cell);
        Assert.Equal(0.75f, film.Alpha(1, 0), 1e-6f);
        cell.TakeBack(film, (0, 0, 2), 1, isOfHalf: false);
        Assert.Equal(empty, film.ComputeHash());
        cell.Free();
    }

    private const string Point = """, "lights": [{ "type": "point", "position": [1, 3, 1], "intensity": [20, 20, 20] }]""";

    private static string Floor(string? role) => $$"""{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": {{Within(role, White)}} }""";

    private static string Ball(string? role) => $$"""{ "type": "sphere", "center": [0, 1, 0], "radius": 0.4, "material": {{Within(role, White)}} }""";

    private static string Within(string? role, string material) => role is null ? material : $$"""{ "type": "{{role}}", "material": {{material}} }""";

    private static double Mean(Film film, Func<int, int, float> value) =>
        Enumerable.Range(0, film.Width * film.Height).Average(i => value(i % film.Width, i / film.Width));

    private static IReadOnlyList<FilmPlane> Planes(Scene scene) => FilmPlane.Needed(scene.Render.Integrator, alpha: true, matte: scene.HasMattes);

    private static Film Rendered(Scene scene)
    {
        Film film = new(scene.Render.Width, scene.Render.Height, Planes(scene));
        new RTracer(scene, new() { Threads = 1 }).Render(film);
        return film;
    }

    private static Scene Build(string things, float background = 1, int samples = 16, int size = 16, float fieldOfView = 20, string integrator = "path", string? lights = null, string camera = "0, 5, 0.001") =>
        TestScenes.Build(string.Create(CultureInfo.InvariantCulture, $$"""
        { "render": { "integrator": "{{integrator}}", "width": {{size}}, "height": {{size}}, "samplesPerPixel": {{samples}} },
          "camera": { "position": [{{camera}}], "lookAt": [0, 0, 0], "fieldOfView": {{fieldOfView}} }, "background": [{{background}}, {{background}}, {{background}}],
          "shapes": [ {{things}} ]{{lights}} }
        """));
}
