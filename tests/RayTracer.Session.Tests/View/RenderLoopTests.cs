using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class RenderLoopTests
{
    private const string Scene2 = "report/scene2.json";

    [Theory]
    [InlineData("report/scene1.json", 1)]
    [InlineData("report/scene2.json", 2)]
    [InlineData("report/scene3.json", 3)]
    public async Task The_film_in_the_end_is_that_of_the_command(string path, int threads)
    {
        using TestSession test = new();
        test.Session.View.Change(s => s with { Threads = threads });
        ViewportScene shown = await test.OpenShipped(path, 72, 25);
        await test.Done();
        Assert.Equal(HashOf(shown.Scene), await Hash(test));
    }

    [Fact]
    public async Task The_film_is_the_same_with_all_its_frames_looked_at_and_all_settings_changed_that_change_no_picture()
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped(Scene2, 96, 64);
        using CancellationTokenSource end = new();
        Task watching = Watch(test.Session.View.Frames, end.Token);
        test.Session.View.Change(s => s with { Map = ViewMap.Named("normal") });
        test.Session.View.Change(s => s with { Threads = 2, Mode = RenderMode.Paused });
        test.Session.View.Tone = new(1.5f, ToneMap.Agx);
        test.Session.View.Change(s => s with { Map = ViewMap.Named("error"), Mode = RenderMode.Running });
        await test.Done();
        await end.CancelAsync();
        await watching;
        Assert.Equal(HashOf(shown.Scene), await Hash(test));
    }

    [Fact]
    public async Task Pixels_without_samples_have_no_numbers()
    {
        using TestSession test = new();
        test.Session.View.Change(s => s with { Mode = RenderMode.Paused });
        await test.OpenShipped(Scene2, 32, 4);
        IReadOnlyList<PixelReading> readings = await test.Session.View.Loop.Pixels(new(16, 16, 2, 1));
        Assert.Equal(2, readings.Count);
        Assert.All(readings.SelectMany(r => r.Values), v => Assert.Null(v));
    }

    [Fact]
    public async Task Who_looks_around_finds_the_picture_with_its_samples_again()
    {
        using TestSession test = new();
        string text = File.ReadAllText(ProjectFolder.PathOf("scenes", Scene2));
        await test.Open(JsonText.Of(text).Set("/render/width", 32).Set("/render/height", 32).Set("/render/samplesPerPixel", 1 << 20).Set("/render/sampler", "independent").Text);
        RenderStatus before = await test.Until(() => test.Session.View.Loop.Status is { Seconds: > 2.5 } s ? s : null);
        test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.1f, 0.02f));
        await test.Until(() => test.Session.View.Loop.Status is { Seconds: < 2, Samples: > 0 } s ? s : null);
        test.Session.View.Change(s => s with { Mode = RenderMode.Paused });
        test.Session.Camera.Move(new(CameraMoveKind.Home));

        // Rendered from scratch, it would have none, as it is paused.
        RenderStatus again = await test.Until(() => test.Session.View.Loop.Status is { Status: "paused" } s && s.Samples >= before.Samples / 2 ? s : null);
        test.Session.View.Change(s => s with { Samples = again.Samples + 8, Mode = RenderMode.Running });
        await test.Done();
        ViewportScene shown = test.Session.View.RequireShown();
        Assert.Equal(again.Samples + 8, shown.Samples);
        Assert.Equal(HashOf(shown.Scene), await Hash(test));

        // Unless it is to be rendered from scratch.
        test.Session.View.Change(s => s with { Mode = RenderMode.Paused }, restart: true);
        test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.1f, 0.02f));
        test.Session.Camera.Move(new(CameraMoveKind.Home));
        long picture = test.Session.View.RequireShown().Picture;
        (long Picture, int Samples) read = default;
        while (read.Picture != picture)
        {
            read = await test.Session.View.Loop.ReadFilm((_, order, samples) => (order.Picture, samples));
        }

        Assert.Equal(0, read.Samples);
    }

    [Theory]
    [InlineData("sobol", 16)]
    [InlineData("jittered", 9)]
    public async Task The_denoised_picture_is_that_of_the_command_in_the_end(string sampler, int samples)
    {
        using TestSession test = new();
        test.Session.View.Change(s => s with { Map = ViewMap.Denoised });
        string text = File.ReadAllText(ProjectFolder.PathOf("scenes", Scene2));
        ViewportScene shown = await test.Open(JsonText.Of(text).Set("/render/width", 48).Set("/render/height", 40).Set("/render/samplesPerPixel", samples).Set("/render/sampler", sampler).Text);
        using FrameLease frame = await test.Frame(wanted: info => info.IsLast && info.PictureWidth == 48);
        HalfRender[] halves = [HalfRender.Create(48, 40), HalfRender.Create(48, 40)];
        SampleRange[] ranges = [new(0, samples / 2), new(samples / 2, samples)];
        for (int i = 0; i < 2; i++)
        {
            new RTracer(shown.Scene, new() { Samples = ranges[i] }).Render(halves[i].Film);
            HalfRender.Pass(shown.Scene, new() { Samples = ranges[i] }).Render(halves[i].Features);
        }

        float[] expected = Denoiser.Denoise(halves[0], halves[1]).Picture.Pixels;
        Assert.All(Enumerable.Range(0, 40), y => Assert.Equal(expected.AsSpan(3 * 48 * y, 3 * 48), frame.Picture.Row(y)));
        Assert.Equal(HashOf(shown.Scene), await Hash(test));
    }

    [Fact]
    public async Task More_samples_go_on_with_those_that_there_are()
    {
        using TestSession test = new();
        string text = File.ReadAllText(ProjectFolder.PathOf("scenes", Scene2));
        ViewportScene first = await test.Open(JsonText.Of(text).Set("/render/width", 64).Set("/render/height", 64).Set("/render/samplesPerPixel", 16).Set("/render/sampler", "sobol").Text);
        await test.Done();
        test.Session.View.Change(s => s with { Samples = 40 });
        ViewportScene more = test.Session.View.Shown!;
        Assert.Equal(first.Picture, more.Picture);
        await test.Done();
        Assert.Equal(HashOf(more.Scene), await Hash(test));
    }

    [Fact]
    public async Task Samplers_that_place_all_samples_together_restart_for_more()
    {
        using TestSession test = new();
        string text = File.ReadAllText(ProjectFolder.PathOf("scenes", Scene2));
        ViewportScene first = await test.Open(JsonText.Of(text).Set("/render/width", 40).Set("/render/height", 40).Set("/render/samplesPerPixel", 4).Set("/render/sampler", "jittered").Text);
        await test.Done();
        test.Session.View.Change(s => s with { Samples = 9 });
        ViewportScene more = test.Session.View.Shown!;
        Assert.NotEqual(first.Picture, more.Picture);
        await test.Done();
        Assert.Equal(HashOf(more.Scene), await Hash(test));
        Assert.Throws<SessionException>(() => test.Session.View.Change(s => s with { Samples = 10 }));
    }

    [Fact]
    public async Task A_region_gets_the_samples_that_the_command_gives_it()
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped(Scene2, 64, 9);
        Tile region = new(10, 20, 30, 17);
        test.Session.View.Change(s => s with { Region = region });
        await test.Done();
        Film film = new(64, 64);
        new RTracer(shown.Scene, new() { Crop = region }).Render(film);
        Assert.Equal(film.ComputeHash(), await Hash(test));
        Assert.Throws<SessionException>(() => test.Session.View.Change(s => s with { Region = new(60, 0, 5, 5) }));
    }

    [Fact]
    public async Task A_newer_scene_does_not_wait_for_the_end_of_an_older_one()
    {
        using TestSession test = new();

        // Alone, this would take hours; the next picture is done although it never ends.
        await test.OpenShipped(Scene2, 2000, 1 << 20);
        ViewportScene small = await test.OpenShipped(Scene2, 24, 4);
        await test.Done();
        Assert.Equal(HashOf(small.Scene), await Hash(test));
    }

    [Fact]
    public async Task What_is_stopped_stays_so_and_what_is_paused_goes_on()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 200, 1 << 20);
        test.Session.View.Change(s => s with { Mode = RenderMode.Paused });
        RenderStatus paused = await test.Until(() => test.Session.View.Loop.Status is { Status: "paused" } s ? s : null);
        test.Session.View.Change(s => s with { Mode = RenderMode.Running });
        await test.Until(() => test.Session.View.Loop.Status is { Status: "rendering" } s && s.Samples > paused.Samples ? s : null);
        test.Session.View.Change(s => s with { Mode = RenderMode.Stopped });
        await test.Until(() => test.Session.View.Loop.Status is { Status: "stopped" } s ? s : null);
        int samples = await test.Session.View.Loop.ReadFilm((_, _, count) => count);
        Assert.Equal(samples, await test.Session.View.Loop.ReadFilm((_, _, count) => count));
    }

    [Fact]
    public async Task A_picture_too_large_for_the_memory_is_refused_in_words_and_the_next_one_rendered()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 65536, 1);
        Notice notice = await test.Until(() => test.Session.Notices.Newest);
        Assert.Contains("memory", notice.Text, StringComparison.Ordinal);
        await test.OpenShipped(Scene2, 16, 1);
        await test.Done();
    }

    [Fact]
    public async Task The_error_of_earlier_pictures_shrinks_with_their_samples()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 64, 64);
        await test.Done();
        Convergence convergence = await test.Session.View.Loop.Convergence();
        Assert.Equal([1, 2, 4, 8, 16, 32], convergence.Points.Select(p => p.Samples));
        Assert.True(convergence.Points.Zip(convergence.Points.Skip(1)).All(p => p.Second.Error < p.First.Error));
        Assert.InRange(convergence.Slope!.Value, -1.5, -0.3);
    }

    internal static string HashOf(Scene scene) => new RTracer(scene).Render().Film.ComputeHash();

    private static Task<string> Hash(TestSession test) => test.Session.View.Loop.ReadFilm((film, _, _) => film.ComputeHash());

    private static async Task Watch(FrameBoard frames, CancellationToken end)
    {
        long version = 0;
        while (await frames.Wait(version, end))
        {
            using FrameLease frame = frames.Borrow()!;
            version = frame.Version;
        }
    }
}
