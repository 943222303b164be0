using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

public class ConvertTests
{
    private const string Xml = """
        <scene version="3.0.0">
          <sensor type="perspective"><float name="fov" value="40"/><film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="6"/></film></sensor>
          <shape type="cube"><transform name="to_world"><translate z="5"/></transform>
            <bsdf type="diffuse"><texture type="bitmap" name="reflectance"><string name="filename" value="p.png"/></texture></bsdf>
          </shape>
          <emitter type="constant"/>
        </scene>
        """;

    [Fact]
    public void A_converted_scene_makes_the_same_film_from_another_folder()
    {
        using TemporaryFolder folder = new();
        Write(folder);
        Directory.CreateDirectory(folder["out"]);
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of("convert", folder["scene.xml"], folder["out/scene.json"]));
        Assert.Contains("\"../p.png\"", File.ReadAllText(folder["out/scene.json"]), StringComparison.Ordinal);
        Assert.Equal(Pixel(folder["scene.xml"]), Pixel(folder["out/scene.json"]));
    }

    [Fact]
    public void Nothing_is_written_where_there_is_an_error()
    {
        using TemporaryFolder folder = new();
        Write(folder);
        File.Delete(folder["p.png"]);
        Assert.Equal(3, CliRun.Of("convert", folder["scene.xml"], folder["scene.json"], "--strict").Status);
        Assert.Equal(4, CliRun.Of("convert", folder["missing.xml"], folder["scene.json"]).Status);
        Assert.Equal(2, CliRun.Of("convert", folder["scene.xml"], folder["scene.txt"]).Status);
        Assert.False(File.Exists(folder["scene.json"]));
    }

    [Fact]
    public void A_scene_is_converted_with_other_values()
    {
        using TemporaryFolder folder = new();
        Write(folder);
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of("convert", folder["scene.xml"], folder["scene.json"], "--set", "camera.fieldOfView=12"));
        Assert.Contains("\"fieldOfView\": 12", File.ReadAllText(folder["scene.json"]), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"ambient\": 0.1", "report")]
    [InlineData("\"render\": { \"maxDiffuseDepth\": 2 }", "report")]
    [InlineData("\"ambient\": 0.1, \"render\": { \"integrator\": \"path\" }", null)]
    [InlineData("\"background\": 1", null)]
    public void A_scene_that_uses_what_only_the_report_has_names_its_integrator(string scene, string? integrator)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["a.json"], $"{{ \"lights\": [{{ \"type\": \"point\", \"position\": [0, 5, 0] }}], {scene} }}");
        Assert.Equal(0, CliRun.Of("convert", folder["a.json"], folder["b.json"]).Status);
        Assert.Equal(integrator is not null, File.ReadAllText(folder["b.json"]).Contains($"\"integrator\": \"{integrator}\"", StringComparison.Ordinal));
    }

    [Fact]
    public void Every_image_is_converted_into_every_kind_of_image()
    {
        using TemporaryFolder folder = new();
        Picture picture = new(3, 2, [.. Enumerable.Range(0, 18).Select(i => i / 16f)]);
        string[] kinds = ["png", "pfm", "exr", "hdr"];
        foreach (string kind in kinds)
        {
            ImageFile.Write(folder[$"a.{kind}"], picture, new() { BitDepth = 16 });
        }

        foreach (string from in kinds)
        {
            foreach (string to in kinds)
            {
                Assert.Equal(new CliRun(0, "", ""), CliRun.Of(["convert", folder[$"a.{from}"], folder[$"b.{to}"], .. to == "png" ? ["--bit-depth", "16", "--tonemap", "clamp"] : Array.Empty<string>()]));
                Picture clamped = ImageFile.Read(folder[$"a.{from}"]);
                double worst = ImageComparison.Compare(ImageFile.Read(folder[$"b.{to}"]), clamped).LargestDifference;
                Assert.True(worst <= (to == "png" ? (from == "png" ? 1e-5 : 0.0626) : to == "hdr" ? 0.005 : 0), $"{from} to {to}: {worst}");
            }
        }
    }

    [Fact]
    public void Images_are_converted_with_the_looks_and_size_that_are_asked_for()
    {
        using TemporaryFolder folder = new();
        ImageFile.Write(folder["a.pfm"], new Picture(4, 2, [.. Enumerable.Repeat(0.25f, 24)]));
        Assert.Equal(0, CliRun.Of("convert", folder["a.pfm"], folder["a.png"], "--exposure", "1", "--width", "2").Status);
        Picture small = ImageFile.Read(folder["a.png"]);
        Assert.Equal((2, 1), (small.Width, small.Height));
        Assert.Equal(0.5, small.Pixels[0], 0.01);
        Assert.Equal(0, CliRun.Of("convert", folder["a.pfm"], folder["a.exr"], "--exr-type", "half").Status);
        Assert.Equal(0, CliRun.Of("convert", folder["a.pfm"], folder["b.exr"]).Status);
        Assert.NotEqual(File.ReadAllBytes(folder["a.exr"]), File.ReadAllBytes(folder["b.exr"]));
    }

    [Fact]
    public void A_film_becomes_an_image_that_still_says_what_it_is_of()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["scene.json"], CliRun.Scene);
        Assert.Equal(0, CliRun.Of("render", folder["scene.json"], "-o", folder["a.rtfilm"], "-o", folder["a.pfm"], "--quiet").Status);
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of("convert", folder["a.rtfilm"], folder["b.pfm"]));
        Assert.Equal(File.ReadAllBytes(folder["a.pfm"]), File.ReadAllBytes(folder["b.pfm"]));
        Assert.Equal(0, CliRun.Of("convert", folder["a.rtfilm"], folder["b.png"]).Status);
        Assert.Equal(0, CliRun.Of("convert", folder["b.png"], folder["b.exr"]).Status);
        Assert.Equal(0, CliRun.Of("verify", folder["b.exr"]).Status);
    }

    [Fact]
    public void Layers_go_along_but_for_smaller_pictures()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["scene.json"], CliRun.Scene);
        Assert.Equal(0, CliRun.Of("render", folder["scene.json"], "-o", folder["a.exr"], "--aov", "depth,primitive,lights", "--quiet").Status);
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of("convert", folder["a.exr"], "-o", folder["b.exr"]));
        (byte[] from, byte[] to) = (File.ReadAllBytes(folder["a.exr"]), File.ReadAllBytes(folder["b.exr"]));
        Assert.Equal(ExrReader.ChannelNames(from), ExrReader.ChannelNames(to));
        Assert.All(ExrReader.ChannelNames(from), name => Assert.Equal(ExrReader.ReadChannel(from, name), ExrReader.ReadChannel(to, name)));

        CliRun small = CliRun.Of("convert", folder["a.exr"], folder["c.exr"], "--width", "8");
        Assert.Equal(0, small.Status);
        Assert.Contains("lacks the layers depth, light.background, light.unnamed, primitive of", small.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("a.png", "b.hdr", "--exposure 2", "--exposure has no effect: it is for PNG and JPEG files, and none is written")]
    [InlineData("a.png", "b.jpg", "--bit-depth 16", "--bit-depth has no effect: it is for PNG files, and none is written")]
    [InlineData("a.png", "c.png", "--exr-type half", "--exr-type has no effect: it is for OpenEXR files, and none is written")]
    [InlineData("a.png", "c.png", "--quality 50", "--quality has no effect: it is for JPEG files, and none is written")]
    public void Options_without_effect_are_reported(string from, string to, string options, string message)
    {
        using TemporaryFolder folder = new();
        ImageFile.Write(folder[from], new Picture(4, 2));
        Assert.Equal(new CliRun(0, "", $"raytracer: warning: {message}{Environment.NewLine}"), CliRun.Of(["convert", folder[from], folder[to], .. options.Split(' ')]));
    }

    [Fact]
    public void There_is_one_file_to_write()
    {
        Assert.Contains("where to?", CliRun.Of("convert", "a.png").Error, StringComparison.Ordinal);
        Assert.Contains("there is one file to write", CliRun.Of("convert", "a.png", "b.png", "-o", "c.png").Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(2, "can only be scaled down, not to 9×4", "a.pfm", "b.png", "--width", "9")]
    [InlineData(2, "is an image, and no scene can be made from it", "a.pfm", "b.json")]
    [InlineData(2, "images have no settings", "a.pfm", "b.png", "--set", "a=1")]
    [InlineData(2, "(did you mean '.png'?)", "a.pfm", "b.pgn")]
    [InlineData(4, "there is no such file", "c.pfm", "b.png")]
    [InlineData(4, "its first bytes are not those of a supported picture format", "text", "b.png")]
    public void What_cannot_be_converted_is_refused(int status, string message, string from, string to, params string[] more)
    {
        using TemporaryFolder folder = new();
        ImageFile.Write(folder["a.pfm"], new Picture(4, 2));
        File.WriteAllText(folder["text"], "Nothing to see");
        CliRun run = CliRun.Of(["convert", folder[from], folder[to], .. more]);
        Assert.Equal(status, run.Status);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(folder[to]));
    }

    private static void Write(TemporaryFolder folder)
    {
        File.WriteAllText(folder["scene.xml"], Xml);
        ImageFile.Write(folder["p.png"], new Picture(2, 1, [1, 0.5f, 0.25f, 0, 0, 1]));
    }

    private static string Pixel(string scene)
    {
        CliRun run = CliRun.Of("render", scene, "--pixel", "4,3");
        Assert.Equal(0, run.Status);
        return string.Concat(run.Output.Split('\n').Where(l => !l.Contains(scene, StringComparison.Ordinal)));
    }
}
