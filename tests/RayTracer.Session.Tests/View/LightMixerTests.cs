using RayTracer.Numerics;
using RayTracer.Session;
using RayTracer.Textures;

namespace RayTracer.Session.Tests;

public sealed class LightMixerTests : IDisposable
{
    private const string TwoLamps = """
        {
          "render": { "integrator": "path", "maxDepth": 2, "width": 24, "height": 16, "samplesPerPixel": 4 },
          "camera": { "position": [0, 2, 6], "lookAt": [0, 0, 0] },
          "ambient": [0, 0, 0],
          "materials": { "glow": { "type": "luminaire", "color": [1, 0.5, 0.25], "multiplier": 4 } },
          "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }],
          "lights": [
            { "type": "sphere", "name": "left", "center": [-2, 2, 0], "radius": 0.3, "material": "glow" }, // stays
            { "type": "sphere", "name": "right", "center": [2, 2, 0], "radius": 0.3, "material": "glow" },
            { "type": "point", "name": "spark", "position": [0, 1, 0], "intensity": [0.1, 0.2, 0.3] },
          ],
        }
        """;

    private readonly TestSession _test = new();

    private LightMixer Mixer => _test.Session.Mixer;

    public void Dispose() => _test.Dispose();

    [Fact]
    public async Task Factors_change_the_running_picture_as_the_scene_does_and_never_the_film()
    {
        await _test.Open(TwoLamps);
        string alone = await _test.FilmHash();
        Assert.Null(Mixer.Lights);
        Mixer.Mix(new Dictionary<string, float[]>());
        Assert.Equal(alone, await _test.FilmHash());
        Assert.Equal([("left", "/lights/0"), ("right", "/lights/1"), ("spark", "/lights/2")], Mixer.Lights!.Select(l => (l.Name, Assert.Single(l.Pointers))));
        Picture plain = await Shown();

        long picture = _test.Session.View.Shown!.Picture;
        Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [0, 0, 0], ["spark"] = [3, 1, 1] });
        Assert.Equal(new Rgb(3, 1, 1), Mixer.Lights![2].Factor);
        Picture mixed = await Shown(plain);
        Assert.Equal((picture, alone), (_test.Session.View.Shown!.Picture, await _test.FilmHash()));
        Assert.True(mixed.Pixels.Sum() < 0.8 * plain.Pixels.Sum());

        // The scene with these lights looks the same, for the same random numbers.
        await _test.Open(TwoLamps.Replace("\"radius\": 0.3, \"material\": \"glow\" }, // stays", "\"radius\": 0.3, \"material\": { \"type\": \"luminaire\", \"multiplier\": 0 } }, // stays", StringComparison.Ordinal).Replace("[0.1,", "[0.3,", StringComparison.Ordinal));
        await _test.FilmHash();
        Picture scene = await _test.Session.View.Loop.ReadFilm((film, _, _) => film.ToPicture());
        double difference = scene.Pixels.Zip(mixed.Pixels, (a, b) => Math.Abs(a - b)).Average();
        Assert.InRange(difference, 0, 0.02 * scene.Pixels.Average());
    }

    [Fact]
    public async Task The_denoised_picture_heeds_them_too()
    {
        await _test.Open(TwoLamps.Replace("\"samplesPerPixel\": 4", "\"samplesPerPixel\": 16", StringComparison.Ordinal));
        Mixer.Mix(new Dictionary<string, float[]>());
        _test.Session.View.Change(s => s with { Map = ViewMap.Denoised });
        await _test.FilmHash();
        float[] plain = await Denoised(_ => true);
        Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [0, 0, 0], ["right"] = [0, 0, 0], ["spark"] = [2, 2, 2] });
        float[] mixed = await Denoised(p => p.Sum() < 0.5 * plain.Sum());
        Mixer.Mix(new Dictionary<string, float[]>());
        float[] again = await Denoised(p => p.Sum() > 0.9 * plain.Sum());
        Assert.Equal(plain, again);

        // Nothing but twice the spark is left.
        await _test.Open(TwoLamps.Replace("\"material\": \"glow\"", "\"material\": { \"type\": \"luminaire\", \"multiplier\": 0 }", StringComparison.Ordinal).Replace("[0.1, 0.2, 0.3]", "[0.2, 0.4, 0.6]", StringComparison.Ordinal));
        await _test.FilmHash();
        Picture scene = await _test.Session.View.Loop.ReadFilm((film, _, _) => film.ToPicture());
        Assert.Equal(scene.Pixels.Average(), mixed.Average(), 0.1 * scene.Pixels.Average());

        async Task<float[]> Denoised(Predicate<float[]> isSo)
        {
            for (long after = 0; ;)
            {
                using FrameLease frame = await _test.Frame(after, f => f.IsLast);
                float[] pixels = [.. Enumerable.Range(0, frame.Picture.Height).SelectMany(y => frame.Picture.Row(y).ToArray())];
                if (isSo(pixels))
                {
                    return pixels;
                }

                after = frame.Version;
            }
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task What_is_shown_while_something_moves_heeds_them(bool isFiltered)
    {
        _test.Session.View.Change(s => s with { FiltersMotion = isFiltered });
        await _test.Open(TwoLamps.Replace("\"width\": 24, \"height\": 16, \"samplesPerPixel\": 4", "\"width\": 96, \"height\": 64, \"samplesPerPixel\": 64", StringComparison.Ordinal));
        Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [0, 0, 0], ["right"] = [2, 0.5f, 1] });
        await _test.FilmHash();
        _test.Session.View.Change(s => s with { Mode = RenderMode.Paused });
        Assert.True(_test.Session.View.TryLookFrom(CameraPose.Of(CameraMotion.Orbit(_test.Session.View.RequireShown().Camera, 0.3f, 0.1f))));
        Rgb moving = await Mean(f => f.IsPreview, _ => true);

        // What stands still without a sample follows the sliders, too.
        Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [0, 1, 1], ["right"] = [0, 0, 0], ["spark"] = [0, 9, 0] });
        Rgb other = await Mean(f => f.IsPreview, m => m.G > m.R);
        _test.Session.View.Change(s => s with { Mode = RenderMode.Running });
        AssertClose(await Mean(f => f.IsLast, _ => true), other);
        Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [0, 0, 0], ["right"] = [2, 0.5f, 1] });
        AssertClose(await Mean(f => f.IsLast, m => m.R > m.G), moving);

        // Of coarse previews, which have a sample for many pixels, the colours are enough.
        void AssertClose(Rgb film, Rgb moving)
        {

            // The first filtered picture, of a sample for each pixel, is up to a tenth darker in red; a factor that is forgotten changes more than twice as much.
            float tolerance = isFiltered ? 0.5f : float.PositiveInfinity;
            Assert.Equal(film.R, moving.R, tolerance * film.Luminance);
            Assert.Equal(film.G, moving.G, tolerance * film.Luminance);
            Assert.Equal(film.B, moving.B, tolerance * film.Luminance);
        }
    }

    [Fact]
    public async Task Factors_are_written_into_the_scene_in_one_step()
    {
        await _test.Open(TwoLamps);
        Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [0.5f, 0.5f, 0.5f], ["spark"] = [2, 0, 1] });
        Mixer.Write();
        string text = _test.Session.Document.Text;
        Assert.Contains("\"name\": \"left\", \"center\": [-2, 2, 0], \"radius\": 0.3, \"material\": { \"type\": \"luminaire\", \"color\": [1, 0.5, 0.25], \"multiplier\": 2 } }, // stays", text, StringComparison.Ordinal);
        Assert.Contains("\"radius\": 0.3, \"material\": \"glow\" },\n", text, StringComparison.Ordinal);
        Assert.Contains("\"intensity\": [0.2, 0, 0.3]", text, StringComparison.Ordinal);
        await _test.Until(() => _test.Session.View.Shown?.Good.Revision == _test.Session.Document.Revision ? Mixer.Lights : null);
        Assert.All(Mixer.Lights!, l => Assert.Equal(Rgb.White, l.Factor));
        _test.Session.Document.Undo();
        Assert.Equal(TwoLamps, _test.Session.Document.Text);
        Mixer.Mix(null);
        Assert.Null(Mixer.Lights);
    }

    [Fact]
    public async Task What_cannot_be_mixed_is_said()
    {
        await _test.Open(TwoLamps.Replace("\"path\"", "\"normals\"", StringComparison.Ordinal));
        SessionException refused = Assert.Throws<SessionException>(() => Mixer.Mix(new Dictionary<string, float[]>()));
        Assert.Contains("Layers of light", refused.Message, StringComparison.Ordinal);
        Assert.Null(Mixer.Lights);
        await _test.Open(TwoLamps);
        Assert.Throws<SessionException>(() => Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [1, -1, 1] }));
        Assert.Throws<SessionException>(() => Mixer.Mix(new Dictionary<string, float[]> { ["left"] = [1] }));
    }

    // That of a frame, once both are so.
    private async Task<Rgb> Mean(Func<FrameInfo, bool> wanted, Predicate<Rgb> isSo)
    {
        for (long after = 0; ;)
        {
            using FrameLease frame = await _test.Frame(after, wanted);
            float[] pixels = [.. Enumerable.Range(0, frame.Picture.Height).SelectMany(y => frame.Picture.Row(y).ToArray())];
            float Of(int channel) => pixels.Where((_, i) => i % 3 == channel).Average();
            Rgb mean = new(Of(0), Of(1), Of(2));
            if (isSo(mean))
            {
                return mean;
            }

            after = frame.Version;
        }
    }

    // The last frame, and one that differs from an earlier one.
    private async Task<Picture> Shown(Picture? before = null)
    {
        for (long version = 0; ;)
        {
            using FrameLease frame = await _test.Frame(version, f => f.IsLast);
            Picture picture = new(frame.Picture.Width, frame.Picture.Height);
            for (int y = 0; y < picture.Height; y++)
            {
                frame.Picture.ReadRow(y, picture.Pixels.AsSpan(3 * y * picture.Width, 3 * picture.Width));
            }

            if (before?.Pixels.SequenceEqual(picture.Pixels) != true)
            {
                return picture;
            }

            version = frame.Version;
        }
    }
}
