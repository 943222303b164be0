using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `FirstHitPass.SeesThrough`: what is met behind mirrors and clear glass.</summary>
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

    // A pane, a ball of glass within a larger one, and fog hide nothing of an even wall; the sky has no features.
    [Theory]
    [InlineData("""{ "type": "box", "a": [-9, -9, 1], "b": [9, 9, 1.5], "material": { "type": "dielectric" } }""")]
    [InlineData("""{ "type": "box", "a": [-9, -9, 1], "b": [9, 9, 1.5], "material": { "type": "invisible", "interior": { "extinction": [1, 1, 1] } } }""")]
    [InlineData("""
        { "type": "sphere", "center": [0, 0, 1], "radius": 0.8, "material": { "type": "dielectric", "priority": 1 } },
        { "type": "sphere", "center": [0, 0, 1.2], "radius": 0.9, "material": { "type": "dielectric", "refractiveIndex": 1.33, "priority": 2 } }
        """)]
    public void Glass_and_fog_let_walls_be_seen(string things)
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
