using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

public sealed class ComposeTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public ComposeTests()
    {
        _scene = _folder["scene.json"];
        WriteScene(30);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Layers_of_light_are_layers_of_exr_and_files_beside_other_formats()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.exr"], "-o", _folder["a.pfm"], "-o", _folder["a.png"], "--aov", "direct,depth,lights", "--denoise", "--quiet");
        Assert.Equal((0, ""), (run.Status, run.Error));
        string[] names = ["direct", "light.big_lamp", "light.background", "light.ambient"];
        foreach (string name in names)
        {
            float[] beside = ImageFile.Read(_folder[$"a.{name}.pfm"]).Pixels;
            Assert.Equal(ExrReader.ReadChannel(File.ReadAllBytes(_folder["a.exr"]), $"{name}.G"), beside.Where((_, i) => i % 3 == 1).Select(v => (double)v));
            Assert.Equal(name, ImageFile.ReadText(_folder[$"a.{name}.png"]).ToDictionary()["Layer"]);
        }

        Assert.Equal(3 + (2 * (names.Length + 2)) + 1, Directory.GetFiles(_folder.Path).Length);
    }

    [Fact]
    public void A_lamp_balanced_after_rendering_is_a_lamp_of_that_strength()
    {
        CliRun.Of("render", _scene, "-o", _folder["a.exr"], "--aov", "lights", "--quiet");
        CliRun run = CliRun.Of("compose", _folder["a.exr"], "--light", "big lamp=0.5", "--light", "background=1", "-o", _folder["b.pfm"]);
        Assert.Equal((0, "", ""), (run.Status, run.Output, run.Error));
        WriteScene(15);
        CliRun.Of("render", _scene, "-o", _folder["c.pfm"], "--quiet");
        AssertClose(ImageFile.Read(_folder["c.pfm"]), ImageFile.Read(_folder["b.pfm"]));

        // Channel by channel, and all that is not named.
        CliRun.Of("compose", _folder["a.exr"], "--light", "big_lamp=0,2,1", "--others", "0", "-o", _folder["d.pfm"]);
        byte[] exr = File.ReadAllBytes(_folder["a.exr"]);
        float[] composed = ImageFile.Read(_folder["d.pfm"]).Pixels;
        Assert.All(composed.Where((_, i) => i % 3 == 0), red => Assert.Equal(0, red));
        Assert.Equal(ExrReader.ReadChannel(exr, "light.big_lamp.G").Select(g => (float)(2 * g)), composed.Where((_, i) => i % 3 == 1));
    }

    [Fact]
    public void What_is_wrong_is_reported_with_the_nearest_name()
    {
        CliRun.Of("render", _scene, "-o", _folder["a.exr"], "-o", _folder["a.png"], "--aov", "lights", "--quiet");
        CliRun.Of("render", _scene, "-o", _folder["plain.exr"], "--aov", "direct", "--quiet");
        string a = _folder["a.exr"];
        AssertRefused($"--light big_lmap=2: '{a}' has no light \"big_lmap\" (did you mean \"big_lamp\"?), but ambient, background, big_lamp", 2, a, "--light", "big_lmap=2", "-o", _folder["b.png"]);
        AssertRefused("--light big_lamp: expected NAME=X or NAME=R,G,B", 2, a, "--light", "big_lamp", "-o", _folder["b.png"]);
        AssertRefused("--light big_lamp=1,2: expected one number or three, not 2", 2, a, "--light", "big_lamp=1,2", "-o", _folder["b.png"]);
        AssertRefused("--light big_lamp=-1: expected a number from 0 to 1000000, not \"-1\"", 2, a, "--light", "big_lamp=-1", "-o", _folder["b.png"]);
        AssertRefused("--light big_lamp=nan: expected a number from 0 to 1000000, not \"nan\"", 2, a, "--light", "big_lamp=nan", "-o", _folder["b.png"]);
        AssertRefused("--light big lamp=3: the light \"big_lamp\" is given twice", 2, a, "--light", "big_lamp=1", "--light", "big lamp=3", "-o", _folder["b.png"]);
        AssertRefused($"where to? Give -o FILE. The lights of '{a}' are ambient, background, big_lamp", 2, a, "--light", "big_lamp=1");
        Assert.Equal("ambient background big_lamp", CliRun.Of("compose", a).Output.ReplaceLineEndings(" ").Trim());
        AssertRefused("it is not an OpenEXR file, and only those have layers of lights", 4, _folder["a.png"], "-o", _folder["b.png"]);
        AssertRefused("it has no layers of lights", 4, _folder["plain.exr"], "-o", _folder["b.png"]);
        AssertRefused("no-such.exr", 4, _folder["no-such.exr"], "-o", _folder["b.png"]);
        CliRun normals = CliRun.Of("render", _scene, "-o", _folder["b.exr"], "--integrator", "normals", "--aov", "lights", "--quiet");
        Assert.Contains("--aov: layers of light: only the report, path, direct and volPath integrators write them, and the scene's is normals: choose another --integrator", normals.Error, StringComparison.Ordinal);
        Assert.Equal(2, normals.Status);
        Assert.False(File.Exists(_folder["b.png"]) || File.Exists(_folder["b.exr"]));
    }

    [Fact]
    public void Layers_that_are_not_all_of_the_picture_are_warned_of()
    {
        Picture grey = new(2, 1, [1, 1, 1, 2, 2, 2]);
        ExrLayerChannel[] layers = [.. "RGB".Select(c => new ExrLayerChannel($"light.key.{c}", ExrPixelType.Float, (_, values) => values.Span.Fill(1)))];
        ImageFile.Write(_folder["a.exr"], grey, new() { ExrLayers = layers });
        CliRun run = CliRun.Of("compose", _folder["a.exr"], "-o", _folder["b.pfm"]);
        Assert.Equal(0, run.Status);
        Assert.Contains("do not add up to its picture: the difference is 33.3", run.Error, StringComparison.Ordinal);
        Assert.Equal([1, 1, 1, 1, 1, 1], ImageFile.Read(_folder["b.pfm"]).Pixels);
    }

    private static void AssertRefused(string message, int status, params string[] words)
    {
        CliRun run = CliRun.Of(["compose", .. words]);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Equal(status, run.Status);
    }

    private static void AssertClose(Picture expected, Picture actual)
    {
        for (int i = 0; i < expected.Pixels.Length; i++)
        {
            Assert.Equal(expected.Pixels[i], actual.Pixels[i], 2e-6f * Math.Max(1, expected.Pixels[i]));
        }
    }

    private void WriteScene(int multiplier) => File.WriteAllText(_scene, CliRun.Scene
        .Replace("\"background\"", "\"ambient\": [0.1, 0.1, 0.1], \"background\"", StringComparison.Ordinal)
        .Replace("\"center\": [2, 4, 1]", "\"name\": \"big lamp\", \"center\": [2, 4, 1]", StringComparison.Ordinal)
        .Replace("\"multiplier\": 30", $"\"multiplier\": {multiplier}", StringComparison.Ordinal));
}
