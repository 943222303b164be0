using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `FirstHitPass.SeesThrough`: what is met behind mirrors and clear glass, and in media.</summary>
public sealed class SeenThroughTests
{
    private const int Width = 40;
    private const int Height = 30;
    private static readonly AuxiliaryImage[] s_kinds = [new AlbedoImage(), new NormalImage()];

    // The camera looks at a mirror; in the other scene, at what stands behind a plane where the mirror was.
    [Theory]
    [InlineData("")]
    [InlineData(""", "transform": [{ "translate": [0, 0, 0] }]""")]
    public void A_mirror_shows_what_stands_before_it(string transform)
    {
        AovFilm mirrored = Trace(Scene($$"""
            { "type": "mesh", "positions": [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]{{transform}},
              "material": { "type": "phongMetal", "color": [0.5, 0.75, 1], "exponent": 1000000 } },
            { "type": "sphere", "center": [0.4, 0.3, 12], "radius": 2, "material": { "type": "diffuse", "color": [0.8, 0.6, 0.4] } }
            """));
        AovFilm plain = Trace(Scene("""
            { "type": "sphere", "center": [0.4, 0.3, -12], "radius": 2, "material": { "type": "diffuse", "color": [0.4, 0.45, 0.4] } }
            """));
        int met = 0;
        for (int i = 0; i < Width * Height; i++)
        {
            double[] there = Read(plain, new NormalImage(), i);
            double[] seen = Read(mirrored, new NormalImage(), i);

            // Along the outline, a bit decides.
            bool isEdge = Math.Abs(there[2]) < 0.3 && there[2] != 0;
            if (!isEdge && (there[2] == 0) == (seen[2] == 0))
            {
                met += there[2] == 0 ? 0 : 1;
                AssertClose([there[0], there[1], -there[2]], seen, 0.04);
                AssertClose(Read(plain, new AlbedoImage(), i), Read(mirrored, new AlbedoImage(), i), 1e-4);
            }
        }

        Assert.InRange(met, 30, Width * Height);
    }

    // A pane, a ball of glass within a larger one, and what only absorbs hide nothing of an even wall; the sky has no features.
    [Theory]
    [InlineData("""{ "type": "box", "a": [-9, -9, 1], "b": [9, 9, 1.5], "material": { "type": "dielectric" } }""")]
    [InlineData("""{ "type": "box", "a": [-9, -9, 1], "b": [9, 9, 1.5], "material": { "type": "invisible", "interior": { "extinction": [1, 1, 1] } } }""")]
    [InlineData("""
        { "type": "sphere", "center": [0, 0, 1], "radius": 0.8, "material": { "type": "dielectric", "priority": 1 } },
        { "type": "sphere", "center": [0, 0, 1.2], "radius": 0.9, "material": { "type": "dielectric", "refractiveIndex": 1.33, "priority": 2 } }
        """)]
    public void Glass_and_what_only_absorbs_let_walls_be_seen(string things)
    {
        AovFilm film = Trace(Scene($$"""
            { "type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1], "material": { "type": "diffuse", "color": [0.3, 0.2, 0.1] } }, {{things}}
            """));
        AovFilm before = Trace(Scene(things));
        for (int y = 12; y < 18; y++)
        {
            for (int x = 17; x < 23; x++)
            {
                AssertClose([0.3, 0.2, 0.1], Read(film, new AlbedoImage(), (y * Width) + x), 1e-5);
                AssertClose([0, 0, 1], Read(film, new NormalImage(), (y * Width) + x), 1e-5);
                AssertClose([0, 0, 0], Read(before, new AlbedoImage(), (y * Width) + x), 0);
            }
        }
    }

    // Before a wall: fog, even and varying, what shines, the first two behind each other, and fog between a mirror and what it shows. What is left of the light is left of the features.
    [Theory]
    [InlineData("even", 0.5 * 1.5)]
    [InlineData("dense", 0.5 * 12)]
    [InlineData("glowing", 0.5 * 1.5)]
    [InlineData("grid", 0.5 * 2)]
    [InlineData("even grid", 0.5 * 3.5)]
    [InlineData("colored", 0.5 * 1.5)]
    public void Fog_hides_walls_as_it_weakens_light(string things, double depth)
    {
        using TemporaryFolder folder = new();
        string points = TestVolumes.Write(folder["even.vol"], TestVolumes.Vol(2, 3, 4, (_, _, _) => [0.5f]));
        string Fog(string interior, double z) => $$"""
            { "type": "box", "a": [-9, -9, {{z}}], "b": [9, 9, {{z + 0.5}}], "material": { "type": "invisible", "interior": { {{interior}} } } },
            """;
        string fogs = string.Concat(things.Split(' ').Select((thing, i) => thing switch
        {
            "even" => Fog(""" "extinction": [1.5, 1.5, 1.5], "albedo": [0.9, 0.5, 0.1] """, i),
            "dense" => Fog(""" "extinction": [12, 12, 12], "albedo": [0.9, 0.9, 0.9] """, i),
            "glowing" => Fog($$""" "extinction": [3, 3, 3], "emission": [1, 0.5, 0], "density": { "file": "{{points}}", "box": [[-9, -9, {{i}}], [9, 9, {{i + 0.5}}]] } """, i),
            "grid" => Fog($$""" "extinction": [4, 4, 4], "albedo": [0.9, 0.9, 0.9], "density": { "file": "{{points}}", "box": [[-9, -9, {{i}}], [9, 9, {{i + 0.5}}]] } """, i),
            _ => Fog(""" "extinction": [1.5, 1.5, 1.5], "albedo": [0, 0.5, 0] """, i),
        }));
        const string wall = """{ "type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1], "material": { "type": "diffuse", "color": [0.3, 0.2, 0.1] } }""";
        double left = Math.Exp(-depth);
        AssertSeen(Trace(Scene(fogs + wall)), left);

        // A mirror behind the fog shows a wall behind the camera: the fog is passed twice.
        const string mirror = """
            { "type": "plane", "point": [0, 0, -1], "normal": [0, 0, 1], "material": { "type": "phongMetal", "color": [1, 1, 1], "exponent": 1000000 } },
            { "type": "plane", "point": [0, 0, 9], "normal": [0, 0, -1], "material": { "type": "diffuse", "color": [0.3, 0.2, 0.1] } }
            """;
        AssertSeen(Trace(Scene(fogs + mirror)), left * left);
    }

    // The camera stands in the fog, as does the wall, which is seen in a mirror or not.
    [Theory]
    [InlineData("""{ "type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1], "material": { "type": "diffuse", "color": [0.3, 0.2, 0.1] } }""", 7)]
    [InlineData("""
        { "type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1], "material": { "type": "phongMetal", "color": [1, 1, 1], "exponent": 1000000 } },
        { "type": "plane", "point": [0, 0, 8], "normal": [0, 0, -1], "material": { "type": "diffuse", "color": [0.3, 0.2, 0.1] } }
        """, 7 + 10)]
    public void Fog_around_the_camera_hides_walls(string things, double way) => AssertSeen(
        Trace(Scene($$"""
            { "type": "box", "a": [-9, -9, -3], "b": [9, 9, 9], "material": { "type": "invisible", "interior": { "extinction": [0.1, 0.1, 0.1], "albedo": [1, 1, 1] } } }, {{things}}
            """)),
        Math.Exp(-0.1 * way));

    // The density grows evenly from the lower face of the fog to the upper one: what is left is known from the mean on the way.
    [Fact]
    public void Where_fog_varies_its_features_have_no_noise()
    {
        using TemporaryFolder folder = new();
        string points = TestVolumes.Write(folder["slope.vol"], TestVolumes.Vol(1, 64, 1, (_, y, _) => [(y + 0.5f) / 64]));
        AovFilm film = Trace(Scene($$"""
            { "type": "box", "a": [-9, -4, 1], "b": [9, 4, 2], "material": { "type": "invisible", "interior": { "extinction": [4, 4, 4], "albedo": [0.9, 0.9, 0.9],
                "density": { "file": "{{points}}", "box": [[-9, -4, 1], [9, 4, 2]] } } } },
            { "type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1], "material": { "type": "diffuse", "color": [0.3, 0.2, 0.1] } }
            """));
        for (int y = 0; y < Height; y++)
        {
            // On the row's way through the fog, 3 to 4 before the camera, the middle is at 3.5.
            double slope = Math.Tan(20 * Math.PI / 180) * (((Height / 2.0) - y - 0.5) / (Height / 2.0));
            double density = ((3.5 * slope) + 4) / 8;
            double left = Math.Exp(-4 * density * Math.Sqrt(1 + (slope * slope)));
            Assert.Equal(left, Read(film, new NormalImage(), (y * Width) + (Width / 2))[2], 0.01 * left);
        }
    }

    [Fact]
    public void Without_mirrors_it_is_the_first_hit_to_the_bit_over_any_threads_and_tiles()
    {
        Scene plain = Scene("""
            { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "diffuse", "color": [0.3, 0.2, 0.1] } },
            { "type": "box", "a": [0, 0, -1], "b": [1, 2, 1], "material": { "type": "phongMetal", "exponent": 20 } }
            """);
        Assert.Equal(Trace(plain, sees: false).Content(), Trace(plain).Content());
        Scene everything = TestScenes.BuildEverything();
        byte[] one = Trace(everything, new() { Threads = 1 }).Content();
        Assert.NotEqual(Trace(everything, sees: false).Content(), one);
        foreach ((int threads, int tile, int stream) in new[] { (3, 7, 1), (2, 64, 65536) })
        {
            Assert.Equal(one, Trace(everything, new() { Threads = threads, TileSize = tile, StreamSize = stream }).Content());
        }
    }

    // Between two mirrors nobody gets to an end.
    [Fact]
    public void What_is_between_two_mirrors_ends()
    {
        AovFilm film = Trace(Scene("""
            { "type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1], "material": { "type": "phongMetal", "color": [1, 1, 1], "exponent": 1000000 } },
            { "type": "plane", "point": [0, 0, 7], "normal": [0, 0, 1], "material": { "type": "phongMetal", "color": [1, 1, 1], "exponent": 1000000 } }
            """));
        Assert.Equal(1, Math.Abs(Read(film, new NormalImage(), (15 * Width) + 20)[2]), 1e-6);
    }

    private static void AssertSeen(AovFilm film, double left)
    {
        int middle = (15 * Width) + 20;
        AssertClose([0.3 * left, 0.2 * left, 0.1 * left], Read(film, new AlbedoImage(), middle), 0.001 * left);
        AssertClose([0, 0, left], Read(film, new NormalImage(), middle).Select(Math.Abs).ToArray(), 0.003 * left);
    }

    private static Scene Scene(string shapes) => TestScenes.Build($$"""
        {
          "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
          "render": { "integrator": "volPath", "width": {{Width}}, "height": {{Height}}, "samplesPerPixel": 1, "sampler": "regular" },
          "background": [0.5, 0.6, 0.7], "shapes": [{{shapes}}]
        }
        """);

    private static AovFilm Trace(Scene scene, RenderOptions? options = null, bool sees = true)
    {
        AovFilm film = new(new(scene.Render.Width, scene.Render.Height), s_kinds);
        new FirstHitPass(scene, options) { SeesThrough = sees }.Render(film);
        return film;
    }

    private static double[] Read(AovFilm film, AuxiliaryImage kind, int pixel)
    {
        double[] row = new double[3 * film.Width];
        film.ReadRow(kind, pixel / film.Width, row);
        return row[(3 * (pixel % film.Width))..][..3];
    }

    private static void AssertClose(double[] expected, double[] actual, double tolerance)
    {
        for (int i = 0; i < expected.Length; i++)
        {
            Assert.Equal(expected[i], actual[i], tolerance);
        }
    }
}
