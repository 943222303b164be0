using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

/// <summary><c>--transparent</c>.</summary>
public sealed class TransparentTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public TransparentTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene.Replace("\"report\"", "\"path\"", StringComparison.Ordinal));
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("8")]
    [InlineData("16")]
    public void A_png_has_straight_colours_and_an_exr_premultiplied_ones(string depth)
    {
        (string png, string exr, string file) = (_folder["a.png"], _folder["a.exr"], _folder["a.rtfilm"]);
        CliRun.Fine("render", _scene, "--transparent", "--tonemap", "clamp", "--bit-depth", depth, "--exr-type", "float", "-o", png, "-o", exr, "-o", file, "--quiet");
        Film film = FilmFile.Read(file).Film;
        (Picture straight, Picture alpha) = (ImageFile.Read(png), ImageFile.DecodeAlpha(File.ReadAllBytes(png))!);
        Picture premultiplied = ImageFile.Read(exr);
        ExrLayerChannel a = Assert.Single(ImageFile.ReadAll(exr).Layers);
        Assert.Equal(("A", ExrPixelType.Float), (a.Name, a.Type));
        float step = depth == "8" ? 1f / 255 : 1f / 65535;
        double[] row = new double[film.Width];
        int between = 0;
        for (int y = 0; y < film.Height; y++)
        {
            a.ReadRow(y, row);
            for (int x = 0; x < film.Width; x++)
            {
                float seen = film.Alpha(x, y);
                between += seen is > 0 and < 1 ? 1 : 0;
                Rgb light = film.Mean(x, y) + (film.Backdrop(x, y) * -1);
                Assert.Equal(light, At(premultiplied, x, y));
                Assert.Equal(seen, row[x]);
                Assert.Equal(seen, At(alpha, x, y).R, step);
                float expected = seen > 0 ? float.Clamp(light.G / seen, 0, 1) : 0;
                Assert.Equal(expected, At(straight, x, y).G, 3 * step);
            }
        }

        Assert.InRange(between, 5, 200);
        Assert.Equal((0f, 1f), (film.Alpha(0, 0), film.Alpha(12, 15)));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Parts_and_resumed_films_keep_it(bool catchesShadows)
    {
        CatchShadows(catchesShadows);
        string whole = CliRun.FilmHash("render", _scene, "--spp", "8", "--transparent", "-o", _folder["whole.png"], "--json", "--quiet");
        Assert.NotEqual(whole, CliRun.FilmHash("render", _scene, "--spp", "8", "--json", "--quiet"));
        CliRun.Fine("verify", _folder["whole.png"]);
        CliRun.Fine("render", _scene, "--spp", "8", "--part", "1/2", "--transparent", "-o", _folder["a.rtfilm"], "--quiet");
        CliRun.Fine("render", _scene, "--spp", "8", "--part", "2/2", "--transparent", "-o", _folder["b.exr"], "--exr-film", "--quiet");
        Assert.Equal(whole, CliRun.FilmHash("merge", _folder["b.exr"], _folder["a.rtfilm"], "--transparent", "-o", _folder["merged.png"], "--json"));
        AssertSame("whole.png", "merged.png");

        CliRun.Fine("render", _scene, "--spp", "3", "--transparent", "-o", _folder["c.exr"], "--exr-film", "--quiet");
        CliRun.Fine("resume", _folder["c.exr"], "--spp", "8", "--transparent", "-o", _folder["resumed.png"], "--quiet");
        Assert.Equal(whole, CarriedFilm.Read(_folder["c.exr"]).Film.ComputeHash());
        Assert.Equal(["A"], ImageFile.ReadAll(_folder["c.exr"]).Layers.Select(l => l.Name).Where(n => !FilmExr.IsOfFilm(n)));
        AssertSame("whole.png", "resumed.png");
        CliRun.Fine("verify", _folder["c.exr"]);
        CliRun.Fine("resume", _folder["c.exr"], "--spp", "8", "-o", _folder["opaque.png"], "--quiet");
        Assert.Null(ImageFile.DecodeAlpha(File.ReadAllBytes(_folder["opaque.png"])));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_denoised_picture_has_the_alpha_of_its_film(bool catchesShadows)
    {
        CatchShadows(catchesShadows);
        CliRun.Fine("render", _scene, "--transparent", "--denoise", "-o", _folder["a.png"], "-o", _folder["a.rtfilm"], "--quiet");
        CliRun.Fine("denoise", _folder["a.rtfilm"], "--transparent", "-o", _folder["b.png"]);
        Picture expected = Alpha("a.png");
        Assert.Equal(expected.Pixels, Alpha("a.denoised.png").Pixels);
        Assert.Equal(expected.Pixels, Alpha("b.png").Pixels);
        TestPictures.AssertSameBits(ImageFile.Read(_folder["a.denoised.png"]), ImageFile.Read(_folder["b.png"]));
    }

    // The film's own noise of the catcher is not left behind where the denoised picture has none.
    [Fact]
    public void A_denoised_picture_shows_nothing_of_a_shadow_catcher_but_its_shadow()
    {
        CatchShadows(true);
        CliRun.Fine("render", _scene, "--transparent", "--halves", "-o", _folder["a.rtfilm"], "--quiet");
        CliRun.Fine("denoise", _folder["a.rtfilm"], "--transparent", "-o", _folder["a.exr"]);
        Picture denoised = ImageFile.Read(_folder["a.exr"]);
        Assert.All(Enumerable.Range(0, denoised.Width), x => Assert.InRange(At(denoised, x, denoised.Height - 1).G, -0.001f, 0.02f));
        Assert.InRange(At(denoised, denoised.Width / 2, denoised.Height / 2).G, 0.05f, 10);
    }

    [Fact]
    public void What_cannot_be_transparent_is_refused_with_the_reason()
    {
        CliRun.Refused(2, $"--transparent: {_folder["a.jpg"]}, a JPEG picture, has no alpha: write .png or .exr", "render", _scene, "--transparent", "-o", _folder["a.jpg"]);
        CliRun.Refused(2, "a.pfm, a PFM picture, has no alpha", "render", _scene, "--transparent", "-o", _folder["a.png"], "-o", _folder["a.pfm"]);
        CliRun.Refused(2, "an animated PNG has no alpha", "render", _scene, "--transparent", "--frames", "0..1", "-o", _folder["a.apng"]);
        CliRun.Fine("render", _scene, "-o", _folder["plain.rtfilm"], "-o", _folder["plain.png"], "--quiet");
        string reason = $"'{_folder["plain.rtfilm"]}' does not know which of its light is from behind everything: render it from scratch with --transparent";
        CliRun.Refused(4, reason, "resume", _folder["plain.rtfilm"], "--spp", "8", "--transparent", "-o", _folder["b.png"]);
        CliRun.Refused(4, reason, "merge", _folder["plain.rtfilm"], "--transparent", "-o", _folder["b.png"]);
        CliRun.Refused(4, reason, "denoise", _folder["plain.rtfilm"], "--transparent", "-o", _folder["b.png"]);
        CliRun.Refused(2, "--transparent is for films", "denoise", _folder["plain.png"], "--transparent", "-o", _folder["b.png"]);
    }

    private void CatchShadows(bool whether)
    {
        const string floor = """{ "type": "diffuse", "color": { "type": "checker" } }""";
        string scene = File.ReadAllText(_scene);
        Assert.Contains(floor, scene, StringComparison.Ordinal);
        File.WriteAllText(_scene, whether ? scene.Replace(floor, $$"""{ "type": "shadowCatcher", "material": {{floor}} }""", StringComparison.Ordinal) : scene);
    }

    private static Rgb At(Picture picture, int x, int y)
    {
        int red = 3 * ((y * picture.Width) + x);
        return new(picture.Pixels[red], picture.Pixels[red + 1], picture.Pixels[red + 2]);
    }

    private Picture Alpha(string name) => ImageFile.DecodeAlpha(File.ReadAllBytes(_folder[name]))!;

    private void AssertSame(string expected, string actual)
    {
        TestPictures.AssertSameBits(ImageFile.Read(_folder[expected]), ImageFile.Read(_folder[actual]));
        Assert.Equal(Alpha(expected).Pixels, Alpha(actual).Pixels);
    }
}
