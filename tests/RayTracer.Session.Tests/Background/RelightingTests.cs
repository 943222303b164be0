using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Session;
using RayTracer.Textures;

namespace RayTracer.Session.Tests;

/// <summary>The lights of a picture are rendered and balanced as the command renders and composes them.</summary>
public sealed class RelightingTests
{
    [Fact]
    public async Task A_balanced_picture_is_the_one_that_its_command_names()
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped("report/scene1.json", 24, 4);
        string layers = Path.Combine(test.Folder, "lights.exr");
        await Done(test, () => test.Session.Lights.Render(layers, overwrite: false));
        Dictionary<string, string> texts = new(ImageFile.ReadText(layers));
        Assert.Equal((new Rendering.RTracer(shown.Scene).Render().Film.ComputeHash(), """["aov=lights"]"""), (texts["FilmHash"], texts["Settings"]));

        string light = test.Session.Lights.Open(layers)[0];
        string balanced = Path.Combine(test.Folder, "balanced.pfm");
        await Done(test, () => test.Session.Lights.Save(balanced, new Dictionary<string, float[]> { [light] = [2, 0.5f, 0] }, overwrite: false));
        RelightableImage mix = RelightableImage.Open(await File.ReadAllBytesAsync(layers));
        Picture expected = mix.Compose(name => name == light ? new(2, 0.5f, 0) : new(1, 1, 1));
        Assert.Equal(Rows(expected), Rows(ImageFile.Read(balanced)));

        string shownPicture = Path.Combine(test.Folder, "balanced.png");
        await Done(test, () => test.Session.Lights.Save(shownPicture, new Dictionary<string, float[]> { [light] = [2, 0.5f, 0] }, overwrite: false));
        string command = new Dictionary<string, string>(ImageFile.ReadText(shownPicture))["Command"];
        Assert.Equal(["raytracer", "compose", layers, "--light", $"{light}=2,0.5,0", "-o", shownPicture], Shell.Words(command));
    }

    private static float[] Rows(IImageRows image)
    {
        float[] rows = new float[3 * image.Width * image.Height];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, rows.AsSpan(3 * image.Width * y, 3 * image.Width));
        }

        return rows;
    }

    private static async Task Done(TestSession test, Func<int> start)
    {
        int before = test.Session.Notices.Newest?.Id ?? 0;
        start();
        Notice notice = await test.Until(() => test.Session.Jobs.Running.Count == 0 && test.Session.Notices.Newest is { } newest && newest.Id > before ? newest : null);
        Assert.True(notice.Kind == "info", notice.Text);
    }
}
