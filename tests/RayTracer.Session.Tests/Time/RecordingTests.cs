using System.Numerics;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>While keys are recorded, what hands change in the picture becomes keys at the frame that is shown.</summary>
public sealed class RecordingTests
{
    private const string Things = """
        {
          "camera": { "position": [0, 0, 8], "lookAt": [0, 0, 0] },
          "render": { "width": 40, "height": 40, "samplesPerPixel": 1, "framesPerSecond": 10 },
          "background": [1, 1, 1],
          "shapes": [
            { "type": "sphere", "name": "ball", "center": [0, 0, 0], "radius": 1 },   // rests
            { "type": "sphere", "name": "grows", "center": [2, 0, 0], "radius": 1 },
            { "type": "torus", "name": "ring", "center": [-2, 0, 0], "transform": [{ "rotate": 30 }] },
            { "type": "box", "name": "goes", "a": [0, -1, 0], "b": [1, 0, 1], "motion": [{ "time": 0, "transform": [{ "translate": [0, 0, 0] }] }, { "time": 1, "transform": [{ "translate": [4, 0, 0] }] }] },
            { "type": "group", "transform": [{ "scale": [1, 2, 1] }], "shapes": [{ "type": "torus", "center": [0, -2, 0] }] },
          ],
          "lights": [{ "type": "spot", "name": "beam", "position": [0, 5, 0], "direction": [0, -1, 0] }],
          "animation": [
            { "property": "shapes.grows.center", "keys": [{ "time": 0, "value": [2, 0, 0] }, { "time": 1, "value": [2, 1, 0] }] }
          ],
        }
        """;

    [Fact]
    public async Task A_thing_that_rests_gets_a_key_and_what_is_written_of_it_stays()
    {
        using TestSession test = new();
        await Begin(test, 5);
        Place(test, "/shapes/0", new(new(0, 1, 0)));
        Assert.Contains("\"center\": [0, 0, 0], \"radius\": 1 },   // rests", test.Session.Document.Text, StringComparison.Ordinal);
        Assert.Equal("[0.5: [0,1,0]]", KeysOf(test, "shapes.ball.center"));
        Assert.Null(test.Session.Timeline.State.Complaint);

        // A gesture is one step to undo, and one key.
        Place(test, "/shapes/0", new(new(0, 0.5f, 0)), "g");
        Place(test, "/shapes/0", new(new(0, 0.5f, 0)), "g");
        Assert.Equal("[0.5: [0,2,0]]", KeysOf(test, "shapes.ball.center"));
        test.Session.Document.Undo();
        Assert.Equal("[0.5: [0,1,0]]", KeysOf(test, "shapes.ball.center"));
        test.Session.Document.Undo();
        Assert.Equal(Things, test.Session.Document.Text);
    }

    [Fact]
    public async Task A_handle_that_is_dragged_over_the_picture_records_too()
    {
        using TestSession test = new();
        await Begin(test, 5);
        test.Session.Handles.Drag(new("/shapes/0", GizmoKind.Move, 0, new(20, 20), new(25, 20), "h"));
        test.Session.Handles.Drag(new("/shapes/0", GizmoKind.Move, 0, new(20, 20), new(30, 20), "h"));
        Assert.StartsWith("[0.5: [1.4", KeysOf(test, "shapes.ball.center"), StringComparison.Ordinal);
        test.Session.Document.Undo();
        Assert.Equal(Things, test.Session.Document.Text);
        test.Session.LightHandles.Drag(new("/lights/0", LightHandleKind.Cone, new(30, 5), "l"));
        Assert.NotEqual("none", KeysOf(test, "lights.beam.cutoffAngle"));
    }

    [Fact]
    public async Task What_has_keys_gets_another_one_and_turns_have_keys_of_their_steps()
    {
        using TestSession test = new();
        await Begin(test, 5);
        Place(test, "/shapes/1", new(new(1, 0, 0)));
        Assert.Equal("[0: [2,0,0]; 0.5: [3,0.5,0]; 1: [2,1,0]]", KeysOf(test, "shapes.grows.center"));
        Place(test, "/shapes/2", new(Rotate: new(Vector3.UnitY, 20, Vector3.Zero)));
        Assert.Equal("[0.5: 50]", KeysOf(test, "shapes.ring.transform[0].rotate"));
        Place(test, "/shapes/2", new(Scale: new(1, 2, 1), Center: Vector3.Zero));
        Assert.Equal("[0.5: [1,2,1]]", KeysOf(test, "shapes.ring.transform[1].scale"));
        Assert.Contains("{ \"scale\": [1, 1, 1] }", test.Session.Document.Text, StringComparison.Ordinal);
        Assert.True(test.Session.Document.Read.Description is not null, string.Join('\n', test.Session.Document.Read.Diagnostics));
    }

    [Fact]
    public async Task A_motion_gets_a_keyframe_there()
    {
        using TestSession test = new();
        await Begin(test, 5);
        Place(test, "/shapes/3", new(new(0, 3, 0)));
        JsonNode motion = test.Session.Document.Read.Root!.Find("shapes")!.Items[3].Find("motion")!;
        Assert.Equal([0, 0.5f, 1], motion.Items.Select(k => k.Find("time")!.Number!.Value));
        Vector3 Middle(double time) => ShapePlacement.MiddleAt(test.Session.Document.Read.Root!, "/shapes/3", time);
        Near(new(0.5f, -0.5f, 0.5f), Middle(0));
        Near(new(2.5f, 2.5f, 0.5f), Middle(0.5));
        Near(new(4.5f, -0.5f, 0.5f), Middle(1));
        Place(test, "/shapes/3", new(new(0, -1, 0)));
        Near(new(2.5f, 1.5f, 0.5f), Middle(0.5));
        Assert.Equal(3, test.Session.Document.Read.Root!.Find("shapes")!.Items[3].Find("motion")!.Items.Count);
        Assert.True(test.Session.Document.Read.Description is not null, string.Join('\n', test.Session.Document.Read.Diagnostics));
    }

    [Fact]
    public async Task The_camera_is_recorded_where_it_is_set()
    {
        using TestSession test = new();
        await Begin(test, 5);
        test.Session.Camera.Move(new(CameraMoveKind.Set) { Position = new(1, 2, 6) });
        test.Session.Camera.Write();
        Assert.Equal("[0.5: [1,2,6]]", KeysOf(test, "camera.position"));
        Assert.Contains("\"position\": [0, 0, 8]", test.Session.Document.Text, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_panel_says_why_a_change_is_no_key()
    {
        using TestSession test = new();
        await Begin(test, 5);
        Place(test, "/shapes/4/shapes/0", new(Rotate: new(Vector3.UnitX, 20)));
        Assert.Equal("shapes.4.shapes.0.transform.0 was changed as it is written: a matrix has no keys", test.Session.Timeline.State.Complaint);
        Assert.Contains("\"matrix\"", test.Session.Document.Text, StringComparison.Ordinal);
        Place(test, "/shapes/0", new(new(0, 1, 0)));
        Assert.Null(test.Session.Timeline.State.Complaint);
        test.Session.Timeline.Show(null);
        Place(test, "/shapes/0", new(new(0, 1, 0)));
        Assert.Contains("choose a frame", test.Session.Timeline.State.Complaint, StringComparison.Ordinal);
        test.Session.Timeline.Record(false);
        Assert.Null(test.Session.Timeline.State.Complaint);
        test.Session.Timeline.Show(7);
        Place(test, "/shapes/1", new(new(0, 0, 1)));
        Assert.Contains("0.7:", KeysOf(test, "shapes.grows.center"), StringComparison.Ordinal);
        Place(test, "/shapes/2", new(new(0, 1, 0)));
        Assert.DoesNotContain(test.Session.Timeline.Rows, r => r.Label.StartsWith("shapes.ring", StringComparison.Ordinal));
    }

    private static async Task Begin(TestSession test, int frame)
    {
        await test.Open(Things);
        test.Session.Timeline.Show(frame);
        test.Session.Timeline.Record(true);
        await test.Until(() => test.Session.View.Shown?.Good.Frame == frame ? test : null);
    }

    private static void Place(TestSession test, string pointer, Placement change, string? gesture = null) => test.Session.Edits.Place(pointer, change, gesture);

    private static string KeysOf(TestSession test, string property) => test.Session.Timeline.Rows.FirstOrDefault(r => r.Label == property) is { } row
        ? $"[{string.Join("; ", row.Items.Select(k => $"{k.Frame / 10:0.###}: {k.Value!.ToJsonString()}"))}]" : "none";

    private static void Near(Vector3 expected, Vector3 actual) => Assert.True((expected - actual).Length() < 1e-4f, $"{expected} {actual}");
}
