namespace RayTracer.Jobs.Tests;

/// <summary><see cref="JobOptions"/> and the words of their values.</summary>
public sealed class JobOptionTests
{
    [Theory]
    [InlineData("--spp", "8", "render.samplesPerPixel=8")]
    [InlineData("--integrator", "volpath", "render.integrator=volPath")]
    [InlineData("--integrator", "volPath", "render.integrator=volPath")]
    [InlineData("--set", "camera.fieldOfView=35", "camera.fieldOfView=35")]
    [InlineData("--crop", "1,2,3,4", "crop=1,2,3,4")]
    [InlineData("--noise", "1%", "noise=0.01")]
    [InlineData("--tonemap", "aces", "tonemap=aces")]
    [InlineData("--aov", "depth,lights", "aov=depth,lights")]
    [InlineData("--time", "2m", "time=120s")]
    [InlineData("--samples", "3..7", "samples=3..7")]
    [InlineData("--denoise", "true", "denoise=true")]
    public void An_option_is_short_for_a_setting_that_pictures_keep(string option, string value, string setting)
    {
        RenderJob job = JobOptions.Find(option)!.Put(new() { Scene = "a.json" }, value);
        Assert.Equal([setting], job.PictureSettings);
        Assert.Equal([setting], new RenderJob { Scene = "b.json" }.With(job.PictureSettings).PictureSettings);
        Assert.Equal([setting], OldFilms.OfWords(Shell.Words(job.Command)[2..], "a").PictureSettings);
    }

    [Fact]
    public void No_option_has_the_name_of_a_part_of_scenes() =>
        Assert.Empty(JobOptions.All.Select(o => o.Name[2..]).Intersect(Description.RecordType.Of(typeof(Description.SceneDescription)).Parameters.Select(p => p.Key)));

    [Theory]
    [InlineData("--spp", "0", "must be")]
    [InlineData("--spp", "many", "expected a whole number, not \"many\"")]
    [InlineData("--sampler", "sobl", "did you mean \"sobol\"?")]
    [InlineData("--crop", "1,2,3", "expected x,y,w,h, whole numbers not below 0")]
    [InlineData("--crop", "1,2,3,-4", "expected x,y,w,h, whole numbers not below 0")]
    [InlineData("--noise", "100%", "must be above 0 and below 100%")]
    [InlineData("--noise", "little", "expected a number, as in 1% or 0.01")]
    [InlineData("--part", "3/2", "expected which part of how many")]
    [InlineData("--samples", "7..3", "expected the first and the last sample")]
    [InlineData("--time", "soon", "expected a time, as in 90s")]
    [InlineData("--time", "0s", "must be above 0")]
    [InlineData("--time", "1x", "expected a time, as in 90s")]
    [InlineData("--exposure", "1000", "must be from -100 to 100")]
    [InlineData("--aov", "depth,dept", "did you mean \"depth\"?")]
    [InlineData("--frames", "5..3", "expected frames, from 0")]
    [InlineData("--frames", "0..99999999", "frames are numbered up to 9999999")]
    [InlineData("--set", "camera", "PATH=VALUE")]
    public void A_wrong_value_is_refused_with_what_was_expected(string option, string value, string message)
    {
        FormatException fault = Assert.Throws<FormatException>(() => JobOptions.Find(option)!.Put(new() { Scene = "a.json" }, value));
        Assert.Contains(message, fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("90", 90)]
    [InlineData("90s", 90)]
    [InlineData("10m", 600)]
    [InlineData("1.5h", 5400)]
    [InlineData("1h30m", 5400)]
    [InlineData("2d", 172_800)]
    public void A_time_is_read_in_units(string word, double seconds) => Assert.Equal(TimeSpan.FromSeconds(seconds), OptionWords.Duration(word));

    [Theory]
    [InlineData("7", "7")]
    [InlineData("0..9", "0,1,2,3,4,5,6,7,8,9")]
    [InlineData("0..9:4", "0,4,8")]
    [InlineData("2..10:4", "2,6,10")]
    public void Frames_are_written_as_they_are_read(string word, string numbers)
    {
        FrameRange frames = FrameRange.Parse(word);
        Assert.Equal((word, numbers), (frames.ToString(), string.Join(',', frames.Numbers)));
    }

    [Theory]
    [InlineData("f-####.png", 7, "f-0007.png")]
    [InlineData("f-#.png", 12, "f-12.png")]
    [InlineData("#/f-##.png", 3, "#/f-03.png")]
    [InlineData("f.png", 3, "f.png")]
    public void A_frame_stands_in_the_last_signs_of_a_name(string pattern, int frame, string name) => Assert.Equal(name, FrameRange.Name(pattern, frame));

    [Theory]
    [InlineData("a b", "'a b'")]
    [InlineData("it's", "'it'\\''s'")]
    [InlineData("a=1,2", "a=1,2")]
    [InlineData("", "''")]
    public void Words_are_quoted_for_a_shell_and_read_again(string word, string quoted)
    {
        string command = Shell.Command(["render", word, "b"]);
        Assert.Equal($"raytracer render {quoted} b", command);
        Assert.Equal(["raytracer", "render", word, "b"], Shell.Words(command));
    }
}
