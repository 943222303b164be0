using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class CameraMotionTests
{
    private static readonly CameraDescription Camera = new() { Position = new(3, 2, 7), LookAt = new(0.5f, 1, -1), Up = new(0.1f, 2, 0), FieldOfView = 50 };

    [Theory]
    [InlineData(0.1f, 0)]
    [InlineData(-0.7f, 0.2f)]
    [InlineData(0.3f, -0.4f)]
    [InlineData(2.5f, 9)]
    public void Orbiting_keeps_the_distance_the_point_looked_at_and_what_is_up(float dx, float dy)
    {
        CameraDescription moved = CameraMotion.Orbit(Camera, dx, dy);
        Assert.Equal(Distance(Camera), Distance(moved), 1e-4f);
        Assert.Equal((Camera.LookAt, Camera.Up, Camera.FieldOfView), (moved.LookAt, moved.Up, moved.FieldOfView));
        Assert.True(CameraMotion.Axes(moved).Right.IsFinite());
    }

    [Fact]
    public void Orbiting_never_goes_over_the_pole()
    {
        CameraDescription moved = Camera;
        for (int i = 0; i < 100; i++)
        {
            moved = CameraMotion.Orbit(moved, 0.01f, 0.2f);
            Vector3 arm = (moved.Position - moved.LookAt).Unit();
            Assert.InRange(arm.Dot(Camera.Up.Unit()), -0.99999f, 0.99999f);
        }

        Assert.True((moved.Position - moved.LookAt).Dot(Camera.Up) > 0);
    }

    [Fact]
    public void Orbiting_to_the_right_shows_the_left_side_of_things()
    {
        Vector3 right = CameraMotion.Axes(Camera).Right;
        CameraDescription moved = CameraMotion.Orbit(Camera, 0.05f, 0);
        Assert.True((moved.Position - Camera.Position).Dot(right) < 0);
        Assert.True(CameraMotion.Orbit(Camera, 0, 0.05f).Position.Dot(Camera.Up) > Camera.Position.Dot(Camera.Up));
    }

    [Theory]
    [InlineData(FieldOfViewAxis.Vertical, 1.5f)]
    [InlineData(FieldOfViewAxis.Horizontal, 1.5f)]
    [InlineData(FieldOfViewAxis.Smaller, 0.5f)]
    [InlineData(FieldOfViewAxis.Larger, 0.5f)]
    public void Panning_moves_the_point_under_the_cursor_by_as_much(FieldOfViewAxis axis, float aspect)
    {
        CameraDescription camera = Camera with { FieldOfViewAxis = axis };
        (Vector3 right, Vector3 up, _) = CameraMotion.Axes(camera);
        Vector3 point = camera.LookAt + (right * 0.7f) + (up * 0.4f);
        CameraDescription moved = CameraMotion.Pan(camera, 0.2f, -0.1f, aspect);
        (Vector2 before, Vector2 after) = (Project(camera, point, aspect), Project(moved, point, aspect));
        Assert.Equal(0.2f, after.X - before.X, 1e-4f);
        Assert.Equal(-0.1f, after.Y - before.Y, 1e-4f);
    }

    [Fact]
    public void Zooming_changes_the_size_of_things_and_nothing_else()
    {
        Vector3 point = Camera.LookAt + CameraMotion.Axes(Camera).Up;
        CameraDescription nearer = CameraMotion.Zoom(Camera, -0.5f);
        Assert.Equal(2, Project(nearer, point, 1).Y / Project(Camera, point, 1).Y, 1e-3f);
        Assert.Equal(Camera, nearer with { FieldOfView = Camera.FieldOfView });
        Assert.InRange(CameraMotion.Zoom(Camera, 100).FieldOfView, 100, 179);
        Assert.InRange(CameraMotion.Zoom(Camera, -100).FieldOfView, 0.01f, 1);
    }

    [Fact]
    public void An_orthographic_camera_comes_nearer_by_showing_less()
    {
        CameraDescription flat = Camera with { Projection = Projection.Orthographic, ViewSize = 4 };
        Assert.Equal(2, CameraMotion.Zoom(flat, -0.5f).ViewSize, 1e-3f);
        Assert.Equal(flat with { ViewSize = 2 }, CameraMotion.Dolly(flat, -0.5f) with { ViewSize = 2 });
        Assert.Equal(2, CameraMotion.HeightAt(flat with { FieldOfViewAxis = FieldOfViewAxis.Horizontal }, 123, 2), 1e-5f);
        Assert.Equal(4 / MathF.Sqrt(5), CameraMotion.HeightAt(flat with { FieldOfViewAxis = FieldOfViewAxis.Diagonal }, 123, 2), 1e-5f);
    }

    [Fact]
    public void A_spherical_camera_has_no_field_of_view_to_change()
    {
        CameraDescription all = Camera with { Projection = Projection.Spherical };
        Assert.Throws<SessionException>(() => CameraMotion.Zoom(all, 1));
        Assert.Equal(Camera.Position, CameraMotion.Rotate(all, 0.1f, 0).Position);
        Assert.NotEqual(Camera.Position, CameraMotion.Pan(all, 0.1f, 0, 2).Position);
    }

    [Fact]
    public void Dollying_changes_the_distance_and_never_arrives()
    {
        Assert.Equal(Distance(Camera) / 2, Distance(CameraMotion.Dolly(Camera, -0.5f)), 1e-3f);
        Assert.Equal(Camera.LookAt, CameraMotion.Dolly(Camera, 1).LookAt);
        Assert.True(Distance(CameraMotion.Dolly(Camera, -3)) > 0);
    }

    [Fact]
    public void Flying_keeps_the_view_and_looking_keeps_the_place()
    {
        CameraDescription flown = CameraMotion.Translate(Camera, 0.1f, 0.2f, 0.3f);
        Assert.True((flown.LookAt - flown.Position - (Camera.LookAt - Camera.Position)).Norm() < 1e-5f);
        Assert.Equal(0.3f * Distance(Camera), (flown.Position - Camera.Position).Dot(CameraMotion.Axes(Camera).Forward), 1e-4f);
        CameraDescription turned = CameraMotion.Rotate(Camera, 0.1f, 0.1f);
        Assert.Equal(Camera.Position, turned.Position);
        Assert.Equal(Distance(Camera), Distance(turned), 1e-4f);
        Assert.True((turned.LookAt - Camera.LookAt).Dot(CameraMotion.Axes(Camera).Right) > 0);
        Assert.True((turned.LookAt - Camera.LookAt).Dot(CameraMotion.Axes(Camera).Up) < 0);
    }

    private static float Distance(CameraDescription camera) => (camera.Position - camera.LookAt).Norm();

    // In heights of the picture, to the right and downwards from its middle.
    private static Vector2 Project(CameraDescription camera, Vector3 point, float aspect)
    {
        (Vector3 right, Vector3 up, Vector3 forward) = CameraMotion.Axes(camera);
        Vector3 v = point - camera.Position;
        float height = 2 * v.Dot(forward) * MathF.Tan(camera.FieldOfView * MathF.PI / 360);
        bool isAcross = camera.FieldOfViewAxis switch
        {
            FieldOfViewAxis.Vertical => false,
            FieldOfViewAxis.Horizontal => true,
            FieldOfViewAxis.Smaller => aspect < 1,
            _ => aspect > 1,
        };
        height = isAcross ? height / aspect : height;
        return new(v.Dot(right) / height, -v.Dot(up) / height);
    }
}
