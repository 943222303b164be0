using System.Globalization;
using System.Text.Json;
using RayTracer.Cli.Tests;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;
using Xunit.Sdk;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>The assertions about images: that they fail when they should, do not when they should not, and what a failure leaves behind.</summary>
public sealed class ImageAssertTests : IDisposable
{
    private const string Name = "a planted error";
    private readonly TemporaryFolder _folder = new();

    private string Failure => Path.Combine(_folder.Path, "a_planted_error");

    public void Dispose() => _folder.Dispose();

    public static TheoryData<string> Rules => ["exact", "tolerance", "similarity"];

    [Theory]
    [MemberData(nameof(Rules))]
    public void Equal_images_match_and_nothing_is_written(string rule)
    {
        Picture reference = TestPictures.Noise(32, 24);
        ImageAssert.Matches(Changed(reference, 0, v => v), reference, Rule(rule), Name, output: _folder.Path);
        Assert.Empty(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Theory]
    [MemberData(nameof(Rules))]
    public void A_planted_error_is_found_and_its_pixel_named(string rule)
    {
        Picture reference = new(32, 24, [.. Enumerable.Range(0, 3 * 32 * 24).Select(i => i / 3 % 32 / 40f)]);
        string message = Fails(() => ImageAssert.Matches(Changed(reference, (3 * ((7 * 32) + 5)) + 1, v => v + 3), reference, Rule(rule), Name, output: _folder.Path));
        Assert.StartsWith($"{Name}: ", message, StringComparison.Ordinal);
        Assert.Contains("5,7", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Exact_sees_the_last_bit_and_the_sign_of_zero()
    {
        Picture reference = new(2, 1, [1, 0, 0, 0, 0, float.NaN]);
        ImageAssert.Matches(Changed(reference, 0, v => v), reference, ImageRule.Exact, Name);
        Assert.Contains("red at 0,0: 1.0000001, reference 1", Fails(() => Exact(Changed(reference, 0, float.BitIncrement), reference)), StringComparison.Ordinal);
        Assert.Contains("1 of 2 pixels", Fails(() => Exact(Changed(reference, 4, _ => float.NegativeZero), reference)), StringComparison.Ordinal);
    }

    [Fact]
    public void Tolerance_is_absolute_plus_relative_and_a_share_of_pixels_may_be_off()
    {
        Picture reference = new(10, 1, [.. Enumerable.Repeat(8f, 30)]);
        ImageRule rule = ImageRule.Within(0.5, 0.25, 0.1);
        ImageRule strict = ImageRule.Within(0.5, 0.25);
        Picture atLimit = Changed(reference, 4, v => v + 2.5f);
        Picture beyond = Changed(reference, 4, v => v - 2.75f);
        Picture twoBeyond = Changed(beyond, 8, v => v + 2.75f);
        ImageAssert.Matches(atLimit, reference, strict, Name);
        ImageAssert.Matches(beyond, reference, rule, Name);
        ImageAssert.Matches(Changed(beyond, 3, v => v + 99), reference, rule, Name);
        Assert.Contains("1 of 10 pixels", Fails(() => ImageAssert.Matches(beyond, reference, strict, Name, output: _folder.Path)), StringComparison.Ordinal);
        Assert.Contains("2 of 10 pixels", Fails(() => ImageAssert.Matches(twoBeyond, reference, rule, Name, output: _folder.Path)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void No_share_of_outliers_and_no_similarity_forgives_a_value_that_is_not_finite(float value)
    {
        Picture reference = TestPictures.Noise(32, 24);
        Picture image = Changed(reference, 100, _ => value);
        Fails(() => ImageAssert.Matches(image, reference, ImageRule.Within(1e9, 1e9, 1), Name, output: _folder.Path));
        Fails(() => ImageAssert.Matches(image, reference, ImageRule.LooksLike(0), Name, output: _folder.Path));
        Fails(() => ImageAssert.Matches(reference, image, ImageRule.Within(1e9, 1e9, 1), Name, output: _folder.Path));
        ImageAssert.Matches(image, Changed(reference, 100, _ => value), ImageRule.Within(0), Name);
    }

    // A hue of the same luma: red and green change against each other by the weights of Rec. 709.
    [Fact]
    public void Similarity_sees_a_wrong_hue_of_the_right_luma()
    {
        Picture reference = new(16, 16);
        Picture image = new(16, 16);
        for (int i = 0; i < 3 * 256; i += 3)
        {
            float level = i / 3 % 5 * 0.15f;
            reference.Pixels[i] = reference.Pixels[i + 1] = (float)SrgbCurve.Decode(0.2 + level);
            image.Pixels[i] = (float)SrgbCurve.Decode(0.2 + level - 0.15);
            image.Pixels[i + 1] = (float)SrgbCurve.Decode(0.2 + level + (0.15 * 0.2126 / 0.7152));
        }

        Assert.InRange(ImageComparison.Compare(image, reference).Ssim, 0.999, 1);
        string message = Fails(() => ImageAssert.Matches(image, reference, ImageRule.LooksLike(0.95), Name, output: _folder.Path));
        Assert.Contains("similarity of red", message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_image_too_small_for_similarity_fails_with_that_reason() => Assert.Contains(
        "needs 11×11 pixels",
        Fails(() => ImageAssert.Matches(new Picture(10, 20), new Picture(10, 20), ImageRule.LooksLike(0), Name, output: _folder.Path)),
        StringComparison.Ordinal);

    [Fact]
    public void Images_of_other_sizes_fail_and_are_both_kept()
    {
        string message = Fails(() => Exact(new Picture(3, 2), new Picture(2, 3)));
        Assert.Contains("the image has 3×2 pixels, the reference 2×3", message, StringComparison.Ordinal);
        Assert.Equal(["image.pfm", "image.png", "index.html", "reference.pfm", "reference.png"], Files());
    }

    [Fact]
    public void A_failure_leaves_pictures_that_can_be_read_back()
    {
        Picture reference = TestPictures.Noise(32, 24);
        Picture image = Changed(Changed(reference, 30, v => v + 2), 61, v => v - 1);
        string message = Fails(() => Exact(image, reference));
        Assert.Contains(Path.Combine(Failure, "index.html"), message, StringComparison.Ordinal);
        Assert.Equal(["difference.pfm", "difference.png", "image.pfm", "image.png", "index.html", "reference.pfm", "reference.png"], Files());
        TestPictures.AssertSameBits(image, Read("image.pfm"));
        TestPictures.AssertSameBits(reference, Read("reference.pfm"));
        Picture difference = Read("difference.pfm");
        Assert.Equal(image.Pixels.Zip(reference.Pixels, (a, b) => a - b), difference.Pixels);
        Picture shown = ImageFile.Read(Path.Combine(Failure, "difference.png"), raw: true);
        float[] codes = [shown.Pixels[0], shown.Pixels[30], shown.Pixels[61]];
        Assert.Equal([128f / 255, 1, 64f / 255], codes);
        string page = File.ReadAllText(Path.Combine(Failure, "index.html"));
        Assert.All(Files().Except(["index.html"]), file => Assert.Contains($"\"{file}\"", page, StringComparison.Ordinal));
    }

    [Fact]
    public void A_value_that_is_not_finite_is_magenta_in_the_difference()
    {
        Fails(() => Exact(new Picture(2, 1, [float.NaN, 1, 1, 1, 1, 1]), new Picture(2, 1, [1, 1, 1, 1, 1, 1])));
        Assert.Equal([1, 0, 1, 128f / 255, 128f / 255, 128f / 255], ImageFile.Read(Path.Combine(Failure, "difference.png"), raw: true).Pixels);
    }

    [Fact]
    public void A_second_failure_rewrites_the_folder_and_spares_what_is_not_its_own()
    {
        Picture reference = TestPictures.Noise(16, 12);
        Fails(() => ImageAssert.Matches(Changed(reference, 0, v => v + 1), reference, ImageRule.Exact, Name, ReplayScene.Text("{}"), _folder.Path));
        File.WriteAllText(Path.Combine(Failure, "notes.txt"), "mine");
        Fails(() => ImageAssert.Matches(new Picture(3, 2), new Picture(2, 3), ImageRule.Exact, Name, output: _folder.Path));
        Assert.Equal(["image.pfm", "image.png", "index.html", "notes.txt", "reference.pfm", "reference.png"], Files());
        Assert.Equal(3, Read("image.pfm").Width);
    }

    [Fact]
    public void A_folder_that_cannot_be_written_is_named_and_the_finding_stays()
    {
        File.WriteAllText(Failure, "a file where the folder should be");
        string message = Fails(() => Exact(new Picture(1, 1, [1, 1, 1]), new Picture(1, 1)));
        Assert.Contains("1 of 1 pixels have other bits", message, StringComparison.Ordinal);
        Assert.Contains($"no pictures, for '{Failure}' cannot be written", message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_command_of_a_failure_renders_the_worst_pixel_again(bool asText)
    {
        string path = _folder["it's a scene.json"];
        File.WriteAllText(path, CliRun.Scene);
        ReplayScene scene = asText ? ReplayScene.Text(CliRun.Scene, "--seed", "7") : ReplayScene.File(path, "--seed", "7");
        Film film = new RTracer(SceneRuns.Load(path, d => d with { Render = d.Render with { Seed = 7 } })).Render().Film;
        float[] row = new float[3 * film.Width];
        film.ReadRow(9, row);
        Picture reference = new(film.Width, film.Height);
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(y, reference.Pixels.AsSpan(3 * y * film.Width, 3 * film.Width));
        }

        reference.Pixels[(3 * ((9 * film.Width) + 13)) + 2] += 1000;
        string message = Fails(() => ImageAssert.Matches(film, reference, ImageRule.Within(0.1), Name, scene, _folder.Path));

        CliRun run = CliRun.Of([.. Words(message), "--json"]);
        Assert.Equal((0, ""), (run.Status, run.Error));
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal((13, 9), (json.GetProperty("x").GetInt32(), json.GetProperty("y").GetInt32()));
        Assert.Equal(row[39..42], json.GetProperty("radiance").EnumerateArray().Select(v => v.GetSingle()));
        Assert.Equal(asText, Files().Contains("scene.json"));
    }

    [Fact]
    public void A_missing_reference_fails_until_it_is_approved()
    {
        string path = _folder["new reference.pfm"];
        Picture image = TestPictures.Noise(12, 12);
        string message = Fails(() => ImageAssert.MatchesFile(image, path, ImageRule.Exact, output: _folder.Path, update: false));
        Assert.Contains("no such file", message, StringComparison.Ordinal);
        Assert.Contains("RAYTRACER_UPDATE=1", message, StringComparison.Ordinal);
        TestPictures.AssertSameBits(image, ImageFile.Read(Path.Combine(_folder["new_reference"], "image.pfm")));
        Assert.False(File.Exists(path));

        ImageAssert.MatchesFile(image, path, ImageRule.Exact, output: _folder.Path, update: true);
        ImageAssert.MatchesFile(image, path, ImageRule.Exact, output: _folder.Path, update: false);
        Fails(() => ImageAssert.MatchesFile(Changed(image, 0, v => v + 1), path, ImageRule.Exact, output: _folder.Path, update: false));
    }

    [Fact]
    public void Failures_go_to_the_folder_of_the_project_that_git_ignores()
    {
        if (Environment.GetEnvironmentVariable("RAYTRACER_TEST_OUTPUT") is null)
        {
            Assert.Equal(ProjectFolder.PathOf("artifacts", "test-failures"), FailureFolder.Default);
        }

        Assert.Contains("/artifacts/", File.ReadAllLines(ProjectFolder.PathOf(".gitignore")));
    }

    private void Exact(Picture image, Picture reference) => ImageAssert.Matches(image, reference, ImageRule.Exact, Name, output: _folder.Path);

    private static string Fails(Action assertion) => Assert.Throws<FailException>(assertion).Message;

    private Picture Read(string file) => ImageFile.Read(Path.Combine(Failure, file));

    private string[] Files() => [.. Directory.GetFiles(Failure).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal)];

    private static Picture Changed(Picture picture, int index, Func<float, float> change)
    {
        Picture changed = new(picture.Width, picture.Height, [.. picture.Pixels]);
        changed.Pixels[index] = change(changed.Pixels[index]);
        return changed;
    }

    private static ImageRule Rule(string name) => name switch
    {
        "exact" => ImageRule.Exact,
        "tolerance" => ImageRule.Within(1e-3, 1e-3),
        _ => ImageRule.LooksLike(0.99),
    };

    // The words after "--", as a POSIX shell would take them apart.
    private static string[] Words(string message)
    {
        string line = message.Split('\n').Single(l => l.StartsWith("replay the worst pixel: ", StringComparison.Ordinal));
        string command = line[(line.IndexOf(" -- ", StringComparison.Ordinal) + 4)..];
        List<string> words = [""];
        bool quoted = false;
        for (int i = 0; i < command.Length; i++)
        {
            switch (command[i])
            {
                case '\'':
                    quoted = !quoted;
                    break;
                case '\\' when !quoted:
                    words[^1] += command[++i];
                    break;
                case ' ' when !quoted:
                    words.Add("");
                    break;
                default:
                    words[^1] += command[i];
                    break;
            }
        }

        return [.. words];
    }
}
