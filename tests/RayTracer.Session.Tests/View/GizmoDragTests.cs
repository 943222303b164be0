using System.Numerics;

namespace RayTracer.Session.Tests;

/// <summary>Handles do to a thing in the world what the pointer does in the picture.</summary>
public sealed class GizmoDragTests
{
    private static readonly CameraFrame Camera = new(new(0, 0, 5), Vector3.UnitX, Vector3.UnitY, -Vector3.UnitZ, 40, 400, 300);
    private static readonly Vector3 Center = new(0.3f, -0.2f, 0.5f);
    private readonly GizmoDrag _drag = new(Camera, Center);

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void What_is_dragged_along_an_axis_stays_under_the_pointer(int axis)
    {
        Vector3 direction = axis == 0 ? Vector3.UnitX : Vector3.UnitY;
        (Vector2 from, Vector2 to) = (At(Center + direction), At(Center + (1.5f * direction)));
        Near(0.5f * direction, _drag.Between(GizmoKind.Move, axis, from, to)!.Translate);
        Near(Vector3.One + (0.5f * direction), _drag.Between(GizmoKind.Scale, axis, from, to)!.Scale);
        Near(0.5f * direction, _drag.Between(GizmoKind.Move, null, from, to)!.Translate);
    }

    [Fact]
    public void A_quarter_of_a_ring_is_a_turn_by_ninety_degrees()
    {
        Turn turn = _drag.Between(GizmoKind.Rotate, 2, At(Center + Vector3.UnitX), At(Center + Vector3.UnitY))!.Rotate!;
        Assert.Equal(90, turn.Degrees, 0.01);
        Assert.Equal(Vector3.UnitZ, turn.Axis);
        Assert.Equal(Center, turn.Center);
    }

    [Fact]
    public void An_undefined_movement_changes_nothing()
    {
        GizmoDrag straight = new(Camera, Vector3.Zero);
        Assert.Null(straight.Between(GizmoKind.Move, 2, new(200, 150), new(200, 150)));
        Assert.Null(straight.Between(GizmoKind.Rotate, 0, new(200, 150), new(200, 140)));
        Assert.Null(Camera.Project(new(0, 0, 6)));
        Assert.Equal(new(200, 150), Camera.Project(Vector3.Zero));
    }

    [Fact]
    public async Task A_dragged_thing_follows_slow_and_quick_pointers_and_its_numbers_stay_short()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open("""
            {
              "camera": { "position": [0.3, 2, 8], "lookAt": [0, 1, 0] },
              "render": { "integrator": "path", "width": 120, "height": 80, "samplesPerPixel": 1 },
              "shapes": [ { "type": "sphere", "center": [1, 0.5, 0], "radius": 0.5 } ],
              "lights": []
            }
            """);
        CameraFrame camera = CameraFrame.Of(shown);
        Vector2 from = camera.Project(new(1, 0.5f, 0))!.Value;
        Vector2 to = camera.Project(new(-0.5f, 0.5f, 0))!.Value;
        const int Steps = 400;
        for (int i = 1; i <= Steps; i++)
        {
            test.Session.Handles.Drag(new("/shapes/0", GizmoKind.Move, 0, from, Vector2.Lerp(from, to, (float)i / Steps), "slow"));
        }

        string center = System.Text.RegularExpressions.Regex.Match(test.Session.Document.Text, "\"center\": \\[(.*?),").Groups[1].Value;
        float x = float.Parse(center, System.Globalization.CultureInfo.InvariantCulture);
        Assert.True(MathF.Abs(x + 0.5f) < camera.LengthOf(0.5f, new(0, 0.5f, 0)), center);
        Assert.True(center.Length <= "-0.123".Length, center);
    }

    private Vector2 At(Vector3 point) => Camera.Project(point)!.Value;

    private static void Near(Vector3 expected, Vector3? actual) => Assert.True((expected - actual!.Value).Length() < 1e-4f, $"{expected} {actual}");

    [Theory]
    [InlineData(GizmoKind.Move)]
    [InlineData(GizmoKind.Rotate)]
    public void Handles_are_as_long_as_asked_and_lie_along_their_axes(GizmoKind kind)
    {
        GizmoHandles handles = new Gizmo(Center, 1, Center - Vector3.One, Center + Vector3.One).Handles(Camera, kind, 50);
        Assert.Equal([0, 1, 2], handles.Handles.Select(h => h.Axis));
        Assert.Equal(At(Center), handles.Center);
        if (kind == GizmoKind.Move)
        {
            Assert.All(handles.Handles, h => Assert.Equal(handles.Center, h.Points[0]));
            Assert.Equal(handles.Center!.Value.X + 50, handles.Handles[0].Points[1].X, 1e-3f);
        }
        else
        {
            Assert.All(handles.Handles[2].Points, p => Assert.Equal(50, Vector2.Distance(p, handles.Center!.Value), 1e-3f));
        }
    }

    [Fact]
    public async Task A_dragged_thing_ends_where_the_pointer_does_however_many_steps_arrive()
    {
        string[] texts = await Task.WhenAll(new[] { 1, 7 }.Select(async steps =>
        {
            using TestSession test = new();
            ViewportScene shown = await test.Open("""{ "camera": { "position": [0, 0, 5] }, "render": { "integrator": "report", "width": 100, "height": 100 }, "shapes": [{ "type": "sphere", "center": [0, 0, 0] }] }""");
            Vector2 from = CameraFrame.Of(shown).Project(Vector3.Zero)!.Value;
            Vector2 to = CameraFrame.Of(shown).Project(new(1, 0.5f, 0))!.Value;
            for (int i = 1; i <= steps; i++)
            {
                test.Session.Handles.Drag(new("/shapes/0", GizmoKind.Move, null, from, Vector2.Lerp(from, to, i / (float)steps), "g"));
            }

            Vector3 center = SceneValue.At(JsonText.Of(test.Session.Document.Text).Root, "/shapes/0")!.Vector("center");
            Near(new(1, 0.5f, 0), center);
            test.Session.Document.Undo();
            return test.Session.Document.Text;
        }));
        Assert.Equal(texts[0], texts[1]);
        Assert.Contains("[0, 0, 0]", texts[0], StringComparison.Ordinal);
    }
}
