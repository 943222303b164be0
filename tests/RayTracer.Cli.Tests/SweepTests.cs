using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

/// <summary><c>raytracer sweep</c>.</summary>
public sealed class SweepTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public SweepTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void One_wrong_combination_leaves_the_other_pictures()
    {
        string sheet = _folder["sheet.pfm"];
        CliRun run = CliRun.Of("sweep", _scene, "--set", "camera.position=[0,1,5],[1,1,5]", "--set", "camera.lookAt=[0,0.5,0],[1,1,5]", "--spp", "1", "-o", sheet, "--quiet");
        Assert.Equal(3, run.Status);
        Assert.Contains("these errors are with camera.position=[1,1,5] camera.lookAt=[1,1,5]", run.Error, StringComparison.Ordinal);
        Assert.True(File.Exists(sheet));
    }

    [Fact]
    public void Labels_fit_beside_the_flattest_pictures() =>
        Assert.Equal(0, CliRun.Of("sweep", _scene, "--set", "shapes[0].radius=0.5,1", "--set", "camera.fieldOfView=20,30", "--spp", "1", "--width", "1600", "--height", "4", "-o", _folder["flat.png"], "--quiet").Status);

    [Fact]
    public void A_sheet_has_the_picture_of_each_place()
    {
        string sheet = _folder["sheet.pfm"];
        CliRun run = CliRun.Of("sweep", _scene, "--set", "camera.fieldOfView=20, 60", "--set", "shapes[0].center=[0,0.5,0],[1,0.5,0],[0,1,1]", "--set", "render.seed=3", "-o", sheet, "--json", "--quiet");
        Assert.Equal((0, ""), (run.Status, run.Error));
        JsonElement[] films = [.. JsonDocument.Parse(run.Output).RootElement.GetProperty("films").EnumerateArray()];
        Assert.Equal(6, films.Length);
        Assert.Equal("60", films[1].GetProperty("settings").GetProperty("camera.fieldOfView").GetString());
        Picture whole = ImageFile.Read(sheet);
        for (int i = 0; i < 6; i++)
        {
            string[] set = [.. films[i].GetProperty("settings").EnumerateObject().SelectMany(s => new[] { "--set", $"{s.Name}={s.Value.GetString()}" })];
            CliRun one = CliRun.Of(["render", _scene, "--seed", "3", "-o", _folder["one.pfm"], "--json", "--quiet", .. set]);
            Assert.Equal(films[i].GetProperty("filmHash").GetString(), JsonDocument.Parse(one.Output).RootElement.GetProperty("filmHash").GetString());
            Picture picture = ImageFile.Read(_folder["one.pfm"]);
            int left = whole.Width - ((2 - (i % 2)) * (24 + 8));
            int top = whole.Height - ((3 - (i / 2)) * (16 + 8));
            Assert.Equal(Math.Min(1, picture.Pixels[0]), whole.Pixels[3 * ((top * whole.Width) + left)]);
            Assert.Equal(Math.Min(1, picture.Pixels[^1]), whole.Pixels[(3 * (((top + 15) * whole.Width) + left + 23)) + 2]);
        }
    }

    [Fact]
    public void Pictures_have_the_size_that_is_asked_for()
    {
        string sheet = _folder["sheet.png"];
        Assert.Equal(0, CliRun.Of("sweep", _scene, "--set", "camera.fieldOfView=20,60", "-o", sheet, "--cell", "48", "--spp", "1").Status);
        Picture large = ImageFile.Read(sheet);
        Assert.Equal((8 + (2 * 56), 8 + 20 + 40), (large.Width, large.Height));
        Assert.Equal(0, CliRun.Of("sweep", _scene, "--set", "camera.fieldOfView=20,60", "-o", sheet, "--width", "10", "--height", "8", "--spp", "1").Status);
        Picture small = ImageFile.Read(sheet);
        Assert.Equal((8 + (2 * 18), 8 + 20 + 16), (small.Width, small.Height));
        foreach (string[] size in new[] { ["--width", "12"], new[] { "--scale", "50%" } })
        {
            CliRun.Fine(["sweep", _scene, "--set", "camera.fieldOfView=20,60", "-o", sheet, "--spp", "1", .. size]);
            Picture derived = ImageFile.Read(sheet);
            Assert.Equal((8 + (2 * 20), 8 + 20 + 16), (derived.Width, derived.Height));
        }

        CliRun.Refused(2, "--scale and --width", "sweep", _scene, "--set", "render.seed=1,2", "-o", sheet, "--scale", "50%", "--width", "8");
    }

    [Theory]
    [InlineData(2, "what should change? Give --set PATH=VALUE,VALUE,…", "camera.fieldOfView=20")]
    [InlineData(2, "at most 3 lists of values: as columns, as rows and as blocks of rows, but there are 4", "render.seed=1,2", "camera.fieldOfView=20,30", "shapes[0].radius=1,2", "shapes[2].radius=1,2")]
    [InlineData(3, "\"fieldOfView\" must be from 0.001 to 179, but is 300", "camera.fieldOfView=20,300")]
    [InlineData(3, "(did you mean \"fieldOfView\"?)", "camera.fieldOfVew=20,30")]
    [InlineData(2, "pictures of 20×10 and of 40×10 pixels do not fit one grid: give --width and --height", "render.width=20,40", "render.height=10")]
    public void What_makes_no_sheet_is_refused_before_anything_is_rendered(int status, string message, params string[] settings)
    {
        CliRun run = CliRun.Of(["sweep", _scene, "-o", _folder["a.png"], .. settings.SelectMany(s => new[] { "--set", s })]);
        Assert.Equal((status, ""), (run.Status, run.Output));
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("1 of", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(_folder["a.png"]));
    }

    [Fact]
    public void Labels_stand_beside_and_above()
    {
        ContactSheet sheet = new(new("seed", ["1", "2"]), new("radius", ["0.5"]), new("bounces", ["3", "4"]), 20, 10);
        Assert.Equal((36 + 8 + 7 + (2 * 28), 8 + (2 * (30 + 18))), (sheet.Picture.Width, sheet.Picture.Height));
        int marks = Enumerable.Range(0, sheet.Picture.Width * sheet.Picture.Height).Count(i => sheet.Picture.Pixels[3 * i] > 0.5f);
        Assert.InRange(marks, 100, 1000);
        Assert.Throws<ArgumentException>(() => new ContactSheet(new("a", ["1", "2"]), SheetAxis.None, SheetAxis.None, 20_000, 20_000));
    }
}
