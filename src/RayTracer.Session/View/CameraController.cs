using RayTracer.Description;

namespace RayTracer.Session;

/// <summary>Moves the camera of a document: seen at once, and written to the text at the end of the gesture, as one step to undo.</summary>
/// <param name="document">The document.</param>
/// <param name="view">Shows it.</param>
public sealed class CameraController(SceneDocument document, PictureView view)
{
    /// <summary>Moves the camera.</summary>
    /// <exception cref="SessionException">There is nothing to be seen, or it cannot be seen from there.</exception>
    /// <exception cref="SessionException">The text is no JSON at the moment.</exception>
    public void Move(CameraMove move)
    {
        ViewportScene shown = view.RequireShown();
        CameraDescription camera = Moved(shown, move);
        if (!view.TrySetCamera(camera))
        {
            throw new SessionException("The camera cannot be there.");
        }

        if (move.End)
        {
            Write(camera, "camera", move.Gesture);
        }
    }

    /// <summary>Focuses on what is seen at a pixel.</summary>
    /// <param name="x">Column.</param>
    /// <param name="y">Row.</param>
    /// <returns>The distance of the plane in focus.</returns>
    /// <exception cref="SessionException">Nothing is seen there, or the camera has no lens.</exception>
    /// <exception cref="SessionException">The text is no JSON at the moment.</exception>
    public float Focus(float x, float y)
    {
        ViewportScene shown = view.RequireShown();
        if (shown.Camera.Projection.LensComplaint is not null)
        {
            throw new SessionException("This camera has no lens: everything is sharp.");
        }

        float distance = Picking.DepthAt(shown, x, y) ?? throw new SessionException("There is nothing to focus on: the ray meets nothing.", SessionFault.Missing);
        CameraDescription camera = shown.Camera with { Lens = shown.Camera.Lens with { FocusDistance = distance } };
        view.TrySetCamera(camera);
        Write(camera, "focus", null);
        return distance;
    }

    private CameraDescription Moved(ViewportScene shown, CameraMove move)
    {
        CameraDescription camera = shown.Camera;
        return move.Kind switch
        {
            CameraMoveKind.Orbit => CameraMotion.Orbit(camera, move.Dx, move.Dy),
            CameraMoveKind.Pan => CameraMotion.Pan(camera, move.Dx, move.Dy, shown.Aspect),
            CameraMoveKind.Zoom => CameraMotion.Zoom(camera, move.Dy),
            CameraMoveKind.Dolly => CameraMotion.Dolly(camera, move.Dy),
            CameraMoveKind.Translate => CameraMotion.Translate(camera, move.Dx, move.Dy, move.Dz),
            CameraMoveKind.Rotate => CameraMotion.Rotate(camera, move.Dx, move.Dy),
            CameraMoveKind.Home => view.Home ?? camera,
            _ => camera with
            {
                Position = move.Position ?? camera.Position,
                LookAt = move.LookAt ?? camera.LookAt,
                Up = move.Up ?? camera.Up,
                FieldOfView = move.FieldOfView ?? camera.FieldOfView,
            },
        };
    }

    // Only what differs from the text is written.
    private void Write(CameraDescription camera, string label, string? gesture)
    {
        CameraDescription written = document.Read.Description?.Camera ?? new();
        int revision = document.Change(label, gesture, text =>
        {
            text = Set(text, "/camera/position", written.Position, camera.Position);
            text = Set(text, "/camera/lookAt", written.LookAt, camera.LookAt);
            text = Set(text, "/camera/up", written.Up, camera.Up);
            text = Set(text, "/camera/fieldOfView", written.FieldOfView, camera.FieldOfView);
            text = Set(text, "/camera/viewSize", written.ViewSize, camera.ViewSize);
            return Set(text, "/camera/lens/focusDistance", written.Lens.FocusDistance, camera.Lens.FocusDistance);
        });
        view.Release(revision);
    }

    private static JsonText Set(JsonText text, string pointer, object before, object after) =>
        before.Equals(after) ? text : text.Set(pointer, JsonValues.Of(SceneValue.At(text.Root, pointer)!.Parameter!, after));
}
