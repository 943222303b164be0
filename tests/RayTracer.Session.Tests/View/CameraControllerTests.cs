using System.Numerics;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class CameraControllerTests
{
    private const string Scene = """
        {
          // a comment that stays
          "camera": { "position": [0, 1, 5], "lookAt": [0, 0.5, 0] },
          "render": { "integrator": "report", "width": 60, "height": 40, "samplesPerPixel": 4 },
          "background": [0.5, 0.6, 0.7],
          "shapes": [ { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5 } ]
        }
        """;

    [Fact]
    public async Task Looking_around_is_seen_at_once_and_changes_no_text()
    {
        using TestSession test = new();
        ViewportScene opened = await test.Open(Scene);
        string before = test.Session.Document.Text;
        for (int i = 0; i < 5; i++)
        {
            test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.1f, 0.02f, Gesture: "g", End: i == 4));
        }

        Assert.NotEqual(opened.Camera.Position, test.Session.View.Shown!.Camera.Position);
        Assert.False(test.Session.View.IsSceneCamera);
        Assert.Equal(before, test.Session.Document.Text);
        Assert.False(test.Session.Document.Status.CanUndo);
        Assert.DoesNotContain("--set", test.Session.Pictures.Command(), StringComparison.Ordinal);

        test.Session.Camera.Move(new(CameraMoveKind.Home));
        Assert.True(test.Session.View.IsSceneCamera);
        Assert.Equal(opened.Camera, test.Session.View.Shown!.Camera);
    }

    [Fact]
    public async Task The_scenes_camera_is_set_to_the_view_as_one_step_with_no_more_digits_than_are_seen()
    {
        using TestSession test = new();
        await test.Open(Scene);
        string before = test.Session.Document.Text;
        test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.123456f, 0.0345678f));
        CameraFrame seen = CameraFrame.Of(test.Session.View.Shown!);

        test.Session.Camera.Write();
        await test.Session.Document.WhenBuilt();
        await test.Until(() => test.Session.View.Shown!.Good.Revision == test.Session.Document.Revision ? test.Session.View.Shown : null);

        Assert.True(test.Session.View.IsSceneCamera);
        Assert.Contains("a comment that stays", test.Session.Document.Text, StringComparison.Ordinal);
        Assert.Contains("\"lookAt\": [0, 0.5, 0]", test.Session.Document.Text, StringComparison.Ordinal);
        Assert.Matches("""
            "position": \[-?\d(\.\d{1,3})?, -?\d(\.\d{1,3})?, -?\d(\.\d{1,3})?\]
            """.Trim(), test.Session.Document.Text);
        foreach (Vector3 corner in new Vector3[] { new(-1, 0, 0), new(1, 1, 0), new(0, 0.5f, 0.5f) })
        {
            Assert.True(Vector2.Distance(seen.Project(corner)!.Value, CameraFrame.Of(test.Session.View.Shown!).Project(corner)!.Value) < 0.2f);
        }

        test.Session.Document.Undo();
        Assert.Equal(before, test.Session.Document.Text);
        Assert.False(test.Session.Document.Status.CanUndo);
    }

    [Fact]
    public async Task A_view_ends_when_the_scenes_camera_is_put_elsewhere_and_keeps_its_place_when_only_the_lens_changes()
    {
        using TestSession test = new();
        await test.Open(Scene);
        test.Session.Camera.Move(new(CameraMoveKind.Dolly, 0, 0.2f));
        Vector3 eye = test.Session.View.Shown!.Camera.Position;
        await Edit(test, t => t.Set("/camera/lens/apertureRadius", 0.1));
        Assert.Equal((eye, 0.1f), (test.Session.View.Shown!.Camera.Position, test.Session.View.Shown.Camera.Lens.ApertureRadius));
        await Edit(test, t => t.Set("/camera/fieldOfView", 50));
        Assert.True(test.Session.View.IsSceneCamera);
    }

    [Fact]
    public async Task An_orbit_turns_around_what_was_under_the_pointer_when_it_began()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene.Replace("[0, 0.5, 0], \"radius\": 0.5", "[1.2, 0.5, 0], \"radius\": 0.5", StringComparison.Ordinal));
        Vector2 pixel = CameraFrame.Of(shown).Project(new(1.2f, 0.5f, 0.5f))!.Value;
        Vector3 point = Picking.At(shown, pixel.X, pixel.Y).Position!.Value;
        for (int i = 0; i < 4; i++)
        {
            test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.1f, 0.05f, Gesture: "g", Around: pixel));
        }

        Vector2 there = CameraFrame.Of(test.Session.View.Shown!).Project(point)!.Value;
        Assert.True(Vector2.Distance(there, pixel) < 1.5f, $"{there} is not {pixel}");
        Assert.Equal((shown.Camera.Position - point).Length(), (test.Session.View.Shown!.Camera.Position - point).Length(), 1e-3f);
    }

    [Fact]
    public async Task What_is_framed_fills_the_picture_and_axes_are_looked_along()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene.Replace("[0, 0.5, 0], \"radius\": 0.5", "[7, -2, 30], \"radius\": 0.01", StringComparison.Ordinal));
        test.Session.Camera.Move(new(CameraMoveKind.Frame, Pointer: "/shapes/0"));
        int covered = Picking.Mask(test.Session.View.Shown!, "/shapes/0").Runs.Where((_, i) => i % 2 == 1).Sum();
        Assert.InRange(covered / 2400.0, 0.1, 0.6);

        foreach (Vector3 from in new[] { Vector3.UnitX, -Vector3.UnitY, Vector3.UnitZ })
        {
            test.Session.Camera.Move(new(CameraMoveKind.Along, from.X, from.Y, from.Z));
            Assert.True(Vector3.Dot(CameraFrame.Of(test.Session.View.Shown!).Forward, from) < -0.99999f);
        }

        Assert.Throws<SessionException>(() => test.Session.Camera.Move(new(CameraMoveKind.Along)));
        Assert.Throws<SessionException>(() => test.Session.Camera.Move(new(CameraMoveKind.Frame, Pointer: "/shapes/5")));
        Assert.Equal(shown.Camera.Up, test.Session.View.Shown!.Camera.Up);
    }

    [Fact]
    public async Task Views_are_kept_for_a_scenes_next_time()
    {
        using TestSession test = new();
        await test.Open(Scene);
        test.Session.Camera.Move(new(CameraMoveKind.Dolly, 0, 0.2f));
        Vector3 eye = test.Session.View.Shown!.Camera.Position;
        test.Session.Bookmarks.Add(null);
        test.Session.Camera.Move(new(CameraMoveKind.Home));
        ViewBookmark kept = Assert.Single(test.Session.Bookmarks.All);
        test.Session.Camera.Look(test.Session.Bookmarks.Pose(kept.Id));
        Assert.Equal(eye.Z, test.Session.View.Shown!.Camera.Position.Z, 0.05f);
        test.Session.Files.Save(Path.Combine(test.Folder, "kept.json"), overwrite: true);
        test.Session.Bookmarks.Add("from the door");
        await test.Open(Scene);
        Assert.DoesNotContain("from the door", test.Session.Bookmarks.All.Select(b => b.Name));
        test.Session.Files.Open(Path.Combine(test.Folder, "kept.json"), discard: true);
        Assert.Contains("from the door", test.Session.Bookmarks.All.Select(b => b.Name));
        test.Session.Bookmarks.Remove(test.Session.Bookmarks.All[^1].Id);
        Assert.Throws<SessionException>(() => test.Session.Bookmarks.Remove(99));
    }

    [Fact]
    public async Task Focusing_writes_the_distance_along_the_view()
    {
        using TestSession test = new();
        await test.Open("""
            { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "lens": { "apertureRadius": 0.1 } }, "render": { "integrator": "report", "width": 60, "height": 40, "samplesPerPixel": 1 },
              "shapes": [ { "type": "plane", "point": [0, 0, -2], "normal": [0, 0, 1] } ] }
            """);
        Assert.Equal(7, test.Session.Camera.Focus(3, 37), 1e-4f);
        Assert.Equal(7, test.Session.Document.Read.Description!.Camera.Lens.FocusDistance, 1e-4f);
    }

    // What is shown until the next scene is read is no longer open: that is no fault of the camera's.
    [Fact]
    public async Task While_another_scene_is_read_there_is_nothing_to_move_in()
    {
        using TestSession test = new();
        for (int i = 0; i < 20; i++)
        {
            await test.Open(Scene);
            test.Session.Document.Open(Scene, new($"{i}.json", null, test.Folder), isSaved: true);
            SessionException? refusal = (SessionException?)Record.Exception(() => test.Session.Camera.Move(new(CameraMoveKind.Dolly, 0, 0.1f, Gesture: "g")));
            Assert.True(refusal is null or { Fault: SessionFault.Missing }, refusal?.Message);
        }
    }

    [Fact]
    public async Task A_camera_that_cannot_be_is_refused_and_the_last_one_stays()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        Assert.Throws<SessionException>(() => test.Session.Camera.Move(new(CameraMoveKind.Set, End: true) { LookAt = shown.Camera.Position }));
        Assert.Equal(shown.Camera, test.Session.View.Shown!.Camera);
    }

    [Fact]
    public async Task Edits_that_change_no_thing_leave_the_picture_alone_and_others_do_not()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        await Edit(test, t => t.With(new TextEdit(0, 0, "// another comment\n")));
        Assert.Equal(shown.Picture, test.Session.View.Shown!.Picture);
        await Edit(test, t => t.Set("/shapes/0/radius", 0.6));
        Assert.NotEqual(shown.Picture, test.Session.View.Shown!.Picture);
    }

    [Fact]
    public async Task A_text_that_is_no_scene_leaves_the_last_picture()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        test.Session.Document.TryReplace(test.Session.Document.Revision, 0, 1, "", null);
        await test.Session.Document.WhenBuilt();
        Assert.Equal(shown.Picture, test.Session.View.Shown!.Picture);
    }

    private static async Task Edit(TestSession test, Func<JsonText, JsonText> change)
    {
        test.Session.Document.Change("edit", null, change);
        await test.Session.Document.WhenBuilt();
        await test.Until(() => test.Session.View.Shown!.Good.Revision == test.Session.Document.Revision ? test.Session.View.Shown : null);
    }
}
