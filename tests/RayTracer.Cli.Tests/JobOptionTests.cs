using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Cli.Tests;

/// <summary><see cref="JobOptions"/>, <see cref="JobRules"/> and the settings of pictures.</summary>
public sealed class JobOptionTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

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

    [Fact]
    public void Both_spellings_of_an_integrator_make_the_same_picture_and_its_settings_tell()
    {
        string scene = _folder["scene.json"];
        File.WriteAllText(scene, CliRun.Scene);
        CliRun.Fine("render", scene, "--integrator", "volPath", "--spp", "2", "-o", _folder["a.png"]);
        Assert.Equal("""["render.samplesPerPixel=2","render.integrator=volPath"]""", string.Concat(ImageFile.ReadText(_folder["a.png"]).Where(t => t.Key == "Settings").Select(t => t.Value)));
        CliRun.Fine("verify", _folder["a.png"]);
        Assert.Equal(CliRun.FilmHash("render", scene, "--json", "--integrator", "volPath"), CliRun.FilmHash("render", scene, "--json", "--set", "render.integrator=volpath"));
    }
}
