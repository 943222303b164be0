using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

/// <summary>Settings of pictures.</summary>
public sealed class PictureSettingTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Both_spellings_of_an_integrator_make_the_same_picture_and_its_settings_say_so()
    {
        string scene = _folder["scene.json"];
        File.WriteAllText(scene, CliRun.Scene);
        CliRun.Fine("render", scene, "--integrator", "volPath", "--spp", "2", "-o", _folder["a.png"]);
        Assert.Equal("""["render.samplesPerPixel=2","render.integrator=volPath"]""", string.Concat(ImageFile.ReadText(_folder["a.png"]).Where(t => t.Key == "Settings").Select(t => t.Value)));
        CliRun.Fine("verify", _folder["a.png"]);
        Assert.Equal(CliRun.FilmHash("render", scene, "--json", "--integrator", "volPath"), CliRun.FilmHash("render", scene, "--json", "--set", "render.integrator=volpath"));
    }
}
