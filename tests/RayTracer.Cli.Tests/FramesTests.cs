using System.Buffers.Binary;
using System.Text;
using System.Text.Json;
using RayTracer.Cli;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

/// <summary><c>render --frames</c>.</summary>
public sealed class FramesTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public FramesTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, Animated("[0, 1, 5]"));
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Frames_get_files_of_their_own_and_those_that_are_there_stay()
    {
        string[] command = ["render", _scene, "--spp", "1", "--frames", "0..4:2", "-o", _folder["f-###.png"]];
        Assert.Equal(0, CliRun.Of(command).Status);
        Assert.Equal(["f-000.png", "f-002.png", "f-004.png"], Directory.GetFiles(Path.GetDirectoryName(_scene)!, "*.png").Select(Path.GetFileName).Order());

        byte[] kept = File.ReadAllBytes(_folder["f-000.png"]);
        File.Delete(_folder["f-002.png"]);
        File.WriteAllText(_folder["f-004.png"], "something else");
        CliRun again = CliRun.Of([.. command, "--threads", "1"]);
        Assert.Equal(0, again.Status);
        Assert.Equal(["exists already", "f-002.png", "f-004.png"], again.Output.TrimEnd().Split('\n').Select(l => l.Contains("exists", StringComparison.Ordinal) ? "exists already" : l[^9..]));
        Assert.Equal(kept, File.ReadAllBytes(_folder["f-000.png"]));
        Assert.Equal(0, CliRun.Of("verify", _folder["f-002.png"]).Status);

        // Frame 0 is the same as before in this scene, frame 2 is not; and another option is another picture.
        File.WriteAllText(_scene, Animated("[0, 1, 6]"));
        Assert.Equal([false, true, true], Rendered(CliRun.Of([.. command, "--json"])));
        Assert.Equal([true, true, true], Rendered(CliRun.Of([.. command, "--json", "--exposure", "1"])));
    }

    [Theory]
    [InlineData("f-#.png")]
    [InlineData("f-#.rtfilm")]
    public void Frames_of_other_samples_are_rendered_again(string files)
    {
        string[] command = ["render", _scene, "--frames", "0..1", "-o", _folder[files], "--json"];
        Assert.Equal([true, true], Rendered(CliRun.Of(command)));
        Assert.Equal([false, false], Rendered(CliRun.Of(command)));
        File.WriteAllText(_scene, Animated("[0, 1, 5]").Replace("\"samplesPerPixel\": 4", "\"samplesPerPixel\": 9", StringComparison.Ordinal));
        Assert.Equal([true, true], Rendered(CliRun.Of(command)));
        Assert.Equal([true, true], Rendered(CliRun.Of([.. command, "--spp", "5"])));
    }

    [Theory]
    [InlineData("f#.jpg")]
    [InlineData("f#.exr")]
    [InlineData("f#.rtfilm")]
    public void Damaged_frames_are_rendered_again(string files)
    {
        string[] command = ["render", _scene, "--spp", "1", "--frames", "0..1", "-o", _folder[files], "--json"];
        Assert.Equal([true, true], Rendered(CliRun.Of(command)));
        string first = _folder[FrameRange.Name(files, 0)];
        byte[] whole = File.ReadAllBytes(first);
        File.WriteAllBytes(first, FilmFile.IsNamed(files) ? [.. whole[..^50], (byte)(whole[^50] ^ 1), .. whole[^49..]] : whole[..^20]);
        Assert.Equal([true, false], Rendered(CliRun.Of(command)));
        Assert.Equal(whole, File.ReadAllBytes(first));
    }

    [Fact]
    public void Frames_stay_whatever_scene_and_files_are_called_and_in_whatever_order()
    {
        string other = Path.Combine(_folder.Path, ".", "scene.json");
        Assert.Equal([true, true], Rendered(CliRun.Of("render", _scene, "--frames", "0..1", "-o", _folder["f#.png"], "-o", _folder["f#.exr"], "--exposure", "1", "--spp", "1", "--json")));
        Assert.Equal([false, false], Rendered(CliRun.Of("render", "--spp", "1", "--exposure", "1.0", "--tonemap", "clamp", other, "--frames", "0..1", "-o", Path.Combine(_folder.Path, ".", "f#.png"), "--json")));
        Assert.Equal([true, true], Rendered(CliRun.Of("render", _scene, "--frames", "0..1", "-o", _folder["f#.png"], "--spp", "1", "--json")));
    }

    [Fact]
    public void A_missing_layer_of_light_is_rendered_again()
    {
        string[] command = ["render", _scene, "--spp", "1", "--frames", "0..1", "-o", _folder["f#.png"], "--aov", "direct,lights", "--json"];
        Assert.Equal([true, true], Rendered(CliRun.Of(command)));
        Assert.Equal([false, false], Rendered(CliRun.Of(command)));
        File.Delete(_folder["f0.direct.png"]);
        File.Delete(_folder["f1.light.background.png"]);
        Assert.Equal([true, true], Rendered(CliRun.Of(command)));
    }

    [Theory]
    [InlineData("f#.png", "2", 5)]
    [InlineData("f#.rtfilm", "2", 5)]
    [InlineData("f#.png", "4096", 0)]
    [InlineData("f#.rtfilm", "4096", 0)]
    public void Frames_that_are_there_have_the_status_that_they_had(string files, string samples, int status)
    {
        string[] command = ["render", _scene, "--frames", "0..1", "-o", _folder[files], "--noise", "20%", "--spp", samples];
        Assert.Equal(status, CliRun.Of(command).Status);
        CliRun again = CliRun.Of(command);
        Assert.Equal(2, again.Output.Split("exists already").Length - 1);
        Assert.Equal(status, again.Status);
    }

    [Fact]
    public void A_stopped_animation_goes_on_with_the_frames_that_it_has()
    {
        string[] command = ["render", _scene, "--spp", "1", "--frames", "0..3", "-o", _folder["a.png"], "-o", _folder["b.apng"], "--json"];
        string folder = _folder["a.png.frames"];

        // From the second key on, the camera is where it looks at.
        string Stepped(string position) => Animated("[0, 1, 5]").Replace("[0, 1, 5] }, ", "[0, 1, 5], \"ease\": \"step\" }, ", StringComparison.Ordinal).Replace("[0, 1, 5.5]", position, StringComparison.Ordinal);
        File.WriteAllText(_scene, Stepped("[0, 0.5, 0]"));
        CliRun stopped = CliRun.Of(command);
        Assert.Equal(3, stopped.Status);
        Assert.Contains($"the 2 frames so far are kept in '{folder}'", stopped.Error, StringComparison.Ordinal);
        Assert.Equal(["0000.png", "0001.png"], Directory.GetFiles(folder).Select(Path.GetFileName).Order());
        Assert.False(File.Exists(_folder["a.png"]));

        File.WriteAllText(_scene, Stepped("[0, 1, 5.5]"));
        CliRun rest = CliRun.Of(command);
        Assert.Equal([false, false, true, true], Rendered(rest));
        Assert.Equal([_folder["a.png"], _folder["b.apng"]], JsonDocument.Parse(rest.Output).RootElement.GetProperty("outputs").EnumerateArray().Select(o => o.GetString()));
        Assert.False(Directory.Exists(folder));
        Assert.Equal(File.ReadAllBytes(_folder["a.png"]), File.ReadAllBytes(_folder["b.apng"]));

        Assert.Equal(0, CliRun.Of("render", _scene, "--spp", "1", "--frames", "0..3", "-o", _folder["f#.png"]).Status);
        Assert.Equal(Enumerable.Range(0, 4).Select(i => ImageFile.Read(_folder[$"f{i}.png"]).Pixels), Frames(File.ReadAllBytes(_folder["a.png"]), out _).Select(f => PngReader.Read(f).Pixels));
    }

    [Fact]
    public void An_animated_picture_stays_where_a_later_frame_is_wrong()
    {
        string[] command = ["render", _scene, "--spp", "1", "--frames", "0..4", "-o", _folder["a.png"]];
        Assert.Equal(0, CliRun.Of(command).Status);
        byte[] whole = File.ReadAllBytes(_folder["a.png"]);
        File.WriteAllText(_scene, Animated("[0, 1, 5]").Replace("\"lookAt\": [0, 0.5, 0]", "\"lookAt\": [0, 1, 5.5]", StringComparison.Ordinal));
        Assert.Equal(3, CliRun.Of(command).Status);
        Assert.Equal(whole, File.ReadAllBytes(_folder["a.png"]));
    }

    [Fact]
    public void Frame_is_the_scene_with_its_values_written_in_and_the_shutter_at_its_time()
    {
        File.WriteAllText(_folder["plain.json"], CliRun.Scene.Replace("[0, 1, 5]", "[0, 1, 5.5]", StringComparison.Ordinal)
            .Replace("\"samplesPerPixel\": 4", "\"samplesPerPixel\": 4, \"shutter\": [0.5, 0.75]", StringComparison.Ordinal).Replace(CliMotion.Still, CliMotion.Moving, StringComparison.Ordinal));

        Assert.Equal(Hash("render", _folder["plain.json"]), Hash("render", _scene, "--frames", "2"));
        Assert.NotEqual(Hash("render", _scene), Hash("render", _scene, "--frames", "2"));
    }

    [Fact]
    public void Film_of_a_frame_is_gone_on_with_at_that_frame()
    {
        Assert.Equal(0, CliRun.Of("render", _scene, "--frames", "3", "--spp", "2", "-o", _folder["f.rtfilm"], "--quiet").Status);

        Assert.Equal(Hash("render", _scene, "--frames", "3", "--spp", "5"), Hash("resume", _folder["f.rtfilm"], "--spp", "5"));
        Assert.Equal(0, CliRun.Of("verify", _folder["f.rtfilm"]).Status);
    }

    [Fact]
    public void Parts_share_the_frames_out()
    {
        for (int i = 1; i <= 2; i++)
        {
            bool[] rendered = Rendered(CliRun.Of("render", _scene, "--spp", "1", "--frames", "0..4", "--part", $"{i}/2", "-o", _folder["p#.png"], "--json"));
            Assert.Equal(4 - i, rendered.Length);
        }

        // Together they are what one run makes.
        Assert.DoesNotContain(true, Rendered(CliRun.Of("render", _scene, "--spp", "1", "--frames", "0..4", "-o", _folder["p#.png"], "--json")));
    }

    [Fact]
    public void Animated_png_holds_the_pictures_of_the_frames()
    {
        Assert.Equal(0, CliRun.Of("render", _scene, "--spp", "1", "--frames", "0..2", "-o", _folder["f#.png"], "-o", _folder["all.png"], "--fps", "25").Status);

        byte[][] frames = Frames(File.ReadAllBytes(_folder["all.png"]), out (int Numerator, int Denominator) delay);
        Assert.Equal((1, 25), delay);
        for (int i = 0; i < 3; i++)
        {
            Assert.Equal(ImageFile.Read(_folder[$"f{i}.png"]).Pixels, PngReader.Read(frames[i]).Pixels);
        }

        // Who knows no animation sees the first.
        Assert.Equal(ImageFile.Read(_folder["f0.png"]).Pixels, ImageFile.Read(_folder["all.png"]).Pixels);
    }

    [Theory]
    [InlineData("--frames 0..4 -o out.exr", "5 frames need as many files: put #### where their numbers should go")]
    [InlineData("--frames 4..0 -o f#.png", "expected frames, from 0, as in 7, 0..239 or 0..239:2")]
    [InlineData("--frames 0..4 --part 1/6 -o f#.png", "5 frames make at most 5 parts")]
    [InlineData("--frames 3 --part 1/2 -o f.png", "give --samples")]
    [InlineData("--frames 0..4 --checkpoint c.rtfilm -o f#.png", "--checkpoint is for one picture")]
    [InlineData("-o f.apng", "an animated PNG is made of --frames")]
    [InlineData("--fps 12 -o f.png", "give --frames")]
    [InlineData("--frames 0..2 -o f.png --denoise", "--denoise writes images beside every frame, and only an animated PNG is written")]
    [InlineData("--frames 0..2 -o f.png --aov depth", "--aov writes images beside every frame, and only an animated PNG is written")]
    [InlineData("--frames 0..2 -o f.png -o g.apng --aov direct", "give -o frame-####.png too")]
    public void Wrong_words_are_reported(string words, string message)
    {
        CliRun run = CliRun.Of(["render", _scene, .. words.Split(' ')]);

        Assert.Equal(2, run.Status);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    private static string Animated(string last) => CliRun.Scene.Replace("\"samplesPerPixel\": 4", "\"samplesPerPixel\": 4, \"framesPerSecond\": 4, \"shutter\": [0, 0.25]", StringComparison.Ordinal)
        .Replace(CliMotion.Still, CliMotion.Moving, StringComparison.Ordinal)
        .TrimEnd()[..^1] + $$""", "animation": [{ "property": "camera.position", "keys": [{ "time": 0, "value": [0, 1, 5] }, { "time": 0.5, "value": {{last.Replace("5]", "5.5]", StringComparison.Ordinal)}} }] }] }""";

    private static string Hash(params string[] words)
    {
        CliRun run = CliRun.Of([.. words, "--json", "--quiet"]);
        Assert.Equal("", run.Error);
        return JsonDocument.Parse(run.Output).RootElement.GetProperty("filmHash").GetString()!;
    }

    private static bool[] Rendered(CliRun run)
    {
        Assert.Equal(0, run.Status);
        return [.. JsonDocument.Parse(run.Output).RootElement.GetProperty("frames").EnumerateArray().Select(f => f.GetProperty("rendered").GetBoolean())];
    }

    // Makes PNG files of the frames of an animated one, by the PNG specification, third edition.
    private static byte[][] Frames(byte[] file, out (int Numerator, int Denominator) delay)
    {
        List<(string Type, byte[] Data)> chunks = [];
        for (int at = 8; at < file.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
            chunks.Add((Encoding.ASCII.GetString(file, at + 4, 4), file[(at + 8)..(at + 8 + length)]));
            at += length + 12;
        }

        (string Type, byte[] Data)[] numbered = [.. chunks.Where(c => c.Type is "fcTL" or "fdAT")];
        Assert.Equal(Enumerable.Range(0, numbered.Length), numbered.Select(c => BinaryPrimitives.ReadInt32BigEndian(c.Data)));
        Assert.Equal(numbered.Count(c => c.Type == "fcTL"), BinaryPrimitives.ReadInt32BigEndian(Assert.Single(chunks, c => c.Type == "acTL").Data));
        byte[] control = numbered[0].Data;
        delay = (BinaryPrimitives.ReadUInt16BigEndian(control.AsSpan(20)), BinaryPrimitives.ReadUInt16BigEndian(control.AsSpan(22)));
        byte[] header = Assert.Single(chunks, c => c.Type == "IHDR").Data;
        return [.. chunks.Where(c => c.Type is "IDAT" or "fdAT").Select(c => File(header, c.Type == "IDAT" ? c.Data : c.Data[4..]))];

        static byte[] File(byte[] header, byte[] data) => [.. PngReader.Signature, .. TestPng.Chunk("IHDR", header), .. TestPng.Chunk("IDAT", data), .. TestPng.Chunk("IEND")];
    }

    private static class CliMotion
    {
        public const string Still = "\"center\": [0, 0.5, 0], \"radius\": 0.5 ";
        public const string Moving = "\"center\": [0, 0.5, 0], \"radius\": 0.5, \"motion\": [{ \"time\": 0 }, { \"time\": 1, \"transform\": [{ \"translate\": [1, 0, 0] }] }] ";
    }
}
