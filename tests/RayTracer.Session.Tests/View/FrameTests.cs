using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class FrameTests
{
    private const string Scene2 = "report/scene2.json";

    [Theory]
    [InlineData(ToneMap.Clamp, 0)]
    [InlineData(ToneMap.Aces, 1.5f)]
    [InlineData(ToneMap.Agx, -2)]
    public async Task A_frame_has_the_bytes_of_the_png(ToneMap map, float exposure)
    {
        using TestSession test = new();
        test.Session.View.Tone = new(exposure, map);
        await test.OpenShipped(Scene2, 50, 4);
        using FrameLease frame = await test.Frame(wanted: f => f.IsLast);
        byte[] rgba = new byte[4 * 50 * 50];
        FramePixels.Write(frame.Picture, test.Session.View.Tone, 1, rgba);
        byte[] png = await test.Session.Pictures.Encode(test.Session.Pictures.Job("a.png"), default);
        var decoded = ImageFile.Decode(png);
        float[] row = new float[150];
        for (int y = 0; y < 50; y++)
        {
            decoded.ReadRow(y, row);
            for (int i = 0; i < 150; i++)
            {
                Assert.Equal(row[i], SrgbCurve.Decode8(rgba[(4 * ((50 * y) + (i / 3))) + (i % 3)]));
            }
        }
    }

    [Theory]
    [InlineData("light", "RGB")]
    [InlineData("denoised", "RGB")]
    [InlineData("depth", "Z")]
    [InlineData("normal", "XYZ")]
    [InlineData("samples", "Y")]
    public async Task The_numbers_of_a_pixel_are_those_of_the_map_that_is_shown(string map, string letters)
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 50, 4);
        test.Session.View.Change(settings => settings with { Map = ViewMap.Named(map) });
        using FrameLease frame = await test.Frame(wanted: f => f.IsLast && f.IsLight == (map is "light" or "denoised"));
        PixelReading reading = Assert.Single(await test.Session.View.Loop.Pixels(new(20, 30, 1, 1)));
        IReadOnlyList<PixelReading> around = await test.Session.View.Loop.Pixels(new(19, 29, 3, 2));
        Assert.Equal([(19, 29), (20, 29), (21, 29), (19, 30), (20, 30), (21, 30)], around.Select(p => (p.X, p.Y)));
        Assert.Equal(reading.Values, around[4].Values);
        Assert.Equal((20, 30, letters), (reading.X, reading.Y, reading.Letters));
        float[] row = new float[150];
        frame.Picture.ReadRow(30, row);
        double[] light = [row[60], row[61], row[62]];
        double[] values = [.. reading.Values.Select(v => v!.Value)];
        string? legend = test.Session.View.Loop.Status.Legend;
        switch (map)
        {
            case "depth":
                // The first thing there is as far as the ray that picks it goes.
                Assert.Equal(Picking.At(test.Session.View.RequireShown(), 20.5f, 30.5f).Distance!.Value, values[0], 0.1);
                Assert.Contains("(", legend, StringComparison.Ordinal);
                break;
            case "normal":
                Assert.Equal(1, Math.Sqrt(values.Sum(v => v * v)), 0.01);
                Assert.Contains("red, green and blue", legend, StringComparison.Ordinal);
                break;
            case "samples":
                Assert.Equal([4], values);
                Assert.Contains("samples", legend, StringComparison.Ordinal);
                break;
            default:
                Assert.Equal(light, values);
                Assert.Null(legend);
                break;
        }

        await Assert.ThrowsAsync<SessionException>(() => test.Session.View.Loop.Pixels(new(49, 30, 2, 1)));
        await Assert.ThrowsAsync<SessionException>(() => test.Session.View.Loop.Pixels(new(-1, 30, 1, 1)));
    }

    [Fact]
    public async Task Exposure_and_tone_map_make_a_new_frame_of_the_same_light()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 50, 4);
        long version;
        using (FrameLease frame = await test.Frame(wanted: f => f.IsLast))
        {
            version = frame.Version;
        }

        double seconds = test.Session.View.Loop.Status.Seconds;
        test.Session.View.Tone = new(2, ToneMap.Reinhard);
        using FrameLease again = await test.Frame(version);
        Assert.True(again.Info.IsLast);
        Assert.Equal(seconds, test.Session.View.Loop.Status.Seconds);
        Assert.Throws<SessionException>(() => test.Session.View.Tone = new(float.NaN, ToneMap.Clamp));
    }

    [Fact]
    public async Task Nothing_is_put_up_where_nobody_looks()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 50, 16);
        await test.Done();
        Assert.Equal(0, test.Session.View.Frames.Changes.Version);
        using FrameLease frame = await test.Frame();
        Assert.Equal((16, true, false), (frame.Info.Samples, frame.Info.IsLast, frame.Info.IsPreview));
    }

    [Fact]
    public async Task Every_move_of_a_drag_is_seen_however_fast_the_next_one_comes()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 400, 1 << 20);
        long version = 0;
        for (int i = 0; i < 20; i++)
        {
            test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.01f, Gesture: "drag"));
            test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.01f, Gesture: "drag"));
            using FrameLease frame = await test.Frame(version);
            version = frame.Version;
        }

        using FrameLease fine = await test.Frame(version, f => !f.IsPreview);
        Assert.Equal((400, 400), (fine.Picture.Width, fine.Picture.Height));
    }

    [Fact]
    public async Task Memory_of_frames_is_used_again()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 64, 1);
        HashSet<LinearPicture> pictures = new(ReferenceEqualityComparer.Instance);
        long version = 0;
        for (int i = 0; i < 30; i++)
        {
            test.Session.View.Change(s => s, restart: true);
            using FrameLease frame = await test.Frame(version);
            version = frame.Version;
            pictures.Add(frame.Picture);
        }

        Assert.InRange(pictures.Count, 1, 3);
    }

    [Fact]
    public async Task A_screen_with_fewer_pixels_gets_means()
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 64, 1);
        using FrameLease frame = await test.Frame(wanted: f => f.IsLast);
        Assert.Equal(1, FramePixels.Reduction(frame.Picture, 40, 40));
        Assert.Equal(2, FramePixels.Reduction(frame.Picture, 32, 30));
        byte[] half = new byte[4 * 32 * 32];
        FramePixels.Write(frame.Picture, Tone.Plain, 2, half);
        float mean = (frame.Picture.Row(6)[12] + frame.Picture.Row(6)[15] + frame.Picture.Row(7)[12] + frame.Picture.Row(7)[15]) / 4;
        Assert.Equal(SrgbCurve.Encode8(mean), half[4 * ((3 * 32) + 2)]);
    }

    public static TheoryData<string> Maps => [.. ViewMap.All.Where(m => !m.IsLight).Select(m => m.Name)];

    [Theory]
    [MemberData(nameof(Maps))]
    public async Task Every_map_is_shown_beside_the_light(string map)
    {
        using TestSession test = new();
        await test.OpenShipped(Scene2, 40, 4);
        test.Session.View.Change(s => s with { Map = ViewMap.Named(map) });
        using FrameLease frame = await test.Frame(wanted: f => !f.IsLight && f.IsLast);
        Assert.Equal((40, 40), (frame.Picture.Width, frame.Picture.Height));
        if (ViewMap.Named(map).Image is not BvhCostImage)
        {
            Assert.Contains(Enumerable.Range(0, 40), y => frame.Picture.Row(y).ContainsAnyExcept(0f));
        }
    }
}
