using System.Numerics;

namespace RayTracer.Session;

/// <summary>Moves, turns and scales things by their handles, as the pointer drags these over the picture.</summary>
/// <param name="edits">Changes the things.</param>
/// <param name="view">Shows them.</param>
public sealed class HandleDrags(SceneEdits edits, PictureView view)
{
    private readonly Lock _lock = new();
    private (string Gesture, GizmoDrag Drag, Vector2 Reached, Vector3 Moved)? _current;

    /// <summary>Has the thing follow the pointer. What cannot be computed (the axis points at the eye, say) changes nothing.</summary>
    /// <exception cref="SessionException">There is no thing of a size, or nothing can be drawn over the picture.</exception>
    /// <exception cref="SessionException">The thing cannot be there, or is locked.</exception>
    public void Drag(HandleDrag way)
    {
        if (way.Axis is < 0 or > 2)
        {
            throw new SessionException("An axis is 0, 1 or 2.");
        }

        lock (_lock)
        {
            (_, GizmoDrag drag, Vector2 reached, Vector3 moved) = _current is { } current && current.Gesture == way.Gesture ? current : Begin(way);
            if (drag.Between(way.Kind, way.Axis, reached, way.To) is { } change)
            {
                // Moves are measured from where they began: what is rounded off a short one is not lost to the next.
                if (change.Translate is { } all)
                {
                    all = drag.Rounded(all);
                    (change, moved) = (new(Translate: all - moved), all);
                }
                else
                {
                    reached = way.To;
                }

                edits.Place(way.Pointer, change, way.Gesture);
            }

            _current = (way.Gesture, drag, reached, moved);
        }
    }

    private (string, GizmoDrag, Vector2, Vector3) Begin(HandleDrag way)
    {
        ViewportScene shown = view.RequireShown();
        return (way.Gesture, new(CameraFrame.Of(shown), Gizmo.Of(shown, way.Pointer).Center), way.From, default);
    }
}

/// <summary>The drag of a handle.</summary>
/// <param name="Pointer">The thing.</param>
/// <param name="Kind">The kind of the handle.</param>
/// <param name="Axis">0 to 2 for a handle along or about an axis of the world; null for the one in the middle.</param>
/// <param name="From">The point of the picture where the gesture began, in pixels.</param>
/// <param name="To">The point where the pointer is now, in pixels.</param>
/// <param name="Gesture">The gesture: all that it changes is one step to undo.</param>
public sealed record HandleDrag(string Pointer, GizmoKind Kind, int? Axis, Vector2 From, Vector2 To, string Gesture);
