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
    public async Task A_gesture_is_seen_at_once_and_written_at_its_end_as_one_step()
    {
        using TestSession test = new();
        await test.Open(Scene);
        string before = test.Session.Document.Text;
        for (int i = 0; i < 5; i++)
        {
            test.Session.Camera.Move(new(CameraMoveKind.Orbit, 0.1f, 0.02f, Gesture: "g"));
            Assert.Equal(before, test.Session.Document.Text);
        }

        var seen = test.Session.View.Shown!.Camera;
        long picture = test.Session.View.Shown.Picture;
        test.Session.Camera.Move(new(CameraMoveKind.Orbit, Gesture: "g", End: true));
        await test.Session.Document.WhenBuilt();
        Assert.Equal(seen.Position, test.Session.Document.Read.Description!.Camera.Position);
        Assert.Contains("a comment that stays", test.Session.Document.Text, StringComparison.Ordinal);
        Assert.Contains("\"lookAt\": [0, 0.5, 0]", test.Session.Document.Text, StringComparison.Ordinal);

        // The text now says what is seen already: nothing is rendered again.
        await test.Until(() => test.Session.View.Shown!.Good.Revision == test.Session.Document.Revision ? test.Session.View.Shown : null);
        Assert.Equal(picture, test.Session.View.Shown!.Picture);
        test.Session.Document.Undo();
        Assert.Equal(before, test.Session.Document.Text);
        Assert.False(test.Session.Document.Status.CanUndo);
    }

    [Fact]
    public async Task Home_is_where_the_camera_was_when_the_document_was_opened()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        test.Session.Camera.Move(new(CameraMoveKind.Translate, 0.3f, 0.1f, 0.2f, "a", End: true));
        await test.Session.Document.WhenBuilt();
        test.Session.Camera.Move(new(CameraMoveKind.Home, Gesture: "b", End: true));
        Assert.Equal(shown.Camera.Position, test.Session.Document.Read.Description!.Camera.Position);
        Assert.Equal(shown.Camera.LookAt, test.Session.Document.Read.Description!.Camera.LookAt);
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
