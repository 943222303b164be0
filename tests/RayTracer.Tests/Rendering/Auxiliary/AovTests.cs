using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `FirstHitPass`, `AuxiliaryImage` and `AovFilm`.</summary>
public sealed class AovTests
{
    private const int Width = 48;
    private const int Height = 32;
    private static readonly Vector3 s_eye = new(0, 0, 5);

    // A square of two triangles, two units wide.
    private const string Square = """
        "type": "mesh", "positions": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]
        """;

    private static readonly Scene s_square = Scene($$"""{ {{Square}} }""");

    [Fact]
    public void A_sphere_has_the_depth_normal_and_uv_of_its_formula()
    {
        AovFilm film = Trace(Scene("""{ "type": "sphere", "center": [0, 0, 0], "radius": 1.5 }"""));
        int met = 0;
        for (int i = 0; i < Width * Height; i++)
        {
            Vector3 d = Direction(i, Width, Height);
            float b = Vector3.Dot(s_eye, d);
            float root = (b * b) - s_eye.LengthSquared() + 2.25f;
            if (MathF.Abs(root) < 0.02f)
            {
                continue;
            }

            double[] n = Read(film, new NormalImage(), i);
            if (root < 0)
            {
                double[] nothing = [.. Read(film, new DepthImage(), i), .. n, .. Read(film, new UvImage(), i)];
                Assert.Equal([double.PositiveInfinity, 0, 0, 0, 0, 0], nothing);
                continue;
            }

            met++;
            float t = -b - MathF.Sqrt(root);
            Vector3 expected = (s_eye + (t * d)) / 1.5f;
            AssertClose(t, Read(film, new DepthImage(), i)[0]);
            AssertClose(expected.X, n[0]);
            AssertClose(expected.Y, n[1]);
            AssertClose(expected.Z, n[2]);
            AssertClose(0.5 + (Math.Atan2(expected.X, expected.Z) / (2 * Math.PI)), Read(film, new UvImage(), i)[0]);
            AssertClose(Math.Acos(-expected.Y) / Math.PI, Read(film, new UvImage(), i)[1]);
        }

        Assert.InRange(met, 200, Width * Height);
    }

    [Fact]
    public void A_board_has_the_depth_uv_and_colours_of_its_formula_on_either_side()
    {
        foreach (int side in new[] { 1, -1 })
        {
            AovFilm film = Trace(Scene($$"""{ "type": "plane", "point": [0, 0, 0], "normal": [0, 0, {{side}}], "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.25, 0.5, 0.75], "odd": [0.5, 0, 1], "offset": [0.1, 0.2] } } }"""));
            for (int i = 0; i < Width * Height; i++)
            {
                Vector3 d = Direction(i, Width, Height);
                double t = -s_eye.Z / d.Z;
                AssertClose(t, Read(film, new DepthImage(), i)[0]);
                Assert.Equal([0, 0, 1], Read(film, new NormalImage(), i));

                // u runs to the right for whoever looks at the front.
                double[] uv = [side * t * d.X, t * d.Y];
                AssertClose(uv[0], Read(film, new UvImage(), i)[0]);
                AssertClose(uv[1], Read(film, new UvImage(), i)[1]);
                (double u, double v) = (uv[0] + 0.1, uv[1] + 0.2);
                if (Math.Abs(u - Math.Round(u)) > 1e-4 && Math.Abs(v - Math.Round(v)) > 1e-4)
                {
                    bool even = ((int)Math.Floor(u) + (int)Math.Floor(v)) % 2 == 0;
                    Assert.Equal(even ? [0.25, 0.5, 0.75] : [0.5, 0, 1], Read(film, new AlbedoImage(), i));
                }
            }
        }
    }

    [Theory]
    [InlineData("""{ "type": "phongMetal", "color": [0.5, 0.25, 0.125] }""", 0.5)]
    [InlineData("""{ "type": "dielectric" }""", 1)]
    [InlineData("""{ "type": "luminaire", "multiplier": 3 }""", 0)]
    [InlineData("""{ "type": "luminaire", "multiplier": 3, "material": { "type": "diffuse", "color": [0.25, 0, 0] } }""", 0.25)]
    [InlineData("""{ "type": "luminaire", "multiplier": 3, "material": { "type": "dielectric" } }""", 1)]
    public void Albedo_is_what_a_material_sends_on_and_not_what_it_shines(string material, double red)
    {
        AovFilm film = Trace(Scene($$"""{ "type": "sphere", "center": [0, 0, 0], "radius": 1.5, "material": {{material}} }"""));
        Assert.Equal(red, Read(film, new AlbedoImage(), Middle)[0]);
    }

    [Fact]
    public void An_instance_shows_what_stands_at_its_place()
    {
        AovFilm film = Trace(Scene($$"""{ "type": "instance", "of": { {{Square}} }, "transform": [{ "scale": [2, 3, 1], "translate": [0, 0, 1] }] }"""));
        Assert.Equal([0, 0, 1], Read(film, new NormalImage(), Middle));
        AssertClose(-4 / Direction(Middle, Width, Height).Z, Read(film, new DepthImage(), Middle)[0]);
    }

    [Fact]
    public void Means_are_over_all_samples_or_those_that_meet_something()
    {
        const string shape = """{ "type": "sphere", "center": [0.1, 0.2, 0], "radius": 1.3, "material": { "type": "diffuse", "color": [0.5, 0.25, 0.75] } }""";
        AovFilm four = Trace(Scene(shape, Width, Height, 4));
        AovFilm fine = Trace(Scene(shape, 2 * Width, 2 * Height, 1));
        int edges = 0;
        for (int i = 0; i < Width * Height; i++)
        {
            int first = (4 * Width * (i / Width)) + (2 * (i % Width));
            int[] parts = [first, first + 1, first + (2 * Width), first + (2 * Width) + 1];
            int[] met = [.. parts.Where(p => Read(fine, new PrimitiveImage(), p)[0] > 0)];
            edges += met.Length is > 0 and < 4 ? 1 : 0;
            Assert.Equal(Read(fine, new PrimitiveImage(), first), Read(four, new PrimitiveImage(), i));
            foreach (AuxiliaryImage kind in new AuxiliaryImage[] { new DepthImage(), new UvImage(), new NormalImage(), new AlbedoImage() })
            {
                for (int c = 0; c < kind.Letters.Length; c++)
                {
                    double sum = met.Sum(p => Read(fine, kind, p)[c]);
                    double nothing = kind is DepthImage ? double.PositiveInfinity : 0;
                    double mean = kind is NormalImage or AlbedoImage ? sum / 4 : met.Length > 0 ? sum / met.Length : nothing;
                    Assert.Equal(mean, Read(four, kind, i)[c], 5e-4);
                }
            }
        }

        Assert.InRange(edges, 20, Width * Height);
    }

    [Fact]
    public void Primitives_are_numbered_from_one_and_keep_their_numbers_all_over_a_shape()
    {
        AovFilm film = Trace(Scene("""{ "type": "sphere", "center": [-1, 0, 0], "radius": 0.8 }, { "type": "sphere", "center": [1, 0, 0], "radius": 0.8 }"""));
        double[] all = [.. Enumerable.Range(0, Width * Height).Select(i => Read(film, new PrimitiveImage(), i)[0])];
        Assert.Equal([0, 1, 2], all.Distinct().Order());
        Assert.All(all.Index().Where(p => p.Item > 0), p => Assert.Equal(p.Index % Width < Width / 2 ? 1 : 2, p.Item));
        AovFilm square = Trace(s_square);
        IEnumerable<double> shown = Enumerable.Range(0, Width * Height).Select(i => Read(square, new PrimitiveImage(), i)[0]);
        double[] triangles = [.. shown.Distinct().Order()];
        Assert.Equal([0, 1, 2], triangles);
    }

    [Fact]
    public void Cost_counts_nodes_and_triangles_of_all_trees()
    {
        // One node holds the two triangles in one leaf; another one stands over the instance. A ray that goes past has asked the node.
        Assert.Equal(3, Read(Trace(s_square), new BvhCostImage(), Middle)[0]);
        Scene instance = Scene($$"""{ "type": "instance", "of": { {{Square}} }, "transform": [{ "translate": [0, 0, 1] }] }""");
        Assert.Equal(4, Read(Trace(instance), new BvhCostImage(), Middle)[0]);
        Assert.Equal(1, Read(Trace(s_square), new BvhCostImage(), 0)[0]);
        Assert.Equal(0, Read(Trace(Scene("""{ "type": "sphere", "center": [0, 0, 0] }""")), new BvhCostImage(), Middle)[0]);
    }

    [Fact]
    public void Cost_is_that_of_the_tree_by_itself_whatever_stands_behind()
    {
        string json = Terrain(out Vector3[] positions, out int[] indices);
        TriangleBvh tree = TriangleBvh.Build(positions, indices, 1);
        AovFilm film = Trace(Scene(json + """, { "type": "sphere", "center": [0, 0, -50], "radius": 1 }"""));
        double[] costs = [.. Enumerable.Range(0, Width * Height).Select(i => Read(film, new BvhCostImage(), i)[0])];

        // Rays computed here differ in the last bit: now and then such a ray enters one more box.
        int same = costs.Index().Count(c => c.Item == tree.Cost(s_eye, Direction(c.Index, Width, Height), float.PositiveInfinity));
        Assert.InRange(same, Width * Height * 95 / 100, Width * Height);
        Assert.InRange(costs.Max(), 10, 500);
    }

    [Fact]
    public void The_same_bits_come_of_any_threads_tiles_and_streams_however_the_tree_is_traversed()
    {
        string terrain = Terrain(out _, out _);
        Scene[] scenes =
        [
            TestScenes.BuildEverything(),
            Scene(terrain + """, { "type": "instance", "of": { "type": "group", "shapes": [MESH, { "type": "sphere", "center": [0, 0, 1], "radius": 0.3 }] }, "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "rotate": 30, "translate": [1, 0, 0] }] }] }""".Replace("MESH", terrain, StringComparison.Ordinal), Width, Height, 100),
        ];
        foreach (Scene scene in scenes)
        {
            // Streams of less than 1,024 rays go through the tree in blocks; longer ones are sorted where they are not coherent.
            byte[] one = Trace(scene, new() { Threads = 1 }).Content();
            Assert.NotEqual(new AovFilm(new(scene.Render.Width, scene.Render.Height), AuxiliaryImage.Known.All).Content(), one);
            foreach ((int threads, int tile, int stream) in new[] { (3, 7, 1), (2, 1, 50), (4, 64, 65536), (2, 16, 1000) })
            {
                Assert.True(one.AsSpan().SequenceEqual(Trace(scene, new() { Threads = threads, TileSize = tile, StreamSize = stream }).Content()), $"{threads} threads, tiles of {tile}, streams of {stream}");
            }
        }
    }

    [Fact]
    public void The_film_is_the_same_beside_auxiliary_images_and_gives_them_its_counts()
    {
        Scene scene = TestScenes.BuildEverything();
        string alone = new RTracer(scene).Render().Film.ComputeHash();
        Film film = new(Width, Height);
        AovFilm aovs = new(film, AuxiliaryImage.Known.All);
        new FirstHitPass(scene).Render(aovs);
        new RTracer(scene, new() { Crop = new(3, 4, 20, 10) }).Render(film);
        Assert.Equal(0, Read(aovs, new SamplesImage(), 0)[0]);
        Assert.Equal(16, Read(aovs, new SamplesImage(), (5 * Width) + 4)[0]);
        Assert.Equal(film[4, 5].Luminance, Read(aovs, new LuminanceImage(), (5 * Width) + 4)[0]);
        Assert.NotEqual(0, film[4, 5].Luminance);
        Film whole = new(Width, Height);
        new RTracer(scene).Render(whole);
        Assert.Equal(alone, whole.ComputeHash());
    }

    [Fact]
    public void Memory_is_taken_only_for_what_is_asked_for()
    {
        Assert.Equal(0, AovFilm.Bytes([], 100, 100));
        Assert.Empty(new AovFilm(new(4, 4), [new SamplesImage(), new ErrorImage()]).Content());
        Assert.Equal(16 * (16 + 4), new AovFilm(new(4, 4), [new BvhCostImage()]).Content().Length);
        int Taken(AuxiliaryImage image) => new AovFilm(new(4, 4), [image]).Content().Length;
        Assert.All(AuxiliaryImage.Known.All, image => Assert.InRange(Taken(image), 0, AovFilm.Bytes([image], 4, 4)));
    }

    [Fact]
    public void What_is_too_large_or_no_number_does_not_spoil_the_sums()
    {
        AovFilm film = new(new(1, 1), [new NormalImage()]);
        film.Count(0, isHit: true);
        film.Add(0, new() { Primitive = 1, Normal = new(float.NaN, float.PositiveInfinity, -1e9f) }, isDescribed: true);
        Assert.Equal([0, Math.Pow(2, 47), -1e9], Read(film, new NormalImage(), 0));
    }

    [Fact]
    public void The_error_is_what_pictures_of_other_seeds_differ_by()
    {
        const int seeds = 64;
        Scene[] scenes = [.. Enumerable.Range(0, seeds).Select(seed => TestScenes.Build($$"""
            {
              "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0] },
              "render": { "integrator": "report", "width": 8, "height": 8, "samplesPerPixel": 64, "sampler": "independent", "seed": {{seed}} },
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": { "type": "diffuse" } },
                { "type": "sphere", "center": [3, 3, 3], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 40 } }]
            }
            """))];
        Film[] films = [.. scenes.Select(s => new RTracer(s).Render().Film)];
        double spread = 0, error = 0;
        float[] row = new float[24];
        for (int pixel = 0; pixel < 64; pixel++)
        {
            double[] light = [.. films.Select(f =>
            {
                f.ReadRow(pixel / 8, row);
                return (double)new Rgb(row[3 * (pixel % 8)], row[(3 * (pixel % 8)) + 1], row[(3 * (pixel % 8)) + 2]).Luminance;
            })];
            spread += light.Sum(l => Math.Pow(l - light.Average(), 2)) / (seeds - 1);
            error += films.Average(f => Math.Pow(Read(new(f, [new ErrorImage()]), new ErrorImage(), pixel)[0], 2));
        }

        Assert.InRange(error / spread, 0.9, 1.1);
    }

    private static int Middle => (Height / 2 * Width) + (Width / 2) + 1;

    private static Scene Scene(string shapes, int width = Width, int height = Height, int samples = 1) => TestScenes.Build($$"""
        {
          "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
          "render": { "integrator": "report", "width": {{width}}, "height": {{height}}, "samplesPerPixel": {{samples}}, "sampler": "regular", "shutter": [0, 1] },
          "shapes": [{{shapes}}]
        }
        """);

    private static AovFilm Trace(Scene scene, RenderOptions? options = null)
    {
        AovFilm film = new(new(scene.Render.Width, scene.Render.Height), AuxiliaryImage.Known.All);
        new FirstHitPass(scene, options).Render(film);
        return film;
    }

    private static double[] Read(AovFilm film, AuxiliaryImage kind, int pixel)
    {
        int channels = kind.Letters.Length;
        double[] row = new double[film.Width * channels];
        film.ReadRow(kind, pixel / film.Width, row);
        return row[(pixel % film.Width * channels)..][..channels];
    }

    // Through the middle of a pixel.
    private static Vector3 Direction(int pixel, int width, int height)
    {
        double scale = 2 * Math.Tan(20 * Math.PI / 180) / height;
        (double x, double y) = ((pixel % width) + 0.5 - (width / 2.0), (height / 2.0) - (pixel / width) - 0.5);
        return Vector3.Normalize(new((float)(x * scale), (float)(y * scale), -1));
    }

    private static void AssertClose(double expected, double actual) => Assert.Equal(expected, actual, 2e-5 * Math.Max(1, Math.Abs(expected)));

    private static string Terrain(out Vector3[] positions, out int[] indices)
    {
        const int n = 24;
        Random random = new(TestSettings.Seed);
        positions = [.. Enumerable.Range(0, (n + 1) * (n + 1)).Select(i => new Vector3((i % (n + 1) * 4f / n) - 2, (i / (n + 1) * 4f / n) - 2, random.NextSingle()))];
        indices = [.. Enumerable.Range(0, n * n).SelectMany(i => (int[])[Corner(i), Corner(i) + 1, Corner(i) + n + 2, Corner(i), Corner(i) + n + 2, Corner(i) + n + 1])];
        static int Corner(int cell) => (cell / n * (n + 1)) + (cell % n);
        string corners = string.Join(',', positions.Select(p => $"[{p.X:R},{p.Y:R},{p.Z:R}]"));
        return $$"""{ "type": "mesh", "positions": [{{corners}}], "triangles": [{{string.Join(',', indices.Chunk(3).Select(t => $"[{string.Join(',', t)}]"))}}] }""";
    }
}
