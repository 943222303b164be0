using System.Numerics;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Handles around the selected shape, that move, turn and scale it.</summary>
/// <param name="dispatcher">Carries changes to the session.</param>
internal sealed class GizmoViewModel(SessionDispatcher dispatcher) : Observable
{
    private const double Reach = 10;
    private const double HandleLength = 72;
    private static readonly string[] Colors = ["#d0493a", "#3c9a4e", "#3b72c4"];
    private static readonly string[] Names = ["move", "rotate", "scale"];
    private (Gizmo Gizmo, CameraFrame Camera, GizmoKind Kind, string Pointer)? _target;
    private (int? Axis, Spot From, string Gesture)? _drag;

    /// <summary>The handles.</summary>
    public IReadOnlyList<HandleViewModel> Handles { get; private set; } = [];

    /// <summary>Finds the selected shape, and shows its handles.</summary>
    /// <param name="pointer">The shape; null for none.</param>
    /// <param name="kind">The kind of the handles; null for none.</param>
    /// <param name="stage">The place of the picture.</param>
    public async Task Follow(string? pointer, GizmoKind? kind, Stage stage)
    {
        _target = kind is { } k && pointer is not null && SceneThings.IsSeen(pointer) ? await dispatcher.Ask(s => Find(s, pointer, k)) : null;
        Place(stage);
    }

    /// <summary>Shows the handles where the picture lies now.</summary>
    public void Place(Stage stage)
    {
        Handles = _target is not { } target ? [] : Drawn(target.Gizmo, target.Camera, target.Kind, stage);
        OnPropertyChanged(nameof(Handles));
    }

    /// <summary>Takes the handle under a point of the screen; false where there is none.</summary>
    public bool Grab(Spot screen, Spot picture)
    {
        HandleViewModel? near = Handles.Where(h => h.DistanceTo(screen) < Reach).OrderBy(h => h.Axis is null ? 0 : h.DistanceTo(screen)).FirstOrDefault();
        _drag = near is null ? null : (near.Axis, picture, Gesture.New());
        return _drag is not null;
    }

    /// <summary>Drags the handle to a point of the picture.</summary>
    public void Drag(Spot picture)
    {
        if (_drag is { } drag && _target is { } target)
        {
            HandleDrag way = new(target.Pointer, target.Kind, drag.Axis, drag.From.AsVector(), picture.AsVector(), drag.Gesture);
            dispatcher.Do(s => s.Handles.Drag(way));
        }
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
        GizmoHandles seen = gizmo.Handles(camera, kind, (float)(HandleLength / stage.Scale));
        Spot OnScreen(Vector2 pixel) => stage.ToScreen(new Spot(pixel.X, pixel.Y));
        List<HandleViewModel> handles = [];
        if (seen.Center is { } center && kind != GizmoKind.Rotate)
        {
            Spot m = OnScreen(center);
            string free = SessionTexts.Of(kind == GizmoKind.Move ? "viewport.free" : "viewport.all");
            handles.Add(new(null, [new(m.X - 5, m.Y), new(m.X + 5, m.Y), new(m.X, m.Y - 5), new(m.X, m.Y + 5)], "#888888", free));
        }

        foreach ((int axis, IReadOnlyList<Vector2> points) in seen.Handles)
        {
            string name = $"{SessionTexts.Of($"viewport.{Names[(int)kind]}")} {SessionTexts.Of($"panel.axes.{axis}")}";
            handles.Add(new(axis, [.. points.Select(OnScreen)], Colors[axis], name));
        }

        return handles;
    }
}

/// <summary>A handle of the selected shape: a line along an axis, or a ring about it.</summary>
/// <param name="Axis">0 to 2; null for the one in the middle.</param>
/// <param name="Points">Its line on the screen.</param>
/// <param name="Color">Its colour as #rrggbb.</param>
/// <param name="Name">Its name for screen readers.</param>
internal sealed record HandleViewModel(int? Axis, IReadOnlyList<Spot> Points, string Color, string Name)
{
    /// <summary>The distance of a point of the screen from it.</summary>
    public double DistanceTo(Spot point) =>
        Points.Zip(Points.Skip(1)).Select(s => Distance(point, s.First, s.Second)).DefaultIfEmpty(double.PositiveInfinity).Min();

    private static double Distance(Spot point, Spot a, Spot b)
    {
        (double dx, double dy) = (b.X - a.X, b.Y - a.Y);
        double length = (dx * dx) + (dy * dy);
        double t = length > 0 ? Math.Clamp((((point.X - a.X) * dx) + ((point.Y - a.Y) * dy)) / length, 0, 1) : 0;
        return point.DistanceTo(new(a.X + (t * dx), a.Y + (t * dy)));
    }
}
