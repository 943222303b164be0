using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Parts and frames are rendered into files beside the work in the window, and parts are merged.</summary>
public sealed class BackgroundRendersTests
{
    private const string Scene = """
        {
          "camera": { "position": [0, 1.6, 5], "lookAt": [0, 0.9, 0] },
          "render": { "integrator": "report", "width": 24, "height": 16, "samplesPerPixel": 7, "framesPerSecond": 10 },
          "background": [0.52, 0.7, 0.95],
          "shapes": [{ "type": "sphere", "name": "ball", "center": [0, 1, 0], "radius": 1 }],
          "lights": [{ "type": "sphere", "center": [2.5, 4, 2.5], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 30 } }],
          "animation": [{ "property": "shapes.ball.radius", "keys": [{ "time": 0, "value": 1 }, { "time": 1, "value": 2 }] }],
        }
        """;

    [Fact]
    public async Task Parts_merge_to_the_bits_of_one_render()
    {
        using TestSession test = new();
        string whole = new RTracer((await Open(test)).Scene).Render().Film.ComputeHash();
        BackgroundRenders background = test.Session.Background;
        foreach (int i in new[] { 3, 1, 2 })
        {
            await Job(test, () => background.Part(i, 3, $"part{i}.rtfilm", overwrite: false));
        }

        string[] parts = [.. new[] { 2, 3, 1 }.Select(i => Path.Combine(test.Folder, $"part{i}.rtfilm"))];
        Assert.Equal((new SampleRange(2, 4), 7), (FilmFile.ReadHeader(parts[0]).Wanted, FilmFile.ReadHeader(parts[0]).Total));
        await Job(test, () => background.Merge(parts, "whole.rtfilm", overwrite: false));
        Assert.Equal(whole, FilmFile.Read(Path.Combine(test.Folder, "whole.rtfilm")).Film.ComputeHash());
        await Job(test, () => background.Merge(parts, "whole.png", overwrite: false));
        Assert.Contains(new("FilmHash", whole), ImageFile.ReadText(Path.Combine(test.Folder, "whole.png")));

        Assert.Contains("samples 0..1 are missing of 7", Assert.Throws<SessionException>(() => background.Merge(parts[..2], "some.png", false)).Message, StringComparison.Ordinal);
        Assert.Contains("are in both", Assert.Throws<JobException>(() => background.Merge([.. parts, parts[0]], "some.rtfilm", false)).Message, StringComparison.Ordinal);
        Assert.Throws<SessionException>(() => background.Merge([], "some.rtfilm", false));
        Assert.Equal(SessionFault.Exists, Assert.Throws<SessionException>(() => background.Part(1, 3, "part1.rtfilm", overwrite: false)).Fault);
        Assert.Throws<SessionException>(() => background.Part(4, 3, "some.rtfilm", false));
        Assert.Throws<SessionException>(() => background.Part(1, 8, "some.rtfilm", false));
        Assert.Throws<SessionException>(() => background.Part(1, 3, "some.png", false));
    }

    [Fact]
    public async Task Frames_are_those_of_the_command_and_stay_where_they_are_whole()
    {
        using TestSession test = new();
        await Open(test);
        BackgroundRenders background = test.Session.Background;
        string notice = await Job(test, () => background.Frames(4, 6, "frame-##.png", overwrite: false));
        Assert.Equal($"wrote 3 frames, {Path.Combine(test.Folder, "frame-04.png")} to frame-06.png", notice);
        string scene = Path.Combine(test.Folder, "scene.json");
        Scenes.SceneLoadResult load = Scenes.SceneLoader.Load(scene, frame: 5);
        Dictionary<string, string> texts = new(ImageFile.ReadText(Path.Combine(test.Folder, "frame-05.png")));
        Assert.Equal((new RTracer(load.Scene!).Render().Film.ComputeHash(), ContentHash.OfPicture(load.Description!, scene, null)), (texts["FilmHash"], texts["Content"]));
        Assert.Equal("""["frames=5"]""", texts["Settings"]);

        File.Delete(Path.Combine(test.Folder, "frame-06.png"));
        Assert.Equal(SessionFault.Exists, Assert.Throws<SessionException>(() => background.Frames(4, 6, "frame-##.png", overwrite: false)).Fault);
        Assert.EndsWith("wrote 1 frames, " + Path.Combine(test.Folder, "frame-04.png") + " to frame-06.png; 2 were there already", await Job(test, () => background.Frames(4, 6, "frame-##.png", overwrite: true)), StringComparison.Ordinal);
        Assert.Throws<SessionException>(() => background.Frames(3, 2, "frame-##.png", false));
        Assert.Equal(
            $"-o {Path.Combine(test.Folder, "frame.jpg")}: 2 frames need as many files: put #### where their numbers should go",
            Assert.Throws<JobException>(() => background.Frames(2, 3, "frame.jpg", false)).Message);
        await Job(test, () => background.Frames(2, 3, "moving.png", overwrite: false));
        Assert.Equal(2, ImageFile.Describe(Path.Combine(test.Folder, "moving.png")).Frames);

        // The command takes the Studio's frames for its own, and the Studio the command's.
        string frame = Path.Combine(test.Folder, "frame-05.png");
        RenderJob job = new() { Scene = scene, Frames = new(5, 5, 1), Outputs = ["elsewhere.png"] };
        Assert.True(FinishedPicture.Is(frame, job, load.Description!));
        Assert.False(FinishedPicture.Is(frame, job with { Writing = new() { ToneMap = ToneMap.Aces } }, load.Description!));
        ImageFile.Write(frame, ImageFile.Read(frame), new() { Metadata = [.. texts.Where(t => t.Key != "Command"), new("Command", "raytracer render scene.json --frames 5 -o frame-05.png")] });
        Assert.EndsWith("; 3 were there already", await Job(test, () => background.Frames(4, 6, "frame-##.png", overwrite: true)), StringComparison.Ordinal);

        // A frame is opened as what it shows.
        test.Session.Files.Open(Path.Combine(test.Folder, "frame-05.png"));
        await test.Session.Document.WhenBuilt();
        await test.Until(() => test.Session.View.Shown is { } shown && shown.Good.Revision == test.Session.Document.Revision ? shown : null);
        Assert.Equal(texts["FilmHash"], await test.FilmHash());
    }

    [Fact]
    public async Task What_is_cancelled_leaves_all_files_as_they_were()
    {
        using TestSession test = new();
        await Open(test, Scene.Replace("\"samplesPerPixel\": 7", "\"samplesPerPixel\": 4000000", StringComparison.Ordinal));
        BackgroundRenders background = test.Session.Background;
        string old = Path.Combine(test.Folder, "part.rtfilm");
        await File.WriteAllTextAsync(old, "a file of before");
        Assert.Equal("part 2 of 2: part.rtfilm: cancelled", await Cancelled(test, () => background.Part(2, 2, "part.rtfilm", overwrite: true)));
        Assert.Equal("frames 0 to 9: cancelled", await Cancelled(test, () => background.Frames(0, 9, "frame-#.png", overwrite: false)));
        Assert.Equal("a file of before", await File.ReadAllTextAsync(old));
        Assert.Equal([old, Path.Combine(test.Folder, "scene.json")], Directory.EnumerateFiles(test.Folder).Order(StringComparer.Ordinal));
    }

    private static async Task<string> Cancelled(TestSession test, Func<int> start)
    {
        int before = test.Session.Notices.Newest?.Id ?? 0;
        int job = start();
        await test.Until(() => test.Session.Jobs.Running.FirstOrDefault(j => j.Id == job && j.Fraction > 0));
        test.Session.Jobs.Cancel(job);
        return (await test.Until(() => test.Session.Jobs.Running.Count == 0 && test.Session.Notices.Newest is { } newest && newest.Id > before ? newest : null)).Text;
    }

    private static async Task<ViewportScene> Open(TestSession test, string text = Scene)
    {
        string scene = Path.Combine(test.Folder, "scene.json");
        await File.WriteAllTextAsync(scene, text);
        test.Session.Files.Open(scene);
        await test.Session.Document.WhenBuilt();
        return await test.Until(() => test.Session.View.Shown is { } shown && shown.Good.Revision == test.Session.Document.Revision ? shown : null);
    }

    private static async Task<string> Job(TestSession test, Func<int> start)
    {
        int before = test.Session.Notices.Newest?.Id ?? 0;
        start();
        Notice notice = await test.Until(() => test.Session.Jobs.Running.Count == 0 && test.Session.Notices.Newest is { } newest && newest.Id > before ? newest : null);
        Assert.True(notice.Kind == "info", notice.Text);
        return notice.Text;
    }
}
