using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Handles around the selected shape, that move, turn and scale it.</summary>
/// <param name="hand">Carries changes to the session.</param>
internal sealed class GizmoViewModel(Hand hand) : Observable
{
    private const double Reach = 10;
    private const int RingPoints = 48;
    private static readonly Vector3[] Axes = [Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ];
    private static readonly string[] Colors = ["#d0493a", "#3c9a4e", "#3b72c4"];
    private static readonly string[] Names = ["move", "rotate", "scale"];
    private (Gizmo Gizmo, CameraFrame Camera, GizmoKind Kind, string Pointer)? _target;
    private (int? Axis, Spot Last, string Gesture)? _drag;
    private Vector3 _center;

    /// <summary>The handles.</summary>
    public IReadOnlyList<HandleViewModel> Handles { get; private set; } = [];

    /// <summary>Finds the selected shape, and shows its handles.</summary>
    /// <param name="pointer">The shape; null for none.</param>
    /// <param name="kind">What the handles do; null for none.</param>
    /// <param name="stage">Where the picture lies.</param>
    public async Task Follow(string? pointer, GizmoKind? kind, Stage stage)
    {
        _target = kind is { } k && pointer is not null && SceneThings.IsSeen(pointer) ? await hand.Ask(s => Find(s, pointer, k)) : null;
        _center = _drag is null ? _target?.Gizmo.Center ?? default : _center;
        Place(stage);
    }

    /// <summary>Shows the handles where the picture lies now.</summary>
    public void Place(Stage stage)
    {
        Handles = _target is not { } target ? [] : Drawn(target.Gizmo, target.Camera, target.Kind, stage);
        Tell(nameof(Handles));
    }

    /// <summary>Takes the handle under a point of the screen; false where there is none.</summary>
    public bool Take(Spot screen, Spot picture)
    {
        HandleViewModel? near = Handles.Where(h => h.DistanceTo(screen) < Reach).OrderBy(h => h.Axis is null ? 0 : h.DistanceTo(screen)).FirstOrDefault();
        _drag = near is null ? null : (near.Axis, picture, Gesture.New());
        return _drag is not null;
    }

    /// <summary>Drags the handle to a point of the picture.</summary>
    public void Drag(Spot picture)
    {
        if (_drag is not { } drag || _target is not { } target
            || new GizmoDrag(target.Camera, _center).Between(target.Kind, drag.Axis, drag.Last.AsVector(), picture.AsVector()) is not { } change)
        {
            return;
        }

        _drag = drag with { Last = picture };
        _center += change.Translate ?? Vector3.Zero;

        // One after another: each is a change since the last one.
        hand.Do(s => s.Edits.Place(target.Pointer, change, drag.Gesture));
    }

    /// <summary>Lets go of the handle.</summary>
    public void Drop() => _drag = null;

    private static (Gizmo, CameraFrame, GizmoKind, string)? Find(StudioSession session, string pointer, GizmoKind kind)
    {
        try
        {
            return session.View.Shown is { } shown ? (Gizmo.Of(shown, pointer), CameraFrame.Of(shown), kind, pointer) : null;
        }
        catch (SessionException)
        {
            // It has no end, or no lines can be drawn: there are no handles then.
            return null;
        }
    }

    private static List<HandleViewModel> Drawn(Gizmo gizmo, CameraFrame camera, GizmoKind kind, Stage stage)
    {
        GizmoDrag drag = new(camera, gizmo.Center);
        List<HandleViewModel> handles = [];
        Spot? middle = OnScreen(drag, gizmo.Center, stage);
        if (middle is { } m && kind != GizmoKind.Rotate)
        {
            string free = SessionTexts.Of(kind == GizmoKind.Move ? "viewport.free" : "viewport.all");
            handles.Add(new(null, [new(m.X - 5, m.Y), new(m.X + 5, m.Y), new(m.X, m.Y - 5), new(m.X, m.Y + 5)], "#888888", free));
        }

        for (int i = 0; i < 3; i++)
        {
            IEnumerable<Vector3> line = kind == GizmoKind.Rotate ? Ring(gizmo.Center, Axes[i], gizmo.Radius) : [gizmo.Center, gizmo.Center + (Axes[i] * (1.4f * gizmo.Radius))];
            Spot?[] points = [.. line.Select(p => OnScreen(drag, p, stage))];
            string name = $"{SessionTexts.Of($"viewport.{Names[(int)kind]}")} {SessionTexts.Of($"panel.axes.{i}")}";
            if (points.All(p => p is not null))
            {
                handles.Add(new(i, [.. points.Select(p => p!.Value)], Colors[i], name));
            }
        }

        return handles;
    }

    private static Spot? OnScreen(GizmoDrag drag, Vector3 point, Stage stage) => drag.Project(point) is { } p ? stage.ToScreen(new Spot(p.X, p.Y)) : null;

    private static IEnumerable<Vector3> Ring(Vector3 center, Vector3 axis, float radius)
    {
        Vector3 u = axis.Cross(MathF.Abs(axis.Y) < 0.9f ? Vector3.UnitY : Vector3.UnitX).Unit();
        Vector3 v = axis.Cross(u);
        return Enumerable.Range(0, RingPoints + 1).Select(i =>
        {
            LaneMath.SinCosTurn(i % RingPoints / (float)RingPoints, out float sin, out float cos);
            return center + (((u * cos) + (v * sin)) * radius);
        });
    }
}
