using System.Numerics;
using RayTracer.Session;

namespace RayTracer.Desktop.Tests;

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
    public void What_cannot_be_told_changes_nothing()
    {
        GizmoDrag straight = new(Camera, Vector3.Zero);
        Assert.Null(straight.Between(GizmoKind.Move, 2, new(200, 150), new(200, 150)));
        Assert.Null(straight.Between(GizmoKind.Rotate, 0, new(200, 150), new(200, 140)));
        Assert.Null(straight.Project(new(0, 0, 6)));
        Assert.Equal(new(200, 150), straight.Project(Vector3.Zero));
    }

    private Vector2 At(Vector3 point) => _drag.Project(point)!.Value;

    private static void Near(Vector3 expected, Vector3? actual) => Assert.True((expected - actual!.Value).Length() < 1e-4f, $"{expected} {actual}");
}
