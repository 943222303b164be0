using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// Moves the camera that the picture is seen through. Looking around changes no text; the scene's camera is put there on request, as one
/// step to undo.
/// </summary>
/// <param name="document">The document.</param>
/// <param name="view">Shows it.</param>
public sealed class CameraController(SceneDocument document, PictureView view)
{
    // A plane in focus is as good as exact within this part of its distance.
    private const float FocusPrecision = 1e-3f;

    // What has no size is framed with so much of the scene's around it.
    private const float LightShare = 0.2f;
    private (string? Gesture, Vector3? Pivot) _orbit;

    /// <summary>Moves the camera.</summary>
    /// <exception cref="SessionException">There is nothing to be seen, or it cannot be seen from there.</exception>
    public void Move(CameraMove move)
    {
        ViewportScene shown = view.RequireShown();
        Look(move.Kind == CameraMoveKind.Home ? null : CameraPose.Of(Moved(shown, move)));
    }

    /// <summary>Looks from somewhere else.</summary>
    /// <param name="pose">From where; null for the scene's camera.</param>
    /// <exception cref="SessionException">There is nothing to be seen, or it cannot be seen from there.</exception>
    public void Look(CameraPose? pose)
    {
        if (!view.TryLookFrom(pose))
        {
            throw new SessionException("The camera cannot be there.");
        }
    }

    /// <summary>Puts the scene's camera where the view is.</summary>
    /// <returns>The revision of the text then.</returns>
    /// <exception cref="SessionException">There is nothing to be seen, or the text is no JSON at the moment.</exception>
    public int Write()
    {
        ViewportScene shown = view.RequireShown();
        CameraDescription camera = Precision.Round(shown).On(shown.Camera);
        CameraDescription written = shown.Description.Camera;
        return document.Change("camera", null, text =>
        {
            text = Set(text, "/camera/position", written.Position, camera.Position);
            text = Set(text, "/camera/lookAt", written.LookAt, camera.LookAt);
            text = Set(text, "/camera/up", written.Up, camera.Up);
            text = Set(text, "/camera/fieldOfView", written.FieldOfView, camera.FieldOfView);
            return Set(text, "/camera/viewSize", written.ViewSize, camera.ViewSize);
        }, isByHand: true);
    }

    /// <summary>Focuses the scene's camera on what is seen at a pixel.</summary>
    /// <param name="x">Column.</param>
    /// <param name="y">Row.</param>
    /// <returns>The distance of the plane in focus.</returns>
    /// <exception cref="SessionException">Nothing is seen there, the camera has no lens, or it looks away.</exception>
    /// <exception cref="SessionException">The text is no JSON at the moment.</exception>
    public float Focus(float x, float y)
    {
        ViewportScene shown = view.RequireShown();
        CameraDescription camera = shown.Description.Camera;
        if (camera.Projection.LensComplaint is not null)
        {
            throw new SessionException("This camera has no lens: everything is sharp.");
        }

        Vector3 seen = Picking.At(shown, x, y).Position
            ?? throw new SessionException("There is nothing to focus on: the ray meets nothing.", SessionFault.Missing);
        float exact = (Local(shown).Point(seen) - camera.Position).Dot(CameraMotion.Axes(camera).Forward);
        float distance = Precision.Round(exact, FocusPrecision * exact);
        if (!(distance > 0))
        {
            throw new SessionException("The scene's camera looks away from there: nothing behind it can be in focus.");
        }

        document.Change("focus", null, text => Set(text, "/camera/lens/focusDistance", camera.Lens.FocusDistance, distance));
        return distance;
    }

    private CameraDescription Moved(ViewportScene shown, CameraMove move)
    {
        CameraDescription camera = shown.Camera;
        return move.Kind switch
        {
            CameraMoveKind.Orbit => CameraMotion.Orbit(camera, move.Dx, move.Dy, Pivot(shown, move)),
            CameraMoveKind.Pan => CameraMotion.Pan(camera, move.Dx, move.Dy, shown.Aspect),
            CameraMoveKind.Zoom => CameraMotion.Zoom(camera, move.Dy),
            CameraMoveKind.Dolly => CameraMotion.Dolly(camera, move.Dy),
            CameraMoveKind.Translate => CameraMotion.Translate(camera, move.Dx, move.Dy, move.Dz),
            CameraMoveKind.Rotate => CameraMotion.Rotate(camera, move.Dx, move.Dy),
            CameraMoveKind.Frame => Framed(shown, move.Pointer),
            CameraMoveKind.Along when new Vector3(move.Dx, move.Dy, move.Dz) is var from && from.Norm() > 0 => CameraFraming.Along(camera, Local(shown).Vector(from)),
            CameraMoveKind.Along => throw new SessionException("A direction has a length."),
            _ => camera with
            {
                Position = move.Position ?? camera.Position,
                LookAt = move.LookAt ?? camera.LookAt,
                Up = move.Up ?? camera.Up,
                FieldOfView = move.FieldOfView ?? camera.FieldOfView,
            },
        };
    }

    // What was under the pointer when the gesture began, or the point looked at where there was nothing.
    private Vector3? Pivot(ViewportScene shown, CameraMove move)
    {
        if (move.Around is not { } pixel)
        {
            return move.Gesture is not null && move.Gesture == _orbit.Gesture ? _orbit.Pivot : null;
        }

        if (_orbit.Gesture != move.Gesture || move.Gesture is null)
        {
            _orbit = (move.Gesture, Picking.At(shown, pixel.X, pixel.Y).Position is { } seen ? Local(shown).Point(seen) : null);
        }

        return _orbit.Pivot;
    }

    private static CameraDescription Framed(ViewportScene shown, string? pointer)
    {
        (Vector3 middle, float radius) = shown.Extent;
        if (pointer is not null && Gizmo.Of(shown, pointer) is var box)
        {
            (middle, radius) = (box.Center, box.Radius > 0 ? box.Radius : LightShare * radius);
        }

        Transform local = Local(shown);
        float scale = local.Vector(Vector3.UnitX).Norm();
        return CameraFraming.Frame(shown.Camera, local.Point(middle), MathF.Max(radius * scale, 1e-4f), shown.Aspect);
    }

    /// <summary>From the world to the coordinates in which the camera's numbers are.</summary>
    internal static Transform Local(ViewportScene shown) =>
        TransformEdit.Map(SceneValue.At(shown.Good.Read.Root!, "/camera/transform")).Inverse();

    private static JsonText Set(JsonText text, string pointer, object before, object after) =>
        before.Equals(after) ? text : text.Set(pointer, JsonValues.Of(SceneValue.At(text.Root, pointer)!.Parameter!, after));
}
