using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Session;
using JsonNode = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session.Tests;

/// <summary>The view shows frames of the animation, and keys are edits of the scene's text.</summary>
public sealed class TimelineTests
{
    private const string Ball = """
        {
          // A ball that grows.
          "camera": { "position": [0, 1.6, 5], "lookAt": [0, 0.9, 0] },
          "render": { "integrator": "report", "width": 24, "height": 16, "samplesPerPixel": 2, "framesPerSecond": 10 },
          "background": [0.52, 0.7, 0.95],
          "shapes": [{ "type": "sphere", "name": "ball", "center": [0, 1, 0], "radius": 1 }],   // the only one
          "animation": [
            { "property": "shapes.ball.radius", "keys": [
              { "time": 0, "value": 1 },   // small
              { "time": 1, "value": 2 },   // large
            ] },
          ],
        }
        """;

    [Theory]
    [InlineData(0)]
    [InlineData(6)]
    [InlineData(31)]
    public async Task The_view_shows_the_bits_of_the_commands_frame(int frame)
    {
        using TestSession test = new();
        await test.OpenShipped("animation/01-turn.json", 48, 4);
        test.Session.Timeline.Show(frame);
        await Shown(test, frame);
        SceneLoadResult load = SceneLoader.LoadText(test.Session.Document.Text, "turn.json", ProjectFolder.PathOf("scenes", "animation"), frame: frame);
        Film film = new RTracer(load.Scene!).Render().Film;
        Assert.Equal(film.ComputeHash(), await test.FilmHash());
        Assert.Equal(new FrameRange(frame, frame, 1), test.Session.Pictures.Job("x.png").Frames);
        Assert.Contains($"--frames {frame} ", test.Session.Pictures.Command(), StringComparison.Ordinal);
        Assert.NotEqual(new RTracer(SceneLoader.LoadText(test.Session.Document.Text, "turn.json", "").Scene!).Render().Film.ComputeHash(), film.ComputeHash());
    }

    [Fact]
    public async Task A_film_of_a_frame_names_it_and_is_resumed_at_it()
    {
        using TestSession test = new();
        await test.Open(Ball);
        test.Session.Timeline.Show(7);
        await Shown(test, 7);
        string hash = await test.FilmHash();
        string path = Path.Combine(test.Folder, "frame.rtfilm");
        await test.Session.Pictures.Save(test.Session.Pictures.Job(path), overwrite: false);
        await test.Until(() => File.Exists(path) && test.Session.Jobs.Running.Count == 0 ? path : null);
        test.Session.Files.Open(path);
        await test.Until(() => test.Session.View.Shown is { Start: not null } shown ? shown : null);
        Assert.Equal(hash, await test.FilmHash());
        Assert.Null(test.Session.Document.Frame);
    }

    [Fact]
    public async Task The_state_has_the_frames_of_the_scene_and_its_values()
    {
        using TestSession test = new();
        await test.OpenShipped("animation/01-turn.json", 16, 1);
        TimeState state = test.Session.Timeline.State;
        Assert.Equal((0, 48, 24), (state.Frame, state.Frames, state.FramesPerSecond));
        Assert.Equal(["camera.position", "materials.paint.color", "shapes.tower.b[1]", "materials.glass.refractiveIndex", "jumper.motion"], test.Session.Timeline.Rows.Select(r => r.Label));
        Assert.Equal("[-2.5,1.2,6]", Json(Value(test, "/camera/position")));
        test.Session.Timeline.Show(36);
        await Shown(test, 36);
        Assert.Equal("1.6", Json(Value(test, "/shapes/2/b/1")));
        Assert.False(test.Session.Timeline.State.Values.Single(v => v.Pointer == "/shapes/2/b/1").HasKey);
    }

    [Fact]
    public async Task The_animation_of_a_model_is_played_and_has_a_row()
    {
        using TestSession test = new();
        string data = Convert.ToBase64String(System.Runtime.InteropServices.MemoryMarshal.AsBytes<float>((float[])[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 4, 0, 0]));
        await File.WriteAllTextAsync(Path.Combine(test.Folder, "m.gltf"), $$"""
            { "asset": { "version": "2.0" }, "nodes": [{ "mesh": 0 }], "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
              "buffers": [{ "byteLength": 68, "uri": "data:;base64,{{data}}" }], "bufferViews": [{ "buffer": 0, "byteLength": 68 }],
              "accessors": [{ "bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3 }, { "bufferView": 0, "byteOffset": 36, "componentType": 5126, "type": "SCALAR", "count": 2 },
                { "bufferView": 0, "byteOffset": 44, "componentType": 5126, "type": "VEC3", "count": 2 }],
              "animations": [{ "samplers": [{ "input": 1, "output": 2 }], "channels": [{ "sampler": 0, "target": { "node": 0, "path": "translation" } }] }] }
            """);
        await test.Open("""{ "render": { "framesPerSecond": 10, "width": 9, "height": 9, "samplesPerPixel": 1 }, "shapes": [{ "type": "model", "name": "m", "file": "m.gltf", "playback": { "speed": 2 } }], "background": 1 }""");
        TimelineRow row = Assert.Single(await test.Session.Timeline.WholeRows());
        Assert.Equal(("m.playback", "/shapes/0/playback", "/shapes/0"), (row.Label, row.Keys, row.Thing));
        Assert.Equal([0, 10], row.Items.Select(k => k.Frame));
        Assert.Equal(10, test.Session.Timeline.State.Frames);
        test.Session.Timeline.Show(5);
        ViewportScene shown = await Shown(test, 5);
        Assert.Equal(2, shown.Scene.Surfaces().Single().Bounds.Minimum.X);
        Assert.Throws<SessionException>(() => test.Session.Timeline.RemoveKeys([new(row.Keys, [0])]));
        test.Session.Edits.Set("/shapes/0/playback/speed", JsonValue.Create(0));
        Assert.Empty(await test.Session.Timeline.WholeRows());
    }

    [Fact]
    public async Task An_edit_of_an_animated_value_writes_a_key_at_the_frame_and_leaves_all_else()
    {
        using TestSession test = new();
        await test.Open(Ball);
        test.Session.Timeline.Show(3);
        string before = test.Session.Document.Text;
        test.Session.Edits.Set("/shapes/0/radius", JsonValue.Create(0.5), "drag");
        test.Session.Edits.Set("/shapes/0/radius", JsonValue.Create(0.75), "drag");
        string after = before.Replace(
            "{ \"time\": 1, \"value\": 2 },   // large", "{ \"time\": 0.3, \"value\": 0.75 },   // large\n      { \"time\": 1, \"value\": 2 },", StringComparison.Ordinal);
        Assert.Equal(after, test.Session.Document.Text);
        test.Session.Edits.Set("/camera/fieldOfView", JsonValue.Create(30));
        Assert.Contains("\"fieldOfView\": 30", test.Session.Document.Text, StringComparison.Ordinal);
        test.Session.Document.Undo();
        test.Session.Document.Undo();
        Assert.Equal(before, test.Session.Document.Text);

        // As it is seen at the frame: a ball of 1.3 is made twice as large.
        test.Session.Edits.Place("/shapes/0", new(Scale: new(2)));
        await test.Session.Document.WhenBuilt();
        Assert.Equal(2.6f, (float)Keys(test)[1]!["value"]!.GetValue<double>(), 1e-5f);
        Assert.Equal(JsonText.Of(before).At("/shapes/0/radius").Text, JsonText.Of(test.Session.Document.Text).At("/shapes/0/radius").Text);
    }

    [Fact]
    public async Task A_key_at_each_frame_is_met_exactly()
    {
        using TestSession test = new();
        await test.Open(Ball.Replace("\"framesPerSecond\": 10", "\"framesPerSecond\": 24", StringComparison.Ordinal));
        for (int frame = 1; frame < 24; frame++)
        {
            test.Session.Timeline.Show(frame);
            test.Session.Edits.Set("/shapes/0/radius", JsonValue.Create(1 + (frame % 7)));
            Assert.Equal(frame + 2, Keys(test).Count);
            SceneReadResult read = SceneReader.ReadText(test.Session.Document.Text, "", frame: frame);
            Assert.Equal(1 + (frame % 7), ((RayTracer.Shapes.SphereDescription)read.Description!.Shapes[0]).Radius);
        }
    }

    [Fact]
    public async Task Keys_are_made_moved_copied_eased_and_deleted()
    {
        using TestSession test = new();
        await test.Open(Ball);
        Timeline timeline = test.Session.Timeline;
        KeyChoice[] first = [new("/animation/0/keys", [0])];
        timeline.MoveKeys(first, 12, copies: false);
        Assert.Equal([1, 1.2f], Times(test));
        Assert.Contains("\"time\": 1.2, \"value\": 1 }", test.Session.Document.Text, StringComparison.Ordinal);
        test.Session.Document.Undo();
        timeline.MoveKeys(first, 5, copies: true);
        Assert.Equal([0, 0.5f, 1], Times(test));

        // Of two at a frame the one that was moved stays.
        timeline.MoveKeys(first, 10, copies: false);
        Assert.Equal([0.5f, 1], Times(test));
        Assert.Equal(1, Keys(test)[1]!["value"]!.GetValue<double>());
        timeline.EaseKeys(first, Ease.Smooth);
        Assert.Equal("smooth", Keys(test)[0]!["ease"]!.GetValue<string>());
        timeline.EaseKeys(first, Ease.Linear);
        Assert.Null(Keys(test)[0]!["ease"]);
        timeline.RemoveKeys([new("/animation/0/keys", [0, 1])]);
        Assert.DoesNotContain("animation", test.Session.Document.Text, StringComparison.Ordinal);
        Assert.Equal(0, timeline.State.Frames);
        test.Session.Document.Undo();
        Assert.Throws<SessionException>(() => timeline.RemoveKeys([new("/animation/0/keys", [2])]));
        Assert.Throws<SessionException>(() => timeline.MoveKeys([new("/shapes", [0])], 1, copies: false));

        timeline.Show(4);
        timeline.ToggleKey("/shapes/0/center");
        Assert.Equal(["shapes.ball.radius", "shapes.ball.center"], timeline.Rows.Select(r => r.Label));
        Assert.Equal("[0,1,0]", Json(timeline.Rows[1].Items.Single().Value));
        Assert.NotNull((await test.Session.Document.WhenBuilt()).Load.Scene);
        Assert.True(timeline.State.Values[1].HasKey);
        timeline.ToggleKey("/shapes/0/center");
        Assert.Single(timeline.Rows);
        Assert.Throws<SessionException>(() => timeline.ToggleKey("/shapes/0/name"));
    }

    [Fact]
    public async Task Each_track_that_is_made_has_a_line_however_often_its_values_change()
    {
        using TestSession test = new();
        await test.Open("""
            {
              "camera": { "position": [0, 1.6, 5.123456], "lookAt": [0, 0.912345, 0] },
              "shapes": [{ "type": "sphere", "name": "a ball with a very long name, so that its track reaches far to the right", "center": [0.123456, 1.123456, 2.123456] }]
            }
            """);
        foreach (string pointer in new[] { "/camera/position", "/camera/lookAt", "/shapes/0/center" })
        {
            test.Session.Timeline.ToggleKey(pointer);
        }

        test.Session.Timeline.Show(12);
        test.Session.Edits.Set("/shapes/0/center", new JsonArray(1.234567, 2.345678, 3.456789), "drag");
        test.Session.Edits.Set("/shapes/0/center", new JsonArray(1.345678, 2.345678, 3.456789), "drag");
        string text = test.Session.Document.Text;
        Assert.EndsWith("""
              "animation": [
                { "property": "camera.position", "keys": [{ "time": 0, "value": [0, 1.6, 5.123456] }] },
                { "property": "camera.lookAt", "keys": [{ "time": 0, "value": [0, 0.912345, 0] }] },
                { "property": "shapes[0].center", "keys": [{ "time": 0, "value": [0.123456, 1.123456, 2.123456] }, { "time": 0.5, "value": [1.345678, 2.345678, 3.456789] }] }
              ]
            }
            """, text.Replace("shapes.a ball with a very long name, so that its track reaches far to the right", "shapes[0]", StringComparison.Ordinal), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Keyframes_of_a_motion_are_moved_too()
    {
        using TestSession test = new();
        await test.OpenShipped("animation/01-turn.json", 16, 1);
        test.Session.Timeline.MoveKeys([new("/shapes/3/motion", [16])], 24, copies: false);
        Assert.Equal(72, test.Session.Timeline.State.Frames);
        Assert.NotNull((await test.Session.Document.WhenBuilt()).Load.Scene);
    }

    [Fact]
    public async Task Playing_shows_other_frames_until_it_is_stopped()
    {
        using TestSession test = new();
        await test.Open(Ball);
        Assert.Throws<SessionException>(() => test.Session.Timeline.Show(-1));
        test.Session.Timeline.Play();
        Assert.True(test.Session.Timeline.State.IsPlaying);
        await test.Until(() => test.Session.View.Shown is { Good.Frame: > 0 } shown ? shown : null);
        await test.Until(() => test.Session.View.Shown is { Good.Frame: 0 } shown ? shown : null);
        test.Session.Timeline.Show(2);
        Assert.False(test.Session.Timeline.State.IsPlaying);
        await Shown(test, 2);
    }

    [Fact]
    public async Task Ways_of_what_moves_are_where_it_is_seen()
    {
        using TestSession test = new();
        await test.OpenShipped("animation/01-turn.json", 100, 1);
        MotionPaths paths = test.Session.Timeline.Paths("/shapes/3");
        Assert.Equal((49, 49), (paths.Camera.Count, paths.Thing.Count));
        ViewportScene shown = test.Session.View.RequireShown();
        Assert.Equal(CameraFrame.Of(shown).Project(new(1.4f, 0.3f, 0.2f)), paths.Thing[0]);
        Assert.True(Vector2.Distance(CameraFrame.Of(shown).Project(new(1.4f, 1.9f, 0.2f))!.Value, paths.Thing[12]!.Value) < 1e-3f);
        Assert.Null(paths.Camera[0]);
        Assert.Empty(test.Session.Timeline.Paths("/shapes/0").Thing);
    }

    [SkippableFact]
    public async Task A_video_is_made_of_the_frames_by_a_program_that_is_looked_for()
    {
        Skip.If(OperatingSystem.IsWindows(), "the program that stands for ffmpeg is a shell script");
        using TestSession test = new();
        await test.Open(Ball);
        Assert.Null(VideoFile.Find(test.Folder));
        string program = Path.Combine(test.Folder, "ffmpeg");
        await File.WriteAllTextAsync(program, "#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"$last\"\n");
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        }

        Assert.Equal(program, VideoFile.Find($"nowhere{Path.PathSeparator}{test.Folder}"));
        string path = Path.Combine(test.Folder, "ball.mp4");
        VideoFile.Make(program, test.Folder, 3, 10, path, CancellationToken.None);
        Assert.Contains($"-framerate 10 -start_number 3 -i {test.Folder}/%07d.png", await File.ReadAllTextAsync(path), StringComparison.Ordinal);
        await File.WriteAllTextAsync(program, "#!/bin/sh\necho no such codec >&2\nexit 1\n");
        Assert.Contains("no such codec", Assert.Throws<SessionException>(() => VideoFile.Make(program, test.Folder, 3, 10, path, CancellationToken.None)).Message, StringComparison.Ordinal);
        if (VideoFile.Program is null)
        {
            Assert.Contains("ffmpeg", Assert.Throws<SessionException>(() => test.Session.Background.Frames(0, 1, path, overwrite: true)).Message, StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task All_frames_become_one_animated_PNG()
    {
        using TestSession test = new();
        await test.Open(Ball);
        test.Session.Background.Frames(0, 3, "ball.apng", overwrite: false);
        await test.Until(() => test.Session.Jobs.Running.Count == 0 ? test : null);
        Assert.StartsWith("wrote 4 frames", test.Session.Notices.Newest?.Text, StringComparison.OrdinalIgnoreCase);
        Assert.True(File.Exists(Path.Combine(test.Folder, "ball.apng")));
    }

    private static Task<ViewportScene> Shown(TestSession test, int frame) => test.Until(() => test.Session.View.Shown is { } shown && shown.Good.Frame == frame ? shown : null);

    private static JsonArray Keys(TestSession test) => (JsonArray)JsonValues.Of(JsonText.Of(test.Session.Document.Text).At("/animation/0/keys"))!;

    private static IEnumerable<float> Times(TestSession test) => Keys(test).Select(k => (float)k!["time"]!.GetValue<double>());

    private static JsonNode? Value(TestSession test, string pointer) => test.Session.Timeline.State.Values.Single(v => v.Pointer == pointer).Value;

    private static string Json(JsonNode? value) => value!.ToJsonString();
}
