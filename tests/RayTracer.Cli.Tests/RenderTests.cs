using System.Globalization;
using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

public sealed class RenderTests : IDisposable
{
    private static readonly string[] Fields =
    [
        "width", "height", "samplesPerPixel", "threads", "lanes", "loadSeconds", "buildSeconds", "renderSeconds", "writeSeconds", "totalSeconds", "peakMemoryBytes", "paths", "closestHitRays",
        "shadowRays", "raysPerSecond", "filmHash", "nonFiniteSamples", "cancelled", "outputs",
    ];

    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public RenderTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void One_render_gives_several_formats_of_one_image()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"], "-o", _folder["a.exr"], "--output", _folder["a.pfm"], "--bit-depth", "16");
        Assert.Equal((0, ""), (run.Status, run.Error));
        Picture exact = ImageFile.Read(_folder["a.pfm"]);
        Assert.Equal((24, 16), (exact.Width, exact.Height));
        Assert.True(exact.Pixels.Max() > 0.5f);
        Assert.True(ImageComparison.Compare(ImageFile.Read(_folder["a.exr"]), exact).LargestDifference < 0.01);
    }

    [Fact]
    public void Png_exr_and_jpeg_carry_how_they_were_made()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a b.png"], "-o", _folder["a.exr"], "-o", _folder["a.jpg"], "--spp", "9");
        foreach (string file in new[] { "a b.png", "a.exr", "a.jpg" })
        {
            Dictionary<string, string> texts = ImageFile.ReadText(_folder[file]).ToDictionary();
            Assert.StartsWith("raytracer ", texts["Software"]);
            Assert.Equal($"raytracer render {_scene} --spp 9 -o '{_folder["a b.png"]}' -o {_folder["a.exr"]} -o {_folder["a.jpg"]}", texts["Command"]);
            Assert.Equal("scene.json", texts["Scene"]);
            Assert.Equal("9", texts["Samples"]);
            Assert.Contains(texts["FilmHash"], run.Output, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Json_has_the_numbers_and_overrides_are_obeyed()
    {
        CliRun run = CliRun.Of("render", _scene, "--json", "--width", "10", "--height", "6", "--spp", "3", "--threads", "2", "--seed", "7");
        Assert.Equal((0, ""), (run.Status, run.Error));
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal(Fields, json.EnumerateObject().Select(p => p.Name));
        Assert.Equal((10, 6, 3, 2), (Int(json, "width"), Int(json, "height"), Int(json, "samplesPerPixel"), Int(json, "threads")));
        Assert.Equal(10 * 6 * 3, Int(json, "paths"));
        Assert.True(Int(json, "closestHitRays") >= 180);
        Assert.True(Int(json, "shadowRays") > 0);
        Assert.Matches("^[0-9a-f]{64}$", json.GetProperty("filmHash").GetString());
    }

    [Fact]
    public void Noise_alone_stops_at_a_plain_picture_and_tells_what_was_reached()
    {
        CliRun run = CliRun.Of("render", _scene, "--json", "--quiet", "--noise", "5%");
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal((0, ""), (run.Status, run.Error));
        Assert.True(json.GetProperty("reached").GetBoolean());
        Assert.InRange(json.GetProperty("estimatedError").GetDouble(), 0.001, 0.05);
        int samples = Int(json, "samplesPerPixel");
        JsonElement plain = JsonDocument.Parse(CliRun.Of("render", _scene, "--json", "--quiet", "--spp", $"{samples}").Output).RootElement;
        Assert.Equal(plain.GetProperty("filmHash").GetString(), json.GetProperty("filmHash").GetString());
        Assert.Equal(Int(json, "paths"), Int(plain, "paths") + Int(json, "decidingPaths"));
    }

    [Fact]
    public void Noise_out_of_reach_has_an_exit_status_of_its_own_and_a_picture()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.pfm"], "--noise", "0.01%", "--spp", "4");
        Assert.Equal(5, run.Status);
        Assert.Contains("would take more samples than allowed (--spp)", run.Error, StringComparison.Ordinal);
        Assert.True(File.Exists(_folder["a.pfm"]));
    }

    [Fact]
    public void Adaptive_pictures_have_an_image_of_their_samples()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.pfm"], "--aov", "samples,depth", "--adaptive", "--spp", "64", "--json", "--quiet");
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Picture samples = ImageFile.Read(_folder["a.samples.pfm"]);
        Assert.Equal((0, ""), (run.Status, run.Error));
        Assert.Equal(Int(json, "fewestSamples"), samples.Pixels.Min());
        Assert.Equal(Int(json, "mostSamples"), samples.Pixels.Max());
        Assert.Equal(json.GetProperty("samplesPerPixel").GetDouble(), samples.Pixels.Average(), 3);
        Assert.True(samples.Pixels.Min() < samples.Pixels.Max());
    }

    [Fact]
    public void Film_hash_depends_on_the_seed_and_the_depth_but_not_on_the_threads()
    {
        string hash = Hash();
        Assert.Equal(hash, Hash("--threads", "3"));
        Assert.NotEqual(hash, Hash("--seed", "1"));
        Assert.NotEqual(hash, Hash("--max-diffuse-depth", "0"));
        Assert.NotEqual(hash, Hash("--sampler", "jittered"));
    }

    [Fact]
    public void Quiet_says_nothing()
    {
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of("render", _scene, "-o", _folder["a.png"], "--quiet"));
    }

    [Fact]
    public void Crop_leaves_the_rest_black()
    {
        CliRun.Of("render", _scene, "-o", _folder["all.pfm"]);
        CliRun.Of("render", _scene, "-o", _folder["part.pfm"], "--crop", "3,2,5,4");
        Picture all = ImageFile.Read(_folder["all.pfm"]);
        Picture part = ImageFile.Read(_folder["part.pfm"]);
        for (int i = 0; i < all.Pixels.Length; i++)
        {
            bool inside = i / 3 % 24 is >= 3 and < 8 && i / 3 / 24 is >= 2 and < 6;
            Assert.Equal(inside ? all.Pixels[i] : 0, part.Pixels[i]);
        }
    }

    [Fact]
    public void Pixel_is_the_same_as_in_the_whole_picture()
    {
        CliRun.Of("render", _scene, "-o", _folder["all.pfm"]);
        Picture all = ImageFile.Read(_folder["all.pfm"]);
        float[] seen = Radiance(CliRun.Of("render", _scene, "--pixel", "12,9").Output);
        Assert.Equal(all.Pixels.AsSpan(3 * ((9 * 24) + 12), 3).ToArray(), seen);
    }

    [Fact]
    public void Samples_of_a_pixel_add_up_to_it()
    {
        float[] sum = new float[3];
        for (int sample = 0; sample < 4; sample++)
        {
            float[] one = Radiance(CliRun.Of("render", _scene, "--pixel", "12,9", "--sample", $"{sample}").Output);
            sum = [.. sum.Zip(one, (a, b) => a + b)];
        }

        float[] mean = Radiance(CliRun.Of("render", _scene, "--pixel", "12,9").Output);
        Assert.All(sum.Zip(mean), pair => Assert.Equal(pair.Second, pair.First / 4, 1e-6f));
    }

    [Fact]
    public void Samples_that_are_not_finite_are_named_with_the_command_that_repeats_them()
    {
        File.WriteAllText(_scene, Lamp(ambient: "3e38"));
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"], "--seed", "3");
        Assert.Equal(0, run.Status);
        Assert.Contains("samples were not finite and were discarded", run.Error, StringComparison.Ordinal);
        string replay = run.Error.Split('\n').First(l => l.Contains("--sample", StringComparison.Ordinal)).Trim();
        Assert.Matches($"^raytracer render {_scene} --seed 3 --pixel \\d+,\\d+ --sample \\d+$", replay);
        CliRun again = CliRun.Of(replay.Split(' ')[1..]);
        Assert.Contains("not finite and discarded", again.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Clamped_samples_are_counted()
    {
        File.WriteAllText(_scene, Lamp(ambient: "0"));
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"]);
        Assert.Matches(@"warning: \d+ samples were clamped at ±16777216", run.Error);
    }

    [Theory]
    [InlineData("12x8", "--width", "12")]
    [InlineData("12x8", "--height", "8")]
    [InlineData("12x8", "--scale", "50%")]
    [InlineData("48x32", "--scale", "200%")]
    [InlineData("12x16", "--set", "render.width=12")]
    [InlineData("12x10", "--width", "12", "--height", "10")]
    [InlineData("12x10", "--width", "12", "--set", "render.height=10")]
    public void One_side_alone_and_a_scale_keep_the_aspect_of_the_scene(string size, params string[] options)
    {
        CliRun run = CliRun.Of(["render", _scene, "--json", "--spp", "1", .. options]);
        JsonElement result = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal(size, $"{result.GetProperty("width")}x{result.GetProperty("height")}");
    }

    [Fact]
    public void OpenEXR_images_hold_the_numbers_that_are_asked_for()
    {
        foreach ((string type, string[] option) in new[] { ("half", Array.Empty<string>()), ("float", ["--exr-type", "float"]) })
        {
            CliRun.Fine(["render", _scene, "-o", _folder["a.exr"], "--spp", "1", "--quiet", .. option]);
            Assert.Equal(type, ImageFile.Describe(_folder["a.exr"]).Channels[0].Type);
        }

        CliRun.Fine("verify", _folder["a.exr"]);
    }

    // A pipe gives its content once.
    [ProgramFact("mkfifo")]
    public async Task A_scene_whose_size_is_derived_is_read_once()
    {
        string pipe = _folder["pipe.json"];
        ProgramFactAttribute.Run("mkfifo", pipe);
        string film = CliRun.FilmHash("render", _scene, "--width", "12", "--height", "8", "--json");
        Task writing = Task.Run(() => File.WriteAllText(pipe, File.ReadAllText(_scene)));
        Assert.Equal(film, CliRun.FilmHash("render", pipe, "--width", "12", "--json"));
        await writing;
    }

    [Fact]
    public void A_derived_size_is_kept_by_the_picture_and_has_the_limits_of_one_that_is_given()
    {
        CliRun.Fine("render", _scene, "-o", _folder["a.png"], "--scale", "50%", "--spp", "1", "--quiet");
        Assert.Contains("render.width=12", ImageFile.ReadText(_folder["a.png"]).First(t => t.Key == "Settings").Value, StringComparison.Ordinal);
        CliRun.Fine("verify", _folder["a.png"]);
        CliRun.Refused(2, "render.width must be", "render", _scene, "-o", _folder["a.png"], "--height", "65536");
    }

    [Fact]
    public void A_scale_is_a_percentage_and_goes_with_no_size()
    {
        CliRun.Refused(2, "expected a percentage, as in 50%", "render", _scene, "-o", _folder["a.png"], "--scale", "50");
        CliRun.Refused(2, "--scale and --width", "render", _scene, "-o", _folder["a.png"], "--scale", "50%", "--width", "8");
    }

    [Fact]
    public void A_bad_scene_gives_diagnostics_and_no_image()
    {
        File.WriteAllText(_scene, "{ \"shapes\": [ { \"type\": \"spher\" } ] }");
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"]);
        Assert.Equal(3, run.Status);
        Assert.StartsWith($"{_scene}:1:25: error: unknown shape type \"spher\"", run.Error);
        Assert.False(File.Exists(_folder["a.png"]));
    }

    // A lamp in the middle of the picture, about as bright as floats go; reflected ambient light makes it brighter still.
    private static string Lamp(string ambient) => $$"""
        { "render": { "integrator": "report", "width": 8, "height": 8, "samplesPerPixel": 4 },
          "shapes": [ { "type": "sphere", "center": [0, 0, 0],
                        "material": { "type": "luminaire", "color": [1e38, 1e38, 1e38], "material": { "type": "diffuse", "color": [1, 1, 1] } } } ],
              "ambient": [{{ambient}}, {{ambient}}, {{ambient}}] }
        """;

    private static float[] Radiance(string output)
    {
        string numbers = output.Split("radiance ")[1].Split(',')[0];
        return [.. numbers.Split(' ').Select(n => float.Parse(n, CultureInfo.InvariantCulture))];
    }

    private static int Int(JsonElement json, string key) => json.GetProperty(key).GetInt32();

    private string Hash(params string[] options)
    {
        CliRun run = CliRun.Of(["render", _scene, "--json", .. options]);
        return JsonDocument.Parse(run.Output).RootElement.GetProperty("filmHash").GetString()!;
    }
}
