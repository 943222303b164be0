using System.Collections.Immutable;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session.Tests;

public sealed class MovingViewTests
{
    private const int Size = 96;
    private const string Ball = """, { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 2 } }""";

    [Theory]
    [InlineData(800, 600, 400, 300)]
    [InlineData(320, 240, 320, 240)]
    [InlineData(1920, 1080, 480, 270)]
    public void A_picture_has_as_many_samples_as_are_wanted(int width, int height, int across, int down) =>
        Assert.Equal((across, down), MovingView.SizeFor(width, height));

    [Fact]
    public async Task What_is_carried_over_an_orbit_is_less_noisy_than_a_sample_and_has_the_same_light()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Text(""));
        MovingView view = new();
        LinearPicture picture = new();
        for (int i = 0; i < 12; i++)
        {
            shown = Turned(shown, 0.01f);
            Assert.True(view.Next(shown, picture, CancellationToken.None));
        }

        Film reference = Rendered(shown, 1024);
        Film noisy = Rendered(shown, 1);
        Assert.InRange(Error(picture, reference), 0, Error(Pictured(noisy), reference) / 4);
        Assert.Equal(Mean(Pictured(reference)), Mean(picture), 0.03f * Mean(picture));
    }

    [Fact]
    public async Task Factors_on_lights_make_of_it_what_they_make_of_the_film()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Text(Ball.Replace("\"center\"", "\"name\": \"ball\", \"center\"", StringComparison.Ordinal)));
        shown = shown with { Settings = shown.Settings with { LightFactors = ImmutableDictionary<string, Rgb>.Empty.Add("ball", new(0.25f, 2, 1)).Add("unnamed", new(1, 0, 0.5f)) } };
        MovingView view = new();
        LinearPicture picture = new();
        for (int i = 0; i < 12; i++)
        {
            shown = Turned(shown, 0.01f);
            view.Next(shown, picture, CancellationToken.None);
        }

        Film film = Rendered(shown, 1);
        LightLayers lights = new();
        lights.Begin(shown, film);
        film.Clear();
        new RTracer(Many(shown, 256), new() { Layers = lights.Film }).Render(film);
        LinearPicture mixed = Pictured(film);
        lights.Paint(shown, mixed);
        float bright = Enumerable.Range(0, 3).Max(channel => Mean(mixed, channel));
        Assert.All(Enumerable.Range(0, 3), channel => Assert.Equal(Mean(mixed, channel), Mean(picture, channel), 0.03f * bright));
    }

    [Fact]
    public async Task A_thing_that_is_gone_leaves_no_ghost_after_eight_pictures()
    {
        using TestSession test = new();
        MovingView view = new();
        LinearPicture picture = new();
        ViewportScene with = await test.Open(Text(Ball));
        for (int i = 0; i < 20; i++)
        {
            view.Next(with, picture, CancellationToken.None);
        }

        // As after an edit of the same document.
        ViewportScene without = (await test.Open(Text(""))) with { Place = with.Place };
        for (int i = 0; i < 8; i++)
        {
            view.Next(without, picture, CancellationToken.None);
        }

        (Film before, Film after) = (Rendered(with, 256), Rendered(without, 256));
        float ghost = 0;
        for (int y = 4; y < Size - 4; y++)
        {
            for (int x = 4; x < Size - 4; x++)
            {
                float gone = before.Mean(x, y).Luminance - after.Mean(x, y).Luminance;
                float left = Luminance(picture, x, y) - after.Mean(x, y).Luminance;
                ghost = gone > 0.5f ? Math.Max(ghost, left / gone) : ghost;
            }
        }

        Assert.InRange(ghost, 0, 0.1f);
    }

    [Fact]
    public async Task Another_document_begins_without_anything_of_the_last()
    {
        using TestSession test = new();
        MovingView view = new();
        (LinearPicture picture, LinearPicture alone, MovingView fresh) = (new(), new(), new());
        ViewportScene first = await test.Open(Text(Ball));
        for (int i = 0; i < 3; i++)
        {
            view.Next(first, picture, CancellationToken.None);
        }

        ViewportScene second = await test.Open(Text(""));
        for (int i = 0; i < 3; i++)
        {
            fresh.Next(first with { Place = second.Place, Good = second.Good, Scene = second.Scene }, alone, CancellationToken.None);
        }

        view.Next(second, picture, CancellationToken.None);
        Assert.InRange(Mean(picture) / Mean(alone), 0.9f, 1.1f);
    }

    [Theory]
    [InlineData(1, 64)]
    [InlineData(16, 16)]
    public void The_film_takes_over_step_by_step_and_wholly(int first, int total)
    {
        MovingPlan plan = new();
        plan.Begin();
        plan.Add();
        float[] shares = [.. Enumerable.Range(first, total - first + 1).Select(n => plan.ShareAfter(n, total))];
        Assert.Equal(shares.OrderDescending(), shares);
        Assert.Equal(0, shares[^1]);
        Assert.True(first == total || (shares[0] > 0.9f && shares.Zip(shares.Skip(1)).All(s => s.First - s.Second < 0.1f)));
    }

    [Fact]
    public async Task The_film_has_the_same_bits_with_and_without_the_filter()
    {
        List<string> hashes = [];
        foreach (bool filters in new[] { true, false })
        {
            using TestSession test = new();
            test.Session.View.Change(s => s with { FiltersMotion = filters });
            await test.OpenShipped("report/scene2.json", 48, 16);
            await test.Done();
            test.Session.View.TryLookFrom(CameraPose.Of(CameraMotion.Orbit(test.Session.View.RequireShown().Camera, 0.1f, 0)));
            hashes.Add(await test.FilmHash());
        }

        Assert.Equal(hashes[0], hashes[1]);
    }

    private static string Text(string more) => $$"""
        {
          "camera": { "position": [0, 1.5, 4], "lookAt": [0, 0.5, 0], "fieldOfView": 40 },
          "render": { "integrator": "path", "maxDepth": 3, "width": {{Size}}, "height": {{Size}}, "samplesPerPixel": 16 },
          "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.6, 0.6] } }{{more}}],
          "lights": [{ "type": "sphere", "center": [0, 5, 1], "radius": 1, "material": { "type": "luminaire", "multiplier": 5 } }]
        }
        """;

    private static ViewportScene Turned(ViewportScene shown, float by)
    {
        CameraDescription camera = CameraMotion.Orbit(shown.Camera, by, 0);
        return shown with { Camera = camera, Scene = shown.Scene.WithView(camera, shown.Scene.Render, new((_, _) => new(1, 1)))! };
    }

    private static Film Rendered(ViewportScene shown, int samples) => new RTracer(Many(shown, samples)).Render().Film;

    private static Scene Many(ViewportScene shown, int samples) =>
        shown.Scene.WithView(shown.Camera, shown.Scene.Render with { SamplesPerPixel = samples }, new((_, _) => new(1, 1)))!;

    private static LinearPicture Pictured(Film film)
    {
        LinearPicture picture = new();
        picture.CopyFrom(film);
        return picture;
    }

    private static float Luminance(LinearPicture picture, int x, int y) => new Rgb(picture.Row(y)[3 * x], picture.Row(y)[(3 * x) + 1], picture.Row(y)[(3 * x) + 2]).Luminance;

    private static float Mean(LinearPicture picture) => Enumerable.Range(0, Size * Size).Average(i => Luminance(picture, i % Size, i / Size));

    private static float Mean(LinearPicture picture, int channel) => Enumerable.Range(0, Size * Size).Average(i => picture.Row(i / Size)[(3 * (i % Size)) + channel]);

    // Without the edges of things, which a sample cannot show.
    private static float Error(LinearPicture picture, Film reference) => Enumerable.Range(0, Size * Size).Where(i => i / Size > Size / 2).Average(i =>
    {
        float difference = Luminance(picture, i % Size, i / Size) - reference.Mean(i % Size, i / Size).Luminance;
        return difference * difference;
    });
}
