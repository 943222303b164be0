using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Session;
using RayTracer.Textures;

namespace RayTracer.Session.Tests;

public sealed class PictureSaverTests
{
    [Theory]
    [InlineData("a.png", 8)]
    [InlineData("a.png", 16)]
    [InlineData("a.pfm", 8)]
    [InlineData("a.exr", 8)]
    public async Task A_picture_is_written_as_the_command_writes_it(string name, int bitDepth)
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped("report/scene1.json", 40, 4);
        await test.Done();
        test.Session.View.Tone = new(0.5f, ToneMap.Reinhard);
        string path = Path.Combine(test.Folder, name);
        await Save(test, path, bitDepth);
        Film film = new RTracer(shown.Scene).Render().Film;
        string expected = Path.Combine(test.Folder, "expected" + Path.GetExtension(name));
        ImageFile.Write(expected, film, new() { BitDepth = bitDepth, Exposure = 0.5f, ToneMap = ToneMap.Reinhard, Metadata = [.. ImageFile.ReadText(path)] });
        Assert.Equal(await File.ReadAllBytesAsync(expected), await File.ReadAllBytesAsync(path));
        if (!name.EndsWith(".pfm", StringComparison.Ordinal))
        {
            Dictionary<string, string> texts = new(ImageFile.ReadText(path));
            Assert.Equal(["Command", "FilmHash", "SampleRange", "Samples", "Scene", "Settings", "Software", "Tone"], texts.Keys.Order());
            Assert.Equal("reinhard 0.5", texts["Tone"]);
            Assert.Equal((film.ComputeHash(), "4"), (texts["FilmHash"], texts["Samples"]));
        }
    }

    [Fact]
    public async Task Beside_the_scenes_camera_the_cameras_picture_is_written_unless_the_view_is_asked_for()
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped("report/scene1.json", 40, 4);
        string scenes = Film(shown);
        test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.2f));
        await test.Done();
        string path = Path.Combine(test.Folder, "a.png");
        await Save(test, path, 8);
        Assert.Equal(scenes, new Dictionary<string, string>(ImageFile.ReadText(path))["FilmHash"]);
        await test.Session.Pictures.Save(test.Session.Pictures.Job(path, 8), overwrite: true, asSeen: true);
        await test.Until(() => test.Session.Jobs.Running.Count == 0 ? test : null);
        Assert.Equal(Film(test.Session.View.Shown!), new Dictionary<string, string>(ImageFile.ReadText(path))["FilmHash"]);
        Assert.NotEqual(Film(shown), Film(test.Session.View.Shown!));
        string film = Path.Combine(test.Folder, "a.rtfilm");
        await Assert.ThrowsAsync<SessionException>(() => test.Session.Pictures.Save(test.Session.Pictures.Job(film), overwrite: true, asSeen: true));
        await Save(test, film, null);
        Assert.True(File.Exists(film));

        static string Film(ViewportScene shown) => new RTracer(shown.Scene).Render().Film.ComputeHash();
    }

    [Fact]
    public async Task Layers_go_into_an_exr_and_beside_a_png()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene1.json", 40, 4);
        await test.Done();
        await Save(test, Path.Combine(test.Folder, "a.png"), null, "depth", "samples");
        Assert.True(File.Exists(Path.Combine(test.Folder, "a.depth.png")));
        byte[] plain = await test.Session.Pictures.Encode(test.Session.Pictures.Job("a.exr"), default);
        byte[] layered = await test.Session.Pictures.Encode(test.Session.Pictures.Job("a.exr", null, "depth", "samples"), default);
        Assert.DoesNotContain("depth.Z", System.Text.Encoding.Latin1.GetString(plain), StringComparison.Ordinal);
        Assert.Contains("depth.Z", System.Text.Encoding.Latin1.GetString(layered), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Files_are_not_replaced_unasked_and_nonsense_is_refused()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene1.json", 20, 1);
        await test.Done();
        string path = Path.Combine(test.Folder, "a.png");
        await File.WriteAllTextAsync(path, "mine");
        Assert.Equal(SessionFault.Exists, (await Assert.ThrowsAsync<SessionException>(() => test.Session.Pictures.Save(test.Session.Pictures.Job(path), overwrite: false))).Fault);
        Assert.Equal("mine", await File.ReadAllTextAsync(path));
        await Assert.ThrowsAsync<JobException>(() => test.Session.Pictures.Save(test.Session.Pictures.Job(Path.Combine(test.Folder, "a.gif")), false));
        await Assert.ThrowsAsync<ImageWriteException>(() => test.Session.Pictures.Save(test.Session.Pictures.Job(Path.Combine(test.Folder, "no", "a.png")), false));
        JobException films = await Assert.ThrowsAsync<JobException>(() => test.Session.Pictures.Save(test.Session.Pictures.Job("a.rtfilm", null, "depth"), false));
        Assert.Equal("--aov and --denoise write images, but only films are written: give -o FILE.png or another image too", films.Message);
        Assert.Throws<SessionException>(() => test.Session.Pictures.Job("a.png", 12));
        Assert.Throws<SessionException>(() => test.Session.Pictures.Job("a.png", 8, "beauty"));
    }

    [Fact]
    public async Task The_command_says_what_differs_from_the_scene()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene1.json", 20, 4);
        Assert.Equal("raytracer render test.json -o test.png", test.Session.Pictures.Command());
        test.Session.View.Change(s => s with { Samples = 9, Region = new(1, 2, 3, 4) });
        test.Session.View.Tone = new(-1.5f, ToneMap.Aces);
        Assert.Equal("raytracer render test.json --spp 9 --exposure -1.5 --tonemap aces --crop 1,2,3,4 -o 'a b.exr'", test.Session.Pictures.Command("a b.exr"));
    }

    [Fact]
    public async Task Snapshots_keep_what_was_seen()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene1.json", 20, 4);
        await test.Done();
        Snapshot snapshot = await test.Session.Snapshots.Capture();
        byte[] before = test.Session.Snapshots.Png(snapshot.Id);
        test.Session.View.Tone = new(3, ToneMap.Clamp);
        await test.Session.Snapshots.Capture();
        Assert.Equal(before, test.Session.Snapshots.Png(snapshot.Id));
        Assert.Equal(2, test.Session.Snapshots.All.Count);
        Assert.Throws<SessionException>(() => test.Session.Snapshots.Png(99));

        // A quick hand clicks twice.
        test.Session.Snapshots.Rename(snapshot.Id, null);
        test.Session.Snapshots.Rename(snapshot.Id, null);
        Assert.NotEqual(snapshot.Id, Assert.Single(test.Session.Snapshots.All).Id);
        Assert.Throws<SessionException>(() => test.Session.Snapshots.Rename(snapshot.Id, "late"));
    }

    [Fact]
    public async Task Two_snapshots_are_compared_as_the_command_compares_their_files()
    {
        using TestSession test = new();
        await test.OpenShipped("report/scene1.json", 20, 4);
        await test.Done();
        SnapshotList kept = test.Session.Snapshots;
        Snapshot first = await kept.Capture();
        Assert.Equal(("Picture 1", 4), (first.Name, first.Samples));
        Picture before = await Seen(test);
        test.Session.View.Change(s => s with { Samples = 16 }, restart: true);
        await test.Done();
        int second = (await kept.Capture()).Id;

        PictureComparison found = kept.Compare(first.Id, second);
        ImageComparison light = ImageComparison.Compare(before, await Seen(test));
        Assert.True(found.Rmse > 0);
        Assert.Equal((light.Rmse, light.LargestDifference, light.LargestX, light.LargestY), (found.Rmse, found.LargestDifference, found.LargestX, found.LargestY));
        Assert.Equal(FlipError.Compare(ImageFile.Decode(kept.Png(first.Id)), ImageFile.Decode(kept.Png(second))).Mean, found.Flip);
        Picture difference = ImageFile.Decode(kept.Png(first.Id, second, ComparisonMap.Difference));
        Assert.Equal(1, difference.Pixels.Max(), 1e-3f);
        Assert.NotEqual(difference.Pixels, ImageFile.Decode(kept.Png(first.Id, second, ComparisonMap.Flip)).Pixels);
        Assert.Equal(0, kept.Compare(second, second).Flip);

        kept.Rename(first.Id, " the noisy one ");
        Assert.Equal("the noisy one", kept.All[0].Name);
        kept.Rename(first.Id, null);
        Assert.Equal(second, Assert.Single(kept.All).Id);
        Assert.Throws<SessionException>(() => kept.Compare(first.Id, second));
    }

    private static Task<Picture> Seen(TestSession test) => test.Session.View.Loop.ReadFilm((film, _, _) => film.ToPicture());

    private static async Task Save(TestSession test, string path, int? bitDepth, params string[] layers)
    {
        await test.Session.Pictures.Save(test.Session.Pictures.Job(path, bitDepth, layers), overwrite: false);
        Notice notice = await test.Until(() => test.Session.Jobs.Running.Count == 0 ? test.Session.Notices.Newest : null);
        Assert.Equal(("info", $"wrote {path}"), (notice.Kind, notice.Text));
    }
}
