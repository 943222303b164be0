using System.Text.Json;
using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

/// <summary>The output of <c>info</c> about films and images, and what verbs say that want scenes instead.</summary>
public sealed class InfoTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public InfoTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Everything_in_a_film_is_reported()
    {
        string film = _folder["a.rtfilm"];
        string hash = Json("render", _scene, "-o", film, "--seed", "7", "--crop", "2,3,10,9", "--samples", "1..2", "--json", "--quiet").GetProperty("filmHash").GetString()!;
        JsonElement json = Json("info", film, "--json", "--hash");
        Assert.Equal(
            ("film", 24, 16, "1..2", 2, "1..2", 2, 4, true, "[2,3,10,9]", _scene, hash),
            (Text(json, "kind"), Number(json, "width"), Number(json, "height"), Text(json, "samples"), Number(json, "heldSamples"), Text(json, "wanted"), Number(json, "wantedSamples"), Number(json, "totalSamples"),
                json.GetProperty("complete").GetBoolean(), json.GetProperty("crop").GetRawText().ReplaceLineEndings("").Replace(" ", "", StringComparison.Ordinal), Text(json, "scene"), Text(json, "filmHash")));
        Assert.Equal(["render.seed=7"], json.GetProperty("settings").EnumerateArray().Select(w => w.GetString()!));
        Assert.Equal(FilmFile.ReadHeader(film).Content, Text(json, "contentHash"));
        Assert.StartsWith("raytracer ", Text(json, "software"));
        Assert.Equal(new FileInfo(film).Length, Number(json, "fileBytes"));

        CliRun answer = CliRun.Of("info", film);
        Assert.Contains("samples    1..2: 2 of 2 wanted (1..2), complete", answer.Output, StringComparison.Ordinal);
        Assert.Contains("settings   render.seed=7", answer.Output, StringComparison.Ordinal);
        Assert.DoesNotContain(hash, answer.Output, StringComparison.Ordinal);

        FilmFile.Write(film, FilmFile.Read(film).Film, FilmFile.ReadHeader(film) with { Wanted = new(1, 9), Scene = "a\u001b[31mb" });
        Assert.False(Json("info", film, "--json").GetProperty("complete").GetBoolean());
        answer = CliRun.Of("info", film);
        Assert.Contains("1..2: 2 of 8 wanted (1..8), not complete", answer.Output, StringComparison.Ordinal);
        Assert.Contains("scene      a\\u001B[31mb", answer.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void A_resumed_film_tells_whether_the_time_was_enough()
    {
        string film = _folder["a.rtfilm"];
        Assert.Equal(0, CliRun.Of("render", _scene, "-o", film, "--spp", "1", "--quiet").Status);
        CliRun answer = CliRun.Of("resume", film, "--spp", "16777216", "--time", "0.1s");
        Assert.Equal(0, answer.Status);
        Assert.Matches(@"\ntime ran out at \d+ of 16777216 samples: ""raytracer resume [^""]*a.rtfilm"" continues it", answer.Output);
        JsonElement json = Json("resume", film, "--time", "0.1s", "--json", "--quiet");
        Assert.False(json.GetProperty("complete").GetBoolean());
        Assert.Equal(Text(json, "samples"), Text(Json("info", film, "--json"), "samples"));
        int held = Number(Json("info", film, "--json"), "heldSamples");
        CliRun all = CliRun.Of("resume", film, "--spp", $"{held}", "--json", "--quiet");
        Assert.Contains($"has all {held} samples", all.Error, StringComparison.Ordinal);
        Assert.True(JsonDocument.Parse(all.Output).RootElement.GetProperty("complete").GetBoolean());
    }

    [Fact]
    public void A_damaged_film_is_found_by_its_hash()
    {
        string film = _folder["a.rtfilm"];
        Assert.Equal(0, CliRun.Of("render", _scene, "-o", film, "--quiet").Status);
        byte[] bytes = File.ReadAllBytes(film);
        bytes[^40] ^= 1;
        File.WriteAllBytes(film, bytes);
        CliRun run = CliRun.Of("info", film, "--hash");
        Assert.Equal(4, run.Status);
        Assert.Contains("its checksum does not match", run.Error, StringComparison.Ordinal);
        File.WriteAllText(film, "no film");
        Assert.Equal(4, CliRun.Of("info", film).Status);
    }

    [Theory]
    [InlineData("a.png", "PNG", "Deflate", "R G B", "integer", 16, true)]
    [InlineData("a.jpg", "JPEG", "baseline DCT, chroma 4:2:0", "Y Cb Cr", "integer", 8, true)]
    [InlineData("a.exr", "OpenEXR", "ZIP", "B G R depth/Z", "half", 16, true)]
    [InlineData("a.hdr", "Radiance HDR", "run lengths", "R G B", "mantissa, with a common exponent of 8 bits", 8, true)]
    [InlineData("a.pfm", "PFM", "none, little-endian", "R G B", "float", 32, false)]
    public void Everything_in_an_image_is_reported(string name, string format, string compression, string channels, string type, int bits, bool hasTexts)
    {
        string image = _folder[name];
        string[] options = name switch { "a.exr" => ["--aov", "depth"], "a.png" => ["--bit-depth", "16"], "a.jpg" => ["--chroma", "half"], _ => [] };
        string hash = Text(Json(["render", _scene, "-o", image, "--json", "--quiet", .. options]), "filmHash");
        JsonElement json = Json("info", image, "--json");
        Assert.Equal(
            ("image", format, 24, 16, 1, compression),
            (Text(json, "kind"), Text(json, "format"), Number(json, "width"), Number(json, "height"), Number(json, "frames"), Text(json, "compression")));
        Assert.Equal(channels, string.Join(' ', json.GetProperty("channels").EnumerateArray().Select(c => $"{Text(c, "layer")}/{Text(c, "name")}".TrimStart('/'))));
        Assert.Equal((type, bits), (Text(json.GetProperty("channels")[0], "type"), Number(json.GetProperty("channels")[0], "bits")));
        Assert.Equal(hasTexts, json.GetProperty("texts").TryGetProperty("FilmHash", out JsonElement answer) && answer.GetString() == hash);
        Assert.Equal(new FileInfo(image).Length, Number(json, "fileBytes"));
        string output = CliRun.Of("info", image).Output;
        Assert.Contains($"{format}, 24×16 pixels", output, StringComparison.Ordinal);
        Assert.Equal(hasTexts, output.Contains($"text       FilmHash: {hash}", StringComparison.Ordinal));
        Assert.Equal(hasTexts ? 0 : 4, CliRun.Of("verify", image).Status);
    }

    [Fact]
    public void Of_an_image_that_carries_its_film_both_are_reported()
    {
        string hash = Text(Json("render", _scene, "-o", _folder["a.exr"], "--exr-film", "--json", "--quiet"), "filmHash");
        JsonElement json = Json("info", _folder["a.exr"], "--json", "--hash");
        Assert.Equal(("image", "0..3", hash), (Text(json, "kind"), Text(json.GetProperty("film"), "samples"), Text(json.GetProperty("film"), "filmHash")));
        Assert.Contains("samples    0..3: 4 of 4 wanted (0..3), complete", CliRun.Of("info", _folder["a.exr"]).Output, StringComparison.Ordinal);
    }

    [Fact]
    public void An_animation_tells_its_frames()
    {
        AnimatedPng animation = new([], 0.1);
        animation.Add(ImageFile.Encode(".png", TestPictures.Noise(5, 4), new()));
        animation.Add(ImageFile.Encode(".png", TestPictures.Noise(5, 4, 2), new()));
        animation.Write(_folder["a.png"]);
        Assert.Equal(2, Number(Json("info", _folder["a.png"], "--json"), "frames"));
    }

    [Fact]
    public void Films_and_pictures_in_place_of_scenes_are_called_what_they_are()
    {
        Assert.Equal(0, CliRun.Of("render", _scene, "-o", _folder["a.rtfilm"], "-o", _folder["a.png"], "--quiet").Status);
        foreach (string verb in new[] { "render", "check", "bench" })
        {
            string[] words = verb == "render" ? ["--json"] : [];
            CliRun film = CliRun.Of([verb, _folder["a.rtfilm"], .. words]);
            Assert.Equal(3, film.Status);
            Assert.Contains($"this is a film, not a scene: \"raytracer resume {_folder["a.rtfilm"]}\" resumes it", film.Output + film.Error, StringComparison.Ordinal);
            CliRun image = CliRun.Of([verb, _folder["a.png"], .. words]);
            Assert.Equal(3, image.Status);
            Assert.Contains($"this is a PNG picture, not a scene: \"raytracer view {_folder["a.png"]}\" shows it", image.Output + image.Error, StringComparison.Ordinal);
        }

        Assert.Equal(2, CliRun.Of("info", _folder["a.png"], "--set", "render.width=5").Status);
        Assert.Equal(2, CliRun.Of("info", _scene, "--hash").Status);
        Assert.Equal(4, CliRun.Of("info", _folder["missing.png"]).Status);
    }

    private static JsonElement Json(params string[] words)
    {
        CliRun run = CliRun.Of(words);
        Assert.Equal((0, ""), (run.Status, run.Error));
        return JsonDocument.Parse(run.Output).RootElement;
    }

    private static string Text(JsonElement json, string key) => json.GetProperty(key).GetString()!;

    private static int Number(JsonElement json, string key) => json.GetProperty(key).GetInt32();
}
