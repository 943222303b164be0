using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class AovFilesTests
{
    private static readonly Lazy<AovFilm> s_film = new(() =>
    {
        Scene scene = TestScenes.BuildEverything();
        Film film = new(scene.Render.Width, scene.Render.Height);
        AovFilm aovs = new(film, AuxiliaryImage.Known.All);
        new FirstHitPass(scene).Render(aovs);
        new RTracer(scene).Render(film);
        return aovs;
    });

    [Fact]
    public void Layers_survive_writing_and_reading_and_do_not_disturb_the_picture()
    {
        AovFilm film = s_film.Value;
        Picture beauty = TestPictures.Noise(film.Width, film.Height);
        foreach (ExrCompression compression in Enum.GetValues<ExrCompression>())
        {
            byte[] file = TestPictures.Bytes(s => ExrWriter.Write(s, beauty, ExrPixelType.Float, compression, layers: AovFiles.Layers(film)));
            TestPictures.AssertSameBits(beauty, ExrReader.Read(file));
            Assert.Equal(Numbers(new DepthImage(), 0), ExrReader.ReadChannel(file, "depth.Z"));
            Assert.Equal(Numbers(new NormalImage(), 0), ExrReader.ReadChannel(file, "normal.X"));
            Assert.Equal(Numbers(new NormalImage(), 2), ExrReader.ReadChannel(file, "normal.Z"));
            Assert.Equal(Numbers(new AlbedoImage(), 1), ExrReader.ReadChannel(file, "albedo.G"));
            Assert.Equal(Numbers(new UvImage(), 1), ExrReader.ReadChannel(file, "uv.V"));
            Assert.Equal(Numbers(new PrimitiveImage(), 0), ExrReader.ReadChannel(file, "primitive.Y"));
            Assert.Equal(Numbers(new BvhCostImage(), 0), ExrReader.ReadChannel(file, "bvhCost.Y"));
            Assert.All(ExrReader.ReadChannel(file, "samples.Y"), n => Assert.Equal(16, n));
            Assert.Throws<PictureException>(() => ExrReader.ReadChannel(file, "depth.Q"));
        }
    }

    [Fact]
    public void Whole_numbers_keep_all_their_digits_in_layers()
    {
        ExrLayerChannel layer = new("id.Y", ExrPixelType.Uint, (_, values) => values.Span[0] = uint.MaxValue - 2);
        byte[] file = TestPictures.Bytes(s => ExrWriter.Write(s, new Picture(1, 1), layers: [layer]));
        Assert.Equal([uint.MaxValue - 2], ExrReader.ReadChannel(file, "id.Y"));
    }

    [Theory]
    [InlineData("R")]
    [InlineData("")]
    [InlineData("a b")]
    [InlineData("tëxt.Y")]
    public void Names_that_OpenEXR_cannot_hold_or_has_already_are_refused(string name) => Assert.Throws<ArgumentException>(
        () => TestPictures.Bytes(s => ExrWriter.Write(s, new Picture(1, 1), layers: [new(name, ExrPixelType.Float, (_, _) => { })])));

    [ProgramFact("exrheader", "exrinfo")]
    public void Other_programs_find_the_layers()
    {
        using TemporaryFolder folder = new();
        ImageFile.Write(folder["a.exr"], TestPictures.Noise(48, 32), new() { ExrLayers = AovFiles.Layers(s_film.Value) });
        (int header, string list) = ProgramFactAttribute.Run("exrheader", folder["a.exr"]);
        Assert.Equal(0, header);

        // Its exit status is any number in OpenEXR 3.1.
        Assert.Contains("'depth.Z': float", ProgramFactAttribute.Run("exrinfo", "-v", "-s", folder["a.exr"]).Output, StringComparison.Ordinal);
        foreach (string name in new[] { "R", "depth.Z", "normal.X", "normal.Y", "normal.Z", "albedo.R", "albedo.G", "albedo.B", "uv.U", "uv.V", "bvhCost.Y" })
        {
            Assert.Contains($" {name}, {(name == "R" ? 16 : 32)}-bit floating-point", list, StringComparison.Ordinal);
        }

        Assert.Contains(" primitive.Y, 32-bit unsigned integer", list, StringComparison.Ordinal);
        Assert.Contains(" samples.Y, 32-bit unsigned integer", list, StringComparison.Ordinal);
    }

    [Fact]
    public void Pngs_hold_the_numbers_as_colours()
    {
        // 255 display values a channel.
        AssertShown(new NormalImage(), (p, c) => (0.5 * Number(new NormalImage(), p, c)) + 0.5);
        AssertShown(new UvImage(), (p, c) => c == 2 ? 0 : Number(new UvImage(), p, c) - Math.Floor(Number(new UvImage(), p, c)));
        AssertShown(new SamplesImage(), (_, _) => 1);
        double[] depths = [.. Numbers(new DepthImage(), 0).Where(double.IsFinite)];
        (double near, double far) = (depths.Min(), depths.Max());
        double Nearness(double d) => double.IsInfinity(d) ? 0 : ((1 / d) - (1 / far)) / ((1 / near) - (1 / far));
        AssertShown(new DepthImage(), (p, _) => Nearness(Number(new DepthImage(), p, 0)));
        string legend = FormattableString.Invariant($"{near:G6} (white) to {far:G6} (black) scene units");
        Assert.StartsWith(legend, new AovPicture(s_film.Value, new DepthImage()).Legend);
        float[] albedo = Shown(new AlbedoImage(), raw: false);
        Assert.All(albedo.Index(), a => Assert.Equal(Math.Min(1, Number(new AlbedoImage(), a.Index / 3, a.Index % 3)), a.Item, 0.01));
    }

    [Fact]
    public void False_colours_of_the_light_are_as_far_apart_as_exposures_are()
    {
        LuminanceImage image = new();
        NumberRange range = new(0, 64, 8);
        (double R, double G, double B) Shown(double luminance) => image.Show([luminance], range);
        Assert.Equal(Shown(8), Shown(64));
        Assert.Equal((0, 0, 0), Shown(0));
        Assert.Equal((0, 0, 0), Shown(8 / 1024d));
        Assert.Equal((0.85, 0.2, 0.25), Shown(8 / 32d), (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) + Math.Abs(a.Item3 - b.Item3) < 1e-5);
        double[] greens = [.. Enumerable.Range(0, 11).Select(i => Shown(8 / 1024d * (1 << i)).G)];
        Assert.Equal(greens.Order(), greens);
        Assert.Equal("0.0078125 or less to 8 and more, evenly in 10 doublings: black, violet, red, orange, white; at most 64", image.Legend(range));
    }

    [Fact]
    public void Every_primitive_has_a_colour_of_its_own_and_nothing_is_black()
    {
        float[] shown = Shown(new PrimitiveImage(), raw: true);
        double[] numbers = Numbers(new PrimitiveImage(), 0);
        (double Number, string Color)[] pairs = [.. numbers.Select((n, i) => (n, $"{shown[3 * i]} {shown[(3 * i) + 1]} {shown[(3 * i) + 2]}")).Distinct()];
        Assert.Equal(numbers.Distinct().Count(), pairs.Length);
        Assert.Equal(pairs.Length, pairs.Select(p => p.Color).Distinct().Count());
        Assert.Contains((0, "0 0 0"), pairs);
    }

    [Fact]
    public void Costs_are_warmer_the_higher_they_are_and_the_legend_tells_the_scale()
    {
        Scene scene = TestScenes.Build("""
            { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0] }, "render": { "integrator": "report", "width": 16, "height": 16, "samplesPerPixel": 1, "sampler": "regular" },
              "shapes": [{ "type": "mesh", "positions": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "triangles": [[0, 1, 2], [0, 2, 3]] }] }
            """);
        AovFilm film = new(new(16, 16), [new BvhCostImage()]);
        new FirstHitPass(scene).Render(film);
        AovPicture picture = new(film, new BvhCostImage());
        Assert.Equal("0 to 3 and more nodes and triangles per ray: black, violet, red, orange, white; at most 3", picture.Legend);
        float[] row = new float[48];
        picture.ReadRow(8, row);
        Assert.Equal((float)SrgbCurve.Decode(HeatMap.Color(1 / 3.0).R), row[0]);
        Assert.Equal((1, 1), (row[24], row[25]));
        double[] light = [.. Enumerable.Range(0, 101).Select(i => (double)(HeatMap.Color(i / 100.0) is var c ? (0.2126 * c.R) + (0.7152 * c.G) + (0.0722 * c.B) : 0))];
        Assert.All(light.Zip(light.Skip(1)), p => Assert.True(p.Second > p.First));
        Assert.Equal(HeatMap.Color(0), HeatMap.Color(double.NaN));
        Assert.Equal(HeatMap.Color(1), HeatMap.Color(7));
    }

    [Fact]
    public void Files_stand_beside_their_picture()
    {
        Assert.Equal(Path.Combine("a.b", "out.bvhCost.png"), AovFiles.Beside(Path.Combine("a.b", "out.png"), "bvhCost"));
        string[] names = ["depth", "normal", "albedo", "uv", "motion", "primitive", "cryptoObject", "cryptoMaterial", "bvhCost", "luminance", "samples", "error"];
        Assert.Equal(names, AuxiliaryImage.Known.All.Select(i => i.Name));
    }

    private static double Number(AuxiliaryImage kind, int pixel, int channel) => Numbers(kind, channel)[pixel];

    private static double[] Numbers(AuxiliaryImage kind, int channel)
    {
        AovFilm film = s_film.Value;
        int channels = kind.Letters.Length;
        double[] row = new double[film.Width * channels];
        List<double> all = [];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(kind, y, row);
            all.AddRange(Enumerable.Range(0, film.Width).Select(x => (double)(float)row[(x * channels) + channel]));
        }

        return [.. all];
    }

    private static float[] Shown(AuxiliaryImage kind, bool raw)
    {
        (IImageRows image, _) = AovFiles.Rows("a.png", s_film.Value, kind);
        return PngReader.Read(TestPictures.Bytes(s => PngWriter.Write(s, image)), raw).Pixels;
    }

    private static void AssertShown(AuxiliaryImage kind, Func<int, int, double> display)
    {
        float[] shown = Shown(kind, raw: true);
        Assert.Equal(3 * s_film.Value.Width * s_film.Value.Height, shown.Length);
        Assert.All(shown.Index(), s => Assert.Equal(display(s.Index / 3, s.Index % 3), s.Item, 0.5001 / 255));
    }
}
