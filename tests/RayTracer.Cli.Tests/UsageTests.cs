using System.Text;
using System.Text.RegularExpressions;
using RayTracer.Cli;

namespace RayTracer.Cli.Tests;

public sealed class UsageTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public UsageTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("rendr", "unknown verb \"rendr\" (did you mean \"render\"?)")]
    [InlineData("--foo", "unknown option \"--foo\"")]
    [InlineData("render --sp 4 SCENE", "unknown option \"--sp\" (did you mean \"--spp\"?)")]
    [InlineData("render SCENE --hieght 4", "unknown option \"--hieght\" (did you mean \"--height\"?)")]
    [InlineData("render SCENE more -o a.png", "unexpected argument \"more\"")]
    [InlineData("rendr SCENE -o a.png --quiet", "unknown verb \"rendr\" (did you mean \"render\"?)")]
    [InlineData("cluster slrm SCENE -o a.png", "unknown verb \"slrm\" (did you mean \"slurm\"?)")]
    [InlineData("render SCENE -o", "-o FILE: the value is missing")]
    [InlineData("render --spp", "--spp N: the value is missing")]
    [InlineData("render -o a.png", "SCENE is missing: the scene file")]
    [InlineData("compare a.png", "IMAGE is missing: the image to judge, and the reference")]
    [InlineData("render SCENE -o a.png --noise 5", "--noise 5: must be above 0 and below 100%, but is 5 (5%?)")]
    [InlineData("render SCENE -o a.png --exr-type uint", "expected one of half, float")]
    [InlineData("render SCENE -o a.png --spp 0", "--spp 0: must be from 1 to 16777216, but is 0")]
    [InlineData("render SCENE -o a.png --seed -1", "--seed -1: must be from 0 to 4294967295, but is -1")]
    [InlineData("render SCENE -o a.png --width wide", "--width wide: expected a whole number, not \"wide\"")]
    [InlineData("render SCENE -o a.png --threads 0", "--threads 0: must be from 1 to 1024, but is 0")]
    [InlineData("render SCENE -o a.png --exposure NaN", "--exposure NaN: must be from -100 to 100, but is NaN")]
    [InlineData("render SCENE -o a.png --sampler jitterd", "unknown value \"jitterd\" (did you mean \"jittered\"?), expected one of sobol, jittered")]
    [InlineData("render SCENE -o a.png --tonemap 3", "unknown value \"3\", expected one of clamp, soft, reinhard, aces, agx")]
    [InlineData("render SCENE -o a.png --lanes 4", "--lanes 4: 8 or 16 is expected")]
    [InlineData("check SCENE --lanes 8", "unknown option \"--lanes\"")]
    [InlineData("render SCENE -o a.png --bit-depth 12", "expected one of 8, 16")]
    [InlineData("render SCENE -o a.jpg --quality 0", "--quality 0: must be from 1 to 100, but is 0")]
    [InlineData("render SCENE -o a.jpg --chroma ful", "unknown value \"ful\" (did you mean \"full\"?), expected one of full, half")]
    [InlineData("render SCENE -o a.png --noise little", "--noise little: expected a number, as in 1% or 0.01, not \"little\"")]
    [InlineData("render SCENE -o a.png --noise 0", "--noise 0: must be above 0 and below 100%, but is 0")]
    [InlineData("render SCENE -o a.png --noise 1", "--noise 1: must be above 0 and below 100%, but is 1 (1%?)")]
    [InlineData("render SCENE -o a.png --time 1h30", "--time 1h30: expected a time, as in 90s, 10m, 1.5h or 1h30m, not \"1h30\"")]
    [InlineData("render SCENE -o a.png --time 0m", "--time 0m: must be above 0")]
    [InlineData("render SCENE -o a.png --checkpoint-interval 5x", "--checkpoint-interval 5x: expected a time")]
    [InlineData("render SCENE -o a.png --quiet --verbose", "--quiet and --verbose cannot go together")]
    [InlineData("merge a.rtfilm -o a.png --quiet --verbose", "--quiet and --verbose cannot go together")]
    [InlineData("render SCENE -o EMPTY", "-o FILE: the word is empty")]
    [InlineData("resume EMPTY", "FILE: the word is empty")]
    [InlineData("resume a.rtfilm -o EMPTY", "-o FILE: the word is empty")]
    [InlineData("cluster slurm EMPTY", "SCENE: the word is empty")]
    [InlineData("cluster slurm SCENE --tasks 2 -o a.png --folder EMPTY", "--folder FOLDER: the word is empty")]
    [InlineData("verify EMPTY", "FILE: the word is empty")]
    [InlineData("view EMPTY", "IMAGE: the word is empty")]
    [InlineData("convert SCENE EMPTY", "TO: the word is empty")]
    [InlineData("render SCENE -o a.png --crop 1,2,3", "--crop 1,2,3: expected x,y,w,h")]
    [InlineData("render SCENE -o a.png --crop 1,2,3,-4", "--crop 1,2,3,-4: expected x,y,w,h")]
    [InlineData("render SCENE --set -o v.png", "--set -o: expected \"=\" and a value")]
    [InlineData("render -- -x.json --width 9", "unexpected argument \"--width\": options must come before the word --")]
    public void Wrong_words_get_one_line_and_the_usage(string line, string message)
    {
        CliRun run = CliRun.Of([.. line.Replace("SCENE", _scene, StringComparison.Ordinal).Split(' ').Select(w => w == "EMPTY" ? "" : w)]);
        string[] lines = run.Error.TrimEnd().Split(Environment.NewLine);
        Assert.Equal(2, run.Status);
        Assert.StartsWith("raytracer: error: ", lines[0]);
        Assert.Contains(message, lines[0], StringComparison.Ordinal);
        Assert.StartsWith("usage: raytracer ", lines[1]);
        Assert.Equal(2, lines.Length);
        Assert.Empty(run.Output);
    }

    [Theory]
    [InlineData("", "a verb is expected")]
    [InlineData("render SCENE", "where to? Give -o FILE")]
    [InlineData("render SCENE -o a.pgn", "the extension '.pgn' is none of .png, .jpg, .jpeg, .pfm, .exr, .hdr, .rtfilm (did you mean '.png'?)")]
    [InlineData("render SCENE -o OUT --crop 20,0,5,5", "--crop 20,0,5,5: is not within the picture of 24×16 pixels")]
    [InlineData("render SCENE -o OUT --crop 2147483647,0,5,5", "is not within the picture")]
    [InlineData("render SCENE -o OUT --crop 0,0,0,5", "is not within the picture")]
    [InlineData("render SCENE -o OUT --spp 15 --sampler jittered", "--spp 15: the jittered sampler needs a square number of samples")]
    [InlineData("render SCENE --pixel 24,0", "--pixel 24,0: is not within the picture of 24×16 pixels")]
    [InlineData("render SCENE --pixel 0,0 --sample 4", "--sample 4: the pixels have only samples 0 to 3")]
    [InlineData("render SCENE -o OUT --sample 4", "--sample needs --pixel")]
    [InlineData("render SCENE --pixel 0,0 --noise 1%", "leave --noise and --adaptive out")]
    [InlineData("render SCENE -o OUT --adaptive --crop 0,0,8,8", "leave --crop out")]
    [InlineData("render SCENE -o OUT --adaptive --spp 16 --sampler jittered", "--adaptive: the pattern of the jittered sampler needs the number of samples in advance")]
    [InlineData("render SCENE -o OUT --noise 2% --sampler regular", "--noise: the pattern of the regular sampler needs the number of samples in advance")]
    [InlineData("render SCENE -o OUT --pixel 0,0", "--pixel prints numbers and writes no image")]
    public void Wrong_requests_get_one_line(string line, string message)
    {
        string[] words = line.Replace("SCENE", _scene, StringComparison.Ordinal).Replace("OUT", _folder["a.png"], StringComparison.Ordinal).Split(' ', StringSplitOptions.RemoveEmptyEntries);
        CliRun run = CliRun.Of(words);
        Assert.Equal(2, run.Status);
        Assert.Contains(message, Assert.Single(run.Error.TrimEnd().Split(Environment.NewLine)), StringComparison.Ordinal);
        Assert.False(File.Exists(_folder["a.png"]));
    }

    [Fact]
    public void After_two_dashes_all_words_are_names()
    {
        CliRun run = CliRun.Of("view", "--columns", "4", "--", "-o.png");
        Assert.Equal(4, run.Status);
        Assert.Contains("Cannot read the picture '-o.png': there is no such file", run.Error, StringComparison.Ordinal);

        Assert.Equal(0, CliRun.Of("render", "-o", _folder["a.png"], "--quiet", "--", _scene).Status);
        Assert.Equal(0, CliRun.Of("verify", _folder["a.png"]).Status);
    }

    [Theory]
    [InlineData("--exposure 3", "--exposure has no effect: it is for PNG and JPEG files, and none is written")]
    [InlineData("--tonemap aces", "--tonemap has no effect: it is for PNG and JPEG files, and none is written")]
    [InlineData("--chroma half", "--chroma has no effect: it is for JPEG files, and none is written")]
    [InlineData("--checkpoint-interval 5", "--checkpoint-interval has no effect: there are no checkpoints without --checkpoint FILE")]
    [InlineData("--frames 3 --fps 5", "--fps has no effect: it is for animated PNGs (-o FILE.png or FILE.apng), and none is written")]
    public void Options_without_effect_are_reported(string options, string message) =>
        Assert.Equal(new CliRun(0, "", $"raytracer: warning: {message}{Environment.NewLine}"), CliRun.Of(["render", _scene, "-o", _folder["a.exr"], "--quiet", .. options.Split(' ')]));

    [Fact]
    public void Options_with_effect_on_one_of_the_files_are_not() =>
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of("render", _scene, "-o", _folder["a.exr"], "-o", _folder["a.jpg"], "--quiet", "--exposure", "3", "--quality", "50"));

    [Fact]
    public void A_name_that_is_too_long_is_found_before_the_scene_is_read()
    {
        CliRun run = CliRun.Of("render", _folder["missing.json"], "-o", _folder[$"{new string('a', 252)}.png"]);
        Assert.Equal(4, run.Status);
        Assert.Contains("its name is too long", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_missing_folder_is_found_before_the_scene_is_read()
    {
        CliRun run = CliRun.Of("render", _folder["missing.json"], "-o", _folder["missing/a.png"]);
        Assert.Equal(4, run.Status);
        Assert.Contains("does not exist", run.Error, StringComparison.Ordinal);
    }

    [LinuxFact]
    public void A_folder_that_is_not_writable_is_found_before_the_scene_is_read()
    {
        CliRun run = CliRun.Of("render", _folder["missing.json"], "-o", "/proc/a.png");
        Assert.Equal(4, run.Status);
        Assert.StartsWith("raytracer: error: Cannot write '/proc/a.png': ", run.Error);
    }

    [Fact]
    public void A_picture_that_no_memory_holds_is_refused()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"], "--width", "65536", "--height", "65536");
        Assert.Equal(4, run.Status);
        Assert.Contains("65536×65536 pixels takes 400 GiB of memory", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--help", "70 internal error, 129 SIGHUP, 130 Ctrl-C")]
    [InlineData("render --help", "--max-specular-depth")]
    [InlineData("--version", "lanes)")]
    [InlineData("schema", "https://json-schema.org/draft/2020-12/schema")]
    [InlineData("reference", "# The scene format")]
    public void Help_and_pages_are_printed(string line, string expected)
    {
        CliRun run = CliRun.Of(line.Split(' '));
        Assert.Equal(0, run.Status);
        Assert.Contains(expected, run.Output, StringComparison.Ordinal);
        Assert.Empty(run.Error);
    }

    [Fact]
    public void An_internal_error_is_one_line_that_names_the_file_with_its_details()
    {
        using StringWriter error = new();
        using BrokenWriter broken = new();
        Assert.Equal(70, CommandLine.Run(["schema"], new(broken, error)));
        Match match = Regex.Match(error.ToString(), "^raytracer: error: internal error: first second \\(details in (.*)\\)\r?\n$");
        Assert.True(match.Success, error.ToString());
        string details = File.ReadAllText(match.Groups[1].Value);
        File.Delete(match.Groups[1].Value);
        Assert.Contains(nameof(BrokenWriter), details, StringComparison.Ordinal);
    }

    private sealed class BrokenWriter : TextWriter
    {
        public override Encoding Encoding => Encoding.UTF8;

        public override void Write(string? value) => throw new InvalidOperationException("first\nsecond");
    }
}
