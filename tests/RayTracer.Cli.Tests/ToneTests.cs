using System.Globalization;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

/// <summary>Tone map and exposure, by default and as scenes and options say.</summary>
public sealed class ToneTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("path", "soft")]
    [InlineData("direct", "soft")]
    [InlineData("report", "clamp")]
    [InlineData("ao", "clamp")]
    public void Each_integrator_has_its_tone_map_unless_the_scene_or_an_option_names_one(string integrator, string map)
    {
        string scene = Lit($"\"integrator\": \"{integrator}\"", "[4, 2, 0]");
        byte[] expected = Pixels(scene, "--tonemap", map);
        Assert.Equal(expected, Pixels(scene));
        string named = Lit($"\"integrator\": \"{integrator}\", \"toneMap\": \"agx\"", "[4, 2, 0]");
        Assert.Equal(Pixels(scene, "--tonemap", "agx"), Pixels(named));
        Assert.Equal(expected, Pixels(named, "--tonemap", map));
    }

    [Fact]
    public void A_lamp_of_orange_light_is_orange()
    {
        string scene = Lit("", "[4, 2, 0]");
        Picture seen = Seen(scene);
        (float red, float green, float blue) = (seen.Pixels[0], seen.Pixels[1], seen.Pixels[2]);
        Assert.InRange(green / red, 0.35, 0.65);
        Assert.InRange(blue / red, 0, 0.2);
    }

    [Fact]
    public void A_strong_lamp_makes_no_white_sheet()
    {
        byte[] limited = Pixels(Lit("", "[400, 200, 100]"));
        Assert.Equal(limited, Pixels(Lit("", "[400, 200, 100]"), "--exposure", "limited"));
        Assert.Equal(limited, Pixels(Lit("", "[800, 400, 200]")));
        Assert.NotEqual(limited, Pixels(Lit("", "[400, 200, 100]"), "--exposure", "0"));
        byte[] mild = Pixels(Lit("", "[0.5, 0.2, 0.1]"));
        Assert.Equal(mild, Pixels(Lit("", "[0.5, 0.2, 0.1]"), "--exposure", "0"));
    }

    [Theory]
    [InlineData("\"exposure\": 1.5", "--exposure", "1.5")]
    [InlineData("\"exposure\": \"auto\"", "--exposure", "auto")]
    public void A_scene_says_what_the_option_says(string render, params string[] option)
    {
        byte[] expected = Pixels(Lit("", "[0.3, 0.2, 0.1]"), option);
        string scene = Lit(render, "[0.3, 0.2, 0.1]");
        Assert.Equal(expected, Pixels(scene));
        Assert.NotEqual(expected, Pixels(scene, "--exposure", "0"));
    }

    [Fact]
    public void Light_a_thousandfold_gives_the_same_picture_with_automatic_exposure()
    {
        byte[] dim = Pixels(Lit("", "[0.5, 0.25, 0.125]"), "--exposure", "auto");
        Assert.Equal(dim, Pixels(Lit("", "[512, 256, 128]"), "--exposure", "auto"));
    }

    [Fact]
    public void Automatic_exposure_is_the_same_over_threads_and_parts_and_is_kept_in_the_picture()
    {
        string scene = Lit("\"exposure\": \"auto\"", "[3, 2, 1]", background: "[0.1, 0.2, 0.3]");
        Render(scene, "-o", _folder["one.png"], "--threads", "1", "-o", _folder["a.exr"]);
        Render(scene, "-o", _folder["three.png"], "--threads", "3");
        Render(scene, "-o", _folder["1.rtfilm"], "--part", "1/2");
        Render(scene, "-o", _folder["2.rtfilm"], "--part", "2/2", "--exposure", "0");
        Assert.Equal(0, CliRun.Of("merge", _folder["1.rtfilm"], _folder["2.rtfilm"], "-o", _folder["merged.png"], "-o", _folder["all.rtfilm"]).Status);
        Assert.Equal(0, CliRun.Of("convert", _folder["all.rtfilm"], _folder["converted.png"]).Status);
        float[] expected = ImageFile.Read(_folder["one.png"]).Pixels;
        Assert.All(new[] { "three", "merged", "converted" }, name => Assert.Equal(expected, ImageFile.Read(_folder[$"{name}.png"]).Pixels));
        string tone = ImageFile.ReadText(_folder["one.png"]).First(t => t.Key == PictureTone.Key).Value;
        Assert.StartsWith("soft -", tone, StringComparison.Ordinal);
        Assert.Equal(tone, ImageFile.ReadText(_folder["a.exr"]).First(t => t.Key == PictureTone.Key).Value);
    }

    [Fact]
    public void An_image_is_converted_as_its_scene_is_shown_and_one_that_was_shown_stays_as_it_is()
    {
        string scene = Lit("\"exposure\": 1", "[1, 0.5, 0.2]");
        Render(scene, "-o", _folder["a.png"], "-o", _folder["a.exr"]);
        Assert.Equal(0, CliRun.Of("convert", _folder["a.exr"], _folder["b.png"]).Status);
        Assert.Equal(0, CliRun.Of("convert", _folder["a.png"], _folder["c.png"]).Status);
        float[] expected = ImageFile.Read(_folder["a.png"]).Pixels;
        Assert.Equal(expected, ImageFile.Read(_folder["b.png"]).Pixels);
        Assert.Equal(expected, ImageFile.Read(_folder["c.png"]).Pixels);
    }

    [Fact]
    public void The_film_and_what_it_may_be_resumed_with_do_not_depend_on_the_tone()
    {
        string scene = Lit("", "[1, 1, 1]");
        Render(scene, "-o", _folder["a.rtfilm"]);
        Render(Lit("\"toneMap\": \"aces\", \"exposure\": \"auto\"", "[1, 1, 1]"), "-o", _folder["b.rtfilm"]);
        Assert.Equal(FilmFile.ReadHeader(_folder["a.rtfilm"]).Content, FilmFile.ReadHeader(_folder["b.rtfilm"]).Content);
        Assert.Equal(FilmFile.Read(_folder["a.rtfilm"]).Film.ComputeHash(), FilmFile.Read(_folder["b.rtfilm"]).Film.ComputeHash());
    }

    [Fact]
    public void All_frames_have_the_exposure_of_the_first_one_in_whatever_part()
    {
        string scene = Lit("\"exposure\": \"auto\", \"framesPerSecond\": 1", "[1, 1, 1]", animation: true);
        Render(scene, "-o", _folder["f#.png"], "--frames", "0..2");
        Render(scene, "-o", _folder["g#.png"], "--frames", "0..2", "--part", "2/3");
        string[] tones = [.. new[] { "f0", "f1", "f2", "g1" }.Select(
            f => ImageFile.ReadText(_folder[$"{f}.png"]).First(t => t.Key == PictureTone.Key).Value)];
        Assert.All(tones, t => Assert.Equal(tones[0], t));
        Assert.True(Level("f0") < Level("f1") && Level("f1") < Level("f2"));
        Render(scene, "-o", _folder["one.png"], "--frames", "2");
        Assert.InRange(Level("one"), 0.01f, Level("f2") - 0.05f);
        float Level(string name) => ImageFile.Read(_folder[$"{name}.png"]).Pixels[0];
    }

    [Fact]
    public void A_frame_is_rendered_again_where_it_was_shown_by_another_tone_map()
    {
        string scene = Lit("\"toneMap\": \"agx\"", "[1, 1, 1]");
        Render(scene, "-o", _folder["f#.png"], "--frames", "0..0");
        byte[] shown = File.ReadAllBytes(_folder["f0.png"]);
        Render(Lit("", "[1, 1, 1]"), "-o", _folder["f#.png"], "--frames", "0..0");
        Assert.NotEqual(shown, File.ReadAllBytes(_folder["f0.png"]));
    }

    [Fact]
    public void A_sheet_has_one_exposure()
    {
        string scene = Lit("\"exposure\": \"auto\"", "[1, 1, 1]");
        Assert.Equal(0, CliRun.Of(
            "sweep", scene, "--set", "shapes[0].material.multiplier=0.5,1", "-o", _folder["sheet.pfm"], "--quiet").Status);
        float[] shown = ImageFile.Read(_folder["sheet.pfm"]).Pixels;
        Assert.Contains(shown, v => Math.Abs(v - 0.25f) < 0.01f);
        Assert.Contains(shown, v => Math.Abs(v - 0.5f) < 0.01f);
    }

    private static void Render(string scene, params string[] words) => Assert.Equal(0, CliRun.Of(["render", scene, "--quiet", .. words]).Status);

    private Picture Seen(string scene, params string[] words)
    {
        Render(scene, ["-o", _folder["seen.png"], .. words]);
        return ImageFile.Read(_folder["seen.png"]);
    }

    private byte[] Pixels(string scene, params string[] words) => [.. Seen(scene, words).Pixels.Select(v => (byte)Math.Round(255 * v))];

    // A surface that fills the picture and shines, or the background alone.
    private string Lit(string render, string light, string background = "[0, 0, 0]", bool animation = false)
    {
        string path = _folder[$"{Guid.NewGuid():N}.json"];
        string frames = animation ? ", \"animation\": [{ \"property\": \"background\", \"keys\": [{ \"time\": 0, \"value\": [0.1, 0.1, 0.1] }, { \"time\": 2, \"value\": [0.3, 0.3, 0.3] }] }]" : "";
        string shapes = background == "[0, 0, 0]" && !animation
            ? $$"""{ "type": "sphere", "center": [0, 0, -3], "radius": 2.9, "material": { "type": "luminaire", "color": {{light}} } }"""
            : $$"""{ "type": "sphere", "center": [1, 0, -3], "radius": 0.7, "material": { "type": "luminaire", "color": {{light}} } }""";
        File.WriteAllText(path, string.Create(CultureInfo.InvariantCulture, $$"""
            { "camera": { "position": [0, 0, 0.5], "lookAt": [0, 0, 0], "fieldOfView": 20 },
              "render": { "width": 8, "height": 6, "samplesPerPixel": 4{{(render.Length > 0 ? ", " : "")}}{{render}} },
              "background": {{background}}, "shapes": [{{shapes}}]{{frames}} }
            """));
        return path;
    }
}
