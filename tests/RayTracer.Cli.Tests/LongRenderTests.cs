using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

[Trait("Category", "Thorough")]
public sealed class LongRenderTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public LongRenderTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("sobol")]
    [InlineData("jittered")]
    public void Parts_merged_in_any_order_are_the_single_render_to_the_bit(string sampler)
    {
        string whole = CliRun.FilmHash("render", _scene, "--spp", "16", "--sampler", sampler, "--json", "--quiet");
        string[] parts = [.. Enumerable.Range(1, TestSettings.Scale(5, 16)).Select(i => _folder[$"part{i}.rtfilm"])];
        for (int i = 0; i < parts.Length; i++)
        {
            Assert.Equal(0, CliRun.Of("render", _scene, "--spp", "16", "--sampler", sampler, "--part", $"{i + 1}/{parts.Length}", "-o", parts[i], "--quiet").Status);
        }

        Random random = new(TestSettings.Seed);
        for (int i = 0; i < TestSettings.Scale(3, 20); i++)
        {
            random.Shuffle(parts);
            Assert.Equal(whole, CliRun.FilmHash(["merge", .. parts, "--json"]));
        }
    }

    [Fact]
    public void Films_are_written_as_every_kind_of_image()
    {
        CliRun.Fine("render", _scene, "--samples", "0..3", "-o", _folder["a.rtfilm"], "-o", _folder["direct.pfm"], "-o", _folder["direct.png"]);
        CliRun.Fine("merge", _folder["a.rtfilm"], "-o", _folder["a.pfm"], "-o", _folder["a.png"], "-o", _folder["a.exr"], "-o", _folder["b.rtfilm"]);
        Assert.Equal(File.ReadAllBytes(_folder["direct.pfm"]), File.ReadAllBytes(_folder["a.pfm"]));
        Assert.Equal(0, ImageComparison.Compare(ImageFile.Read(_folder["a.png"]), ImageFile.Read(_folder["direct.png"])).LargestDifference);
        Assert.Equal(0, ImageComparison.Compare(ImageFile.Read(_folder["b.rtfilm"]), ImageFile.Read(_folder["a.pfm"])).LargestDifference);
        Assert.True(ImageFile.Read(_folder["a.exr"]).Pixels.Max() > 0.5f);
    }

    [Fact]
    public void An_unfinished_checkpoint_is_not_written_over()
    {
        string film = _folder["a.rtfilm"];
        CliRun.Fine("render", _scene, "--spp", "16", "--samples", "0..3", "-o", film);
        CliRun.Refused(4, $"'{film}' holds samples 0..3 of this picture: --resume continues it", "render", _scene, "--spp", "16", "--part", "1/2", "--checkpoint", Unfinished(film));
        CliRun.Refused(4, $"'{film}' holds samples 0..3 of an unfinished rendering: \"raytracer resume {film}\" continues; delete it to begin from scratch", "render", _scene, "--spp", "1", "-o", film);
        CliRun.Fine("resume", film, "--quiet");
        CliRun.Fine("render", _scene, "--spp", "16", "--checkpoint", film, "--overwrite", "--quiet");
    }

    [Fact]
    public void A_film_without_samples_is_refused()
    {
        string film = _folder["none.rtfilm"];
        FilmFile.Write(film, new(4, 3), new FilmHeader { Width = 4, Height = 3, Content = "", Samples = [], Wanted = new(0, 8), Total = 8, Scene = _scene, Software = "" });
        CliRun.Refused(4, $"'{film}' holds no samples yet", "merge", film, "--partial", "--json");
        CliRun.Refused(4, $"'{film}' holds no samples yet", "verify", film);
    }

    [Fact]
    public void What_follows_a_films_end_is_reported()
    {
        string film = _folder["a.rtfilm"];
        CliRun.Fine("render", _scene, "--spp", "4", "-o", film);
        File.AppendAllText(film, "!");
        CliRun.Refused(4, "data follows its end", "merge", film, "--json");
    }

    [Fact]
    public void A_cropped_film_that_was_gone_on_with_is_verified()
    {
        string film = _folder["a.rtfilm"];
        CliRun.Fine("render", _scene, "--spp", "4", "--crop", "1,1,3,2", "-o", film);
        CliRun.Fine("resume", film, "--spp", "8", "-o", _folder["a.png"], "--quiet");
        CliRun.Fine("verify", _folder["a.png"]);
    }

    [Fact]
    public void Only_the_picture_itself_is_verified()
    {
        CliRun.Fine("render", _scene, "--spp", "4", "--aov", "depth", "-o", _folder["a.png"]);
        CliRun.Refused(4, "is an image beside the picture", "verify", _folder["a.depth.png"]);
    }

    [Fact]
    public void A_picture_above_the_models_folder_counts_too()
    {
        Directory.CreateDirectory(_folder["model"]);
        File.WriteAllText(_folder["model/a.mtl"], "newmtl m\nMap_kd ../up.png\n");
        File.WriteAllText(_folder["model/a.obj"], "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
        File.WriteAllText(_folder["m.json"], """{ "render": { "integrator": "report", "width": 4, "height": 3 }, "shapes": [ { "type": "model", "file": "model/a.obj" } ] }""");
        ImageFile.Write(_folder["up.png"], new Picture(1, 1, [1, 0, 0]));
        CliRun.Fine("render", _folder["m.json"], "--spp", "4", "--samples", "0..1", "-o", _folder["a.rtfilm"]);
        ImageFile.Write(_folder["up.png"], new Picture(1, 1, [0, 1, 0]));
        CliRun.Refused(4, "the film is not of", "resume", _folder["a.rtfilm"]);
    }

    // A film of some samples, as a checkpoint of more.
    private static string Unfinished(string film)
    {
        (FilmHeader header, Film held) = FilmFile.Read(film);
        FilmFile.Write(film, held, header with { Wanted = new(0, 16) });
        return film;
    }

    [Fact]
    public void Overlaps_gaps_and_other_pictures_are_refused_by_name()
    {
        string a = _folder["a.rtfilm"];
        string b = _folder["b.rtfilm"];
        CliRun.Fine("render", _scene, "--spp", "16", "--samples", "0..6", "-o", a);
        CliRun.Fine("render", _scene, "--spp", "16", "--samples", "5..9", "-o", b);
        CliRun.Refused(4, $"samples 5..6 are in both '{a}' and '{b}'", "merge", b, a, "--json");
        CliRun.Fine("render", _scene, "--spp", "16", "--samples", "8..14", "-o", b);
        CliRun.Refused(4, "samples 7..7, 15..15 are missing of 16 (--partial merges what is there)", "merge", b, a, "--json");
        CliRun partial = CliRun.Of("merge", b, a, "--partial", "-o", _folder["c.rtfilm"]);
        Assert.Equal(0, partial.Status);
        Assert.Contains("samples 7..7, 15..15 are missing of 16", partial.Error, StringComparison.Ordinal);
        Assert.Equal("0..6, 8..14", FilmFile.ReadHeader(_folder["c.rtfilm"]).SamplesText);
        CliRun.Fine("render", _scene, "--spp", "16", "--seed", "5", "--samples", "7..15", "-o", b);
        CliRun.Refused(4, $"'{b}' is not of the same picture as '{a}'", "merge", a, b, "--json");
    }

    [Fact]
    public void The_content_of_scenes_and_files_decides_what_goes_together_and_neither_names_nor_layout()
    {
        string picture = _folder["sky.pfm"];
        ImageFile.Write(picture, new Picture(2, 1, [1, 0, 0, 0, 1, 0]));
        string text = CliRun.Scene.Replace("\"color\": { \"type\": \"checker\" }", "\"color\": { \"type\": \"image\", \"file\": \"sky.pfm\" }", StringComparison.Ordinal);
        string Content(string scene, params string[] more)
        {
            File.WriteAllText(_scene, scene);
            CliRun.Fine(["render", _scene, "-o", _folder["a.rtfilm"], "--quiet", .. more]);
            return FilmFile.ReadHeader(_folder["a.rtfilm"]).Content;
        }

        string content = Content(text);
        Assert.Equal(content, Content("\n// The same.\n" + text.Replace("{ \"type\": \"sphere\"", "{\"type\" : \"sphere\"", StringComparison.Ordinal)));
        Assert.Equal(content, Content(text, "--spp", "7"));
        Assert.NotEqual(content, Content(text, "--seed", "7"));
        Assert.NotEqual(content, Content(text, "--crop", "0,0,8,8"));
        Assert.NotEqual(content, Content(text.Replace("0.3", "0.31", StringComparison.Ordinal)));
        Assert.NotEqual(Content(text, "--sampler", "jittered", "--spp", "4"), Content(text, "--sampler", "jittered", "--spp", "9"));
        File.Move(picture, _folder["other.pfm"]);
        Assert.Equal(content, Content(text.Replace("sky.pfm", "other.pfm", StringComparison.Ordinal)));
        ImageFile.Write(picture, new Picture(2, 1, [1, 0, 0, 0, 1, 0.5f]));
        Assert.NotEqual(content, Content(text));
    }

    [Fact]
    public void A_film_is_gone_on_with_and_can_have_more_samples_than_were_asked_for()
    {
        string film = _folder["a.rtfilm"];
        CliRun.Fine("render", _scene, "--spp", "4", "--checkpoint", film, "-o", _folder["a.pfm"], "--quiet");
        Assert.True(FilmFile.ReadHeader(film).IsComplete);
        CliRun run = CliRun.Of("resume", film, "--spp", "11", "-o", _folder["b.pfm"], "--json", "--quiet");
        Assert.Equal((0, ""), (run.Status, run.Error));
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal(24 * 16 * 7, json.GetProperty("paths").GetInt32());
        Assert.Equal(("0..10", 11), (json.GetProperty("samples").GetString(), json.GetProperty("samplesPerPixel").GetInt32()));
        CliRun.Fine("render", _scene, "--spp", "11", "-o", _folder["c.pfm"], "--quiet");
        Assert.Equal(File.ReadAllBytes(_folder["c.pfm"]), File.ReadAllBytes(_folder["b.pfm"]));
        Assert.Equal("0..10", FilmFile.ReadHeader(film).SamplesText);
        CliRun.Refused(2, "--spp 6: the film has 11 samples a pixel already", "resume", film, "--spp", "6");
    }

    [Fact]
    public void A_film_whose_scene_was_changed_is_not_gone_on_with()
    {
        string film = _folder["a.rtfilm"];
        CliRun.Fine("render", _scene, "-o", film, "--quiet");
        File.WriteAllText(_scene, CliRun.Scene.Replace("skyblue", "tomato", StringComparison.Ordinal));
        CliRun.Refused(4, $"the film is not of '{_scene}'", "resume", film, "--spp", "8", "--quiet");
        File.WriteAllText(_scene, CliRun.Scene.Replace("\"width\": 24", "\"width\": 25", StringComparison.Ordinal));
        CliRun.Refused(4, $"the film is not of '{_scene}'", "resume", film, "--spp", "8", "--quiet");
    }

    [Fact]
    public void A_film_of_a_pattern_of_so_many_samples_is_not_given_more()
    {
        string film = _folder["a.rtfilm"];
        CliRun.Fine("render", _scene, "--spp", "9", "--sampler", "jittered", "-o", film, "--quiet");
        CliRun.Refused(2, "--spp 16: the places of the jittered sampler's samples depend on how many there are", "resume", film, "--spp", "16", "--quiet");
        File.WriteAllText(_scene, CliRun.Scene.Replace("skyblue", "tomato", StringComparison.Ordinal));
        CliRun.Refused(4, $"the film is not of '{_scene}'", "resume", film, "--quiet");
    }

    [Fact]
    public void Time_that_is_up_while_the_noise_is_decided_on_still_gives_a_picture()
    {
        CliRun run = CliRun.Of("render", _scene, "--noise", "0.001%", "--time", "0.001", "-o", _folder["a.png"], "--json", "--quiet");
        Assert.Equal(5, run.Status);
        Assert.InRange(JsonDocument.Parse(run.Output).RootElement.GetProperty("samplesPerPixel").GetInt32(), 1, 65535);
        Assert.True(File.Exists(_folder["a.png"]));
    }

    [Fact]
    public void A_film_finds_its_scene_beside_it_on_another_machine()
    {
        string there = Directory.CreateDirectory(_folder["there"]).FullName;
        CliRun.Fine("render", _scene, "-o", _folder["a.rtfilm"], "--quiet");
        File.Move(_scene, Path.Combine(there, "scene.json"));
        File.Move(_folder["a.rtfilm"], Path.Combine(there, "a.rtfilm"));
        CliRun.Fine("resume", Path.Combine(there, "a.rtfilm"), "--spp", "5", "--quiet");
        Assert.Equal(5, FilmFile.ReadHeader(Path.Combine(there, "a.rtfilm")).Samples[0].End);
    }

    [Fact]
    public void Time_ends_on_a_whole_pass_and_the_samples_are_recorded()
    {
        CliRun run = CliRun.Of("render", _scene, "--time", "0.05", "-o", _folder["a.rtfilm"], "-o", _folder["a.png"], "--json", "--quiet");
        Assert.Equal((0, ""), (run.Status, run.Error));
        int samples = JsonDocument.Parse(run.Output).RootElement.GetProperty("samplesPerPixel").GetInt32();
        Assert.InRange(samples, 1, 65535);
        Assert.Equal($"{samples}", ImageFile.ReadText(_folder["a.png"]).First(t => t.Key == "Samples").Value);
        Assert.Equal(CliRun.FilmHash("render", _scene, "--spp", $"{samples}", "--json", "--quiet"), CliRun.FilmHash("merge", _folder["a.rtfilm"], "--json"));
    }

    [Fact]
    public void Verify_tells_the_same_picture_from_another()
    {
        CliRun.Fine("render", _scene, "-o", _folder["a b.png"], "-o", _folder["a.exr"], "-o", _folder["a.rtfilm"], "--spp", "5", "--crop", "2,3,10,9", "--quiet");
        CliRun.Fine("render", _scene, "-o", _folder["c.png"], "--noise", "20%", "--adaptive", "--quiet");
        foreach (string file in new[] { "a b.png", "a.exr", "a.rtfilm", "c.png" })
        {
            CliRun run = CliRun.Of("verify", _folder[file]);
            Assert.Equal((0, ""), (run.Status, run.Error));
            Assert.Contains("the same to the bit", run.Output, StringComparison.Ordinal);
        }

        File.WriteAllText(_scene, CliRun.Scene.Replace("skyblue", "tomato", StringComparison.Ordinal));
        foreach (string file in new[] { "a b.png", "a.exr", "a.rtfilm" })
        {
            Assert.Equal(1, CliRun.Of("verify", _folder[file]).Status);
        }

        ImageFile.Write(_folder["plain.png"], new Picture(1, 1));
        CliRun.Refused(4, "does not say how it was made", "verify", _folder["plain.png"]);
    }

    [Fact]
    public void Films_that_are_damaged_cut_off_or_none_are_refused()
    {
        string film = _folder["a.rtfilm"];
        CliRun.Fine("render", _scene, "-o", film, "--quiet");
        byte[] good = File.ReadAllBytes(film);
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 300; i++)
        {
            byte[] bad = i % 3 == 0 ? good[..random.Next(good.Length)] : (byte[])good.Clone();
            if (bad.Length > 0)
            {
                bad[random.Next(bad.Length)] ^= (byte)(1 << random.Next(8));
            }

            File.WriteAllBytes(film, bad);
            CliRun run = CliRun.Of("merge", film, "--json");
            Assert.Equal((4, ""), (run.Status, run.Output));
            Assert.StartsWith($"raytracer: error: Cannot read the film '{film}': ", run.Error, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Sums_that_do_not_fit_into_64_bits_are_kept()
    {
        Film film = new(3, 2);
        Int128[] sums = new Int128[12];
        sums[5] = (Int128)long.MaxValue * 1000;
        sums[7] = -(Int128)long.MaxValue * 3;
        film.AddSums(1, sums, [1, 2, 3]);
        FilmHeader header = new() { Width = 3, Height = 2, Content = "", Samples = [new(0, 1)], Wanted = new(0, 1), Total = 1 };
        FilmFile.Write(_folder["a.rtfilm"], film, header);
        (FilmHeader read, Film again) = FilmFile.Read(_folder["a.rtfilm"]);
        Assert.Equal(film.ComputeHash(), again.ComputeHash());
        Assert.True(read.IsComplete);
    }
}
