using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>The actions of the handles around a thing.</summary>
public enum GizmoKind
{
    /// <summary>Move it.</summary>
    Move,

    /// <summary>Turn it.</summary>
    Rotate,

    /// <summary>Change its size.</summary>
    Scale,
}

/// <summary>The box around a thing, around which handles are drawn.</summary>
/// <param name="Center">The middle of the box around it.</param>
/// <param name="Radius">Half the box's diagonal.</param>
/// <param name="Minimum">The box's smallest coordinates.</param>
/// <param name="Maximum">Its largest coordinates.</param>
public sealed record Gizmo(Vector3 Center, float Radius, Vector3 Minimum, Vector3 Maximum)
{
    /// <summary>Returns whether it is a light that no ray meets.</summary>
    internal bool IsLight { get; init; }

    /// <summary>Returns whether such a light can be moved.</summary>
    internal bool HasPlace { get; init; }

    /// <summary>Returns whether such a light can be turned.</summary>
    internal bool HasDirection { get; init; }

    /// <summary>Finds a thing.</summary>
    /// <param name="shown">The scene.</param>
    /// <param name="pointer">The thing.</param>
    /// <exception cref="SessionException">It is nothing that can be seen, or it has no end.</exception>
    public static Gizmo Of(ViewportScene shown, string pointer) =>
        Find(shown, pointer) ?? throw new SessionException("There is nothing there with a size.", SessionFault.Missing);

    /// <summary>As <see cref="Of"/>, but null for what is nothing that can be seen, as while the text of what was added is not valid.</summary>
    /// <param name="shown">The scene.</param>
    /// <param name="pointer">The thing.</param>
    public static Gizmo? Find(ViewportScene shown, string pointer)
    {
        // What no ray meets has a place, but no size.
        JsonText text = JsonText.Of(shown.Good.Read);
        if (SceneValue.At(text.Root, pointer) is { Node: not null, Type.IsLight: true } light && LightPose.Of(text, light, shown) is { } pose)
        {
            Vector3 place = pose.Position ?? shown.Camera.LookAt;
            return new(place, 0, place, place) { IsLight = true, HasPlace = pose.Position is not null, HasDirection = pose.Direction is not null };
        }

        Bounds all = Bounds.Empty;
        foreach (PlacedSurface surface in shown.Scene.Surfaces().Where(s => Picking.IsWithin(shown.PointerOf(s.Source), pointer)))
        {
            all = all.Union(surface.Bounds);
        }

        // What has no end has a middle all the same.
        if (!all.IsFinite && all.Minimum.X <= all.Maximum.X && SceneThings.IsSeen(pointer))
        {
            Vector3 middle = ShapePlacement.Middle(text, pointer);
            return new(middle, 0, middle, middle);
        }

        return all.IsFinite ? new((all.Minimum + all.Maximum) * 0.5f, ((all.Maximum - all.Minimum) * 0.5f).Norm(), all.Minimum, all.Maximum) : null;
    }

    /// <summary>The handles, as they are drawn over the picture.</summary>
    /// <param name="camera">The picture's camera.</param>
    /// <param name="kind">The kind of the handles.</param>
    /// <param name="length">Their length, or the radius of rings, in pixels.</param>
    public GizmoHandles Handles(CameraFrame camera, GizmoKind kind, float length)
    {
        float size = camera.LengthOf(length, Center);
        if (IsLight && !(kind == GizmoKind.Move ? HasPlace : kind == GizmoKind.Rotate && HasDirection))
        {
            return new(kind, Center, null, []);
        }

        List<GizmoHandle> handles = [];
        for (int axis = 0; axis < GizmoDrag.Axes.Count; axis++)
        {
            Vector3 along = GizmoDrag.Axes[axis];
            (Vector3 u, Vector3 v) = WireLines.Across(along);
            Vector3[] line = kind == GizmoKind.Rotate ? WireLines.Circle(Center, u, v, size) : [Center, Center + (along * size)];
            Vector2[] points = [.. line.Select(camera.Project).OfType<Vector2>()];
            if (points.Length > 1)
            {
                handles.Add(new(axis, points));
            }
        }

        return new(kind, Center, camera.Project(Center), handles);
    }
}

/// <summary>The handles around a thing.</summary>
/// <param name="Kind">The kind of the handles.</param>
/// <param name="Middle">The middle of the thing in the world.</param>
/// <param name="Center">The same in the picture, in pixels; null behind the eye.</param>
/// <param name="Handles">Those along or about the axes of the world, as far as they are seen.</param>
public sealed record GizmoHandles(GizmoKind Kind, Vector3 Middle, Vector2? Center, IReadOnlyList<GizmoHandle> Handles);

/// <summary>A handle along or about an axis.</summary>
/// <param name="Axis">0 to 2.</param>
/// <param name="Points">Its line in the picture, in pixels.</param>
public sealed record GizmoHandle(int Axis, IReadOnlyList<Vector2> Points);
