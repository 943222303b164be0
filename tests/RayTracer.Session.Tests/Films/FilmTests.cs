using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Films and images of the program are opened as they were rendered, gone on with, and written.</summary>
public sealed class FilmTests
{
    private const string Scene = """
        {
          "camera": { "position": [0, 1.6, 5], "lookAt": [0, 0.9, 0] }, // from the front
          "render": { "integrator": "report", "width": 24, "height": 16, "samplesPerPixel": 8 },
          "background": [0.52, 0.7, 0.95],
          "shapes": [{ "type": "sphere", "name": "ball", "center": [0, 1, 0], "radius": 1 }],
          "lights": [{ "type": "sphere", "center": [2.5, 4, 2.5], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 30 } }],
        }
        """;

    [Fact]
    public async Task A_film_is_gone_on_with_to_the_bits_of_one_render()
    {
        using TestSession test = new();
        string scene = await Written(test);
        await OpenFile(test, scene);
        await test.Done();
        string whole = await test.FilmHash();
        string part = await Film(test, "part.rtfilm", stopAt: 3);
        await OpenFile(test, part);
        Assert.Equal((scene, false), (test.Session.Document.Place.Path, test.Session.Document.IsDirty));
        await test.Done();
        Assert.Equal(whole, await test.FilmHash());

        // More samples than were asked for at first, too.
        test.Session.View.Change(s => s with { Samples = 11 });
        string more = Rendered(scene, 11);
        Assert.Equal(more, await test.FilmHash());
        string saved = Path.Combine(test.Folder, "saved.rtfilm");
        await Save(test, saved);
        (FilmHeader header, Film film) = FilmFile.Read(saved);
        Assert.Equal((more, scene, "0..10", 11), (film.ComputeHash(), header.Scene, header.SamplesText, header.Total));
        Assert.Equal(FilmFile.ReadHeader(part).Content, header.Content);
    }

    [Fact]
    public async Task An_image_that_carries_its_film_is_gone_on_with_as_that_film()
    {
        using TestSession test = new();
        string scene = await Written(test);
        await OpenFile(test, scene);
        await test.Done();
        string whole = await test.FilmHash();
        (FilmHeader header, Film film) = FilmFile.Read(await Film(test, "part.rtfilm", stopAt: 3));
        string image = Path.Combine(test.Folder, "part.exr");
        FilmExr.Write(image, film, header, new());
        FilmStart? begun = null;
        test.Session.Files.Opened += (_, start) => begun = start;
        await OpenFile(test, image);
        Assert.Equal("0..2", begun?.Header.SamplesText);
        await test.Done();
        Assert.Equal(whole, await test.FilmHash());
    }

    [Fact]
    public async Task A_share_of_the_samples_is_gone_on_with_as_a_share()
    {
        using TestSession test = new();
        string scene = await Written(test);
        await OpenFile(test, scene);
        await test.Done();
        ViewportScene shown = test.Session.View.RequireShown();
        Film film = new(24, 16);
        new RTracer(shown.Scene, new() { Samples = new(2, 4) }).Render(film, null, default);
        await Save(test, Path.Combine(test.Folder, "whole.rtfilm"));
        FilmHeader header = FilmFile.ReadHeader(Path.Combine(test.Folder, "whole.rtfilm")) with { Samples = [new(2, 4)], Wanted = new(2, 6) };
        string share = Path.Combine(test.Folder, "share.rtfilm");
        FilmFile.Write(share, film, header);
        await OpenFile(test, share);
        await test.Until(() => test.Session.View.Loop.Status is { Status: "done", SamplesTotal: 6 } done ? done : null);
        await Save(test, Path.Combine(test.Folder, "rest.rtfilm"));
        new RTracer(shown.Scene, new() { Samples = new(4, 6) }).Render(film, null, default);
        (FilmHeader written, Film result) = FilmFile.Read(Path.Combine(test.Folder, "rest.rtfilm"));
        Assert.Equal((film.ComputeHash(), "2..5", header.Wanted), (result.ComputeHash(), written.SamplesText, written.Wanted));
    }

    [Fact]
    public async Task Halves_of_the_samples_stay_in_a_film_that_is_resumed()
    {
        using TestSession test = new();
        string scene = await Written(test);
        await OpenFile(test, scene);
        await test.Done();
        string path = Path.Combine(test.Folder, "a.rtfilm");
        await Save(test, path);
        FilmHeader header = FilmFile.ReadHeader(path);
        Film few = new(24, 16, FilmPlane.Half);
        Scene built = test.Session.View.RequireShown().Scene;
        new RTracer(built, new() { Samples = new(0, 3) }).Render(few, null, default);
        File.Delete(path);
        FilmFile.Write(path, few, header with { Samples = [new(0, 3)] });
        await OpenFile(test, path);
        await test.FilmHash();
        string saved = Path.Combine(test.Folder, "b.rtfilm");
        await Save(test, saved);
        Film whole = new(24, 16, FilmPlane.Half);
        new RTracer(built, new() { Samples = header.Wanted }).Render(whole, null, default);
        Assert.Equal(whole.ComputeHash(), FilmFile.Read(saved).Film.ComputeHash());
    }

    [Fact]
    public async Task Options_that_replaced_what_the_scene_says_are_put_into_its_text()
    {
        using TestSession test = new();
        string scene = await Written(test);
        string image = Path.Combine(test.Folder, "image.png");
        KeyValuePair<string, string>[] texts = [new("Command", $"raytracer render {scene} -o image.png --width=12 --denoise --height 8 --spp 4 --crop 1,2,3,4 --integrator path")];
        ImageFile.Write(image, new Film(12, 8), new() { Metadata = texts });
        await OpenFile(test, image);
        await test.Done();
        RenderStatus status = test.Session.View.Loop.Status;
        Assert.Equal((12, 8, 4, new Tile(1, 2, 3, 4)), (status.Width, status.Height, status.SamplesTotal, test.Session.View.Settings.Region!.Value));
        Assert.Null(test.Session.Document.Place.Path);
        Assert.Contains("// from the front", test.Session.Document.Text, StringComparison.Ordinal);
        Assert.Contains("\"integrator\": \"path\"", test.Session.Document.Text, StringComparison.Ordinal);

        // The text is in no file: it is written beside the film.
        string film = Path.Combine(test.Folder, "cropped.rtfilm");
        await Save(test, film);
        Assert.Equal(Path.Combine(test.Folder, "cropped.json"), FilmFile.ReadHeader(film).Scene);
        Assert.Equal(test.Session.Document.Text, await File.ReadAllTextAsync(Path.Combine(test.Folder, "cropped.json")));
        await OpenFile(test, scene);
        await test.Done();
        Assert.Equal((8, (Tile?)null), (test.Session.View.Loop.Status.SamplesTotal, test.Session.View.Settings.Region));
    }

    [Fact]
    public async Task A_scene_that_is_shown_before_it_is_known_to_be_no_film_gets_its_own_samples()
    {
        using TestSession test = new();
        string scene = await Written(test);
        string image = Path.Combine(test.Folder, "image.png");
        ImageFile.Write(image, new Film(12, 8), new() { Metadata = [new("Command", $"raytracer render {scene} -o image.png --width 12 --height 8 --spp 4 --integrator path")] });
        await OpenFile(test, image);
        await test.Open(await File.ReadAllTextAsync(scene));
        Assert.Equal(4, test.Session.View.Shown!.Scene.Render.SamplesPerPixel);
        test.Session.View.Begin();
        Assert.Equal(8, test.Session.View.Shown!.Scene.Render.SamplesPerPixel);
        Assert.Equal(8, (await test.Done()).SamplesTotal);
    }

    [Fact]
    public async Task A_film_of_another_scene_is_not_gone_on_with()
    {
        using TestSession test = new();
        string scene = await Written(test);
        await OpenFile(test, scene);
        string film = await Film(test, "old.rtfilm", stopAt: 3);
        await File.WriteAllTextAsync(scene, Scene.Replace("\"radius\": 1 ", "\"radius\": 1.1 ", StringComparison.Ordinal));
        await OpenFile(test, film);
        await test.Done();
        Assert.Contains("The film is not of scene.json", test.Session.Notices.Newest!.Text, StringComparison.Ordinal);
        string fresh = Rendered(scene, 8);
        Assert.Equal(fresh, await test.FilmHash());
        File.Delete(scene);
        Assert.Contains("neither at", Assert.Throws<SessionException>(() => test.Session.Files.Open(film, discard: true)).Message, StringComparison.Ordinal);
        string image = Path.Combine(test.Folder, "other.png");
        ImageFile.Write(image, new Film(2, 2));
        Assert.Contains("does not say how it was made", Assert.Throws<JobException>(() => test.Session.Files.Open(image)).Message, StringComparison.Ordinal);
        await File.WriteAllTextAsync(film, "no film");
        Assert.Throws<SessionException>(() => test.Session.Files.Open(film));
    }

    [Theory]
    [InlineData("textbook")]
    [InlineData("textbook:printed")]
    public async Task A_film_of_the_textbook_edition_is_gone_on_with_by_it(string edition)
    {
        using TestSession test = new();
        string scene = await Written(test);
        RenderJob job = new() { Scene = scene, Outputs = [Path.Combine(test.Folder, "whole.rtfilm")], Edition = edition };
        string whole = Job(job);
        RenderJob first = job with { Outputs = [Path.Combine(test.Folder, "first.rtfilm")], Samples = new(0, 3) };
        Job(first);

        await OpenFile(test, scene);
        test.Session.View.Change(s => s with { Edition = edition });
        Assert.Equal(whole, await test.FilmHash());

        // The Studio goes on with the command's film, and the command with the Studio's.
        await OpenFile(test, first.Outputs[0]);
        Assert.Equal(edition, test.Session.View.Settings.Edition);
        Assert.Equal(whole, await test.FilmHash());
        string own = await Film(test, "own.rtfilm", stopAt: 3);
        Assert.Equal(whole, Job(job with { Outputs = [own], Resumed = HeldFilm.Read(own) }));

        // By the other edition it is another picture.
        test.Session.View.Change(s => s with { Edition = null });
        Assert.Equal(Rendered(scene, 8), await test.FilmHash());
        test.Session.View.Change(s => s with { Edition = edition });
        Assert.Contains($"--edition {edition}", test.Session.Pictures.Command(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_the_textbook_edition_lacks_is_named_and_the_fast_one_renders()
    {
        using TestSession test = new();
        test.Session.View.Change(s => s.WithEdition("textbook"));
        await test.Open(Scene.Replace("\"report\"", "\"bidirectional\"", StringComparison.Ordinal));
        Notice notice = await test.Until(() => test.Session.Notices.Newest);
        Assert.Contains("test.json:3:29: error: the textbook edition has no integrator \"bidirectional\"", notice.Text, StringComparison.Ordinal);
        Assert.Contains("the fast edition renders it", notice.Text, StringComparison.Ordinal);
        await test.Done();
        Assert.Null(test.Session.View.Settings.Edition);
        Assert.Throws<SessionException>(() => test.Session.View.Change(s => s.WithEdition("slow")));
    }

    private static string Job(RenderJob job) => new JobRun(job, new SessionWatch(new Progress<double>(), 1, default)).Run(CancellationToken.None)!.Hash!;

    private static async Task<string> Written(TestSession test)
    {
        string scene = Path.Combine(test.Folder, "scene.json");
        await File.WriteAllTextAsync(scene, Scene);
        return scene;
    }

    private static async Task OpenFile(TestSession test, string path)
    {
        test.Session.Files.Open(path);
        await test.Session.Document.WhenBuilt();
        await test.Until(() => test.Session.View.Shown is { } shown && shown.Good.Revision == test.Session.Document.Revision ? shown : null);
    }

    // A film of some of the samples, of the scene that is open.
    private static async Task<string> Film(TestSession test, string name, int stopAt)
    {
        string path = Path.Combine(test.Folder, name);
        test.Session.View.Change(s => s with { Samples = stopAt }, restart: true);
        await test.Until(() => test.Session.View.Loop.Status is { Status: "done" } done && done.SamplesTotal == stopAt ? done : null);
        await Save(test, path);
        (FilmHeader header, Film film) = FilmFile.Read(path);
        FilmFile.Write(path, film, header with { Total = 8, Wanted = new(0, 8) });
        test.Session.View.Change(s => s with { Samples = null });
        return path;
    }

    private static string Rendered(string scene, int samples)
    {
        Scene built = Scenes.SceneLoader.Load(scene, s => s with { Render = s.Render with { SamplesPerPixel = samples } }).Scene!;
        return new RTracer(built).Render().Film.ComputeHash();
    }

    private static async Task Save(TestSession test, string path)
    {
        int before = test.Session.Notices.Newest?.Id ?? 0;
        await test.Session.Pictures.Save(test.Session.Pictures.Job(path), overwrite: false);
        Notice notice = await test.Until(() => test.Session.Jobs.Running.Count == 0 && test.Session.Notices.Newest is { } newest && newest.Id > before ? newest : null);
        Assert.Equal("info", notice.Kind);
    }
}
