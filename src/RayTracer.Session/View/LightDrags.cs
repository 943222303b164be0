using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Turns, widens and enlarges lights by their handles, as the pointer drags these over the picture.</summary>
/// <param name="document">The document.</param>
/// <param name="view">Shows it.</param>
public sealed class LightDrags(SceneDocument document, PictureView view)
{
    private const float DegreesPrecision = 0.05f;
    private const float DirectionPrecision = 5e-4f;

    /// <summary>Has the handle follow the pointer. What cannot be computed changes nothing.</summary>
    /// <exception cref="SessionException">There is no light with such a handle, it is locked, or nothing can be drawn over the picture.</exception>
    public void Drag(LightDrag drag)
    {
        if (document.IsLocked(drag.Pointer))
        {
            throw new SessionException("It is locked: unlock it to change it by its handles.");
        }

        ViewportScene shown = view.RequireShown();
        CameraFrame camera = CameraFrame.Of(shown);
        document.Change(SessionTexts.Of("viewport.lightHandles." + drag.Kind.ToString().ToLowerInvariant()), drag.Gesture, text =>
        {
            LightPose pose = SceneValue.At(text.Root, drag.Pointer) is { } value && LightBody.IsBodied(value) && LightPose.Of(text, value) is { } found ? found : throw Missing();
            return drag.Kind switch
            {
                LightHandleKind.Direction when pose.Direction is not null => Turned(text, pose, shown, camera, drag.To),
                LightHandleKind.Cone when pose.Cone is not null => Widened(text, pose, "cutoffAngle", camera, drag.To),
                LightHandleKind.Beam when pose.Beam is not null => Widened(text, pose, "beamWidth", camera, drag.To),
                LightHandleKind.Radius when pose.Radius is not null => Enlarged(text, pose, camera, drag.To),
                _ => throw Missing(),
            };
        }, isByHand: true);
    }

    /// <summary>Has a light shine on a point: one with a direction is turned to it, others come to stand as far before it as they are.</summary>
    /// <param name="text">The text.</param>
    /// <param name="pointer">The light.</param>
    /// <param name="on">The point, and the unit normal of the surface there.</param>
    /// <exception cref="SessionException">It is no light that can be turned or moved.</exception>
    internal static JsonText ShineOn(JsonText text, string pointer, (Vector3 Point, Vector3 Normal) on)
    {
        LightPose pose = SceneValue.At(text.Root, pointer) is { Node: not null, Type: not null } light && light.Family == SceneTypes.Shapes ? LightPose.Of(text, light)! : throw Missing();
        Vector3 way = on.Point - (pose.Position ?? (on.Point + on.Normal));
        return pose.Direction is not null && way.Norm() > 0 ? Directed(text, pose, way.Unit())
            : ShapePlacement.Translate(text, pointer, Precision.Round(way + (on.Normal * way.Norm()), DirectionPrecision * way.Norm()));
    }

    private static SessionException Missing() => new("There is no light with such a handle.", SessionFault.Missing);

    private static JsonText Turned(JsonText text, LightPose pose, ViewportScene shown, CameraFrame camera, Vector2 to)
    {
        Vector3 along = pose.Position is { } position ? Aimed(position, pose, shown, camera, to) - position : camera.LookAt - OnBall(pose, camera, to);
        if (!(along.Norm() > 0) || !along.IsFinite())
        {
            return text;
        }

        along = along.Unit();
        if (pose.Kind == "sun")
        {
            float elevation = LaneMath.Atan2(-along.Y, MathF.Sqrt((along.X * along.X) + (along.Z * along.Z))) * (180 / float.Pi);
            float azimuth = LaneMath.Atan2(-along.X, along.Z) * (180 / float.Pi);
            return Set(Set(text, pose, "sunElevation", float.Clamp(elevation, 0, 90), DegreesPrecision), pose, "sunAzimuth", azimuth < 0 ? azimuth + 360 : azimuth, DegreesPrecision);
        }

        return Directed(text, pose, along);
    }

    private static JsonText Directed(JsonText text, LightPose pose, Vector3 along) =>
        text.Set(pose.Pointer + "/direction", JsonValues.Vector(Precision.Round(pose.Space.Inverse().Vector(along).Unit(), DirectionPrecision)));

    // What is seen under the pointer, or the point there as far from the light as its arrow's tip.
    private static Vector3 Aimed(Vector3 position, LightPose pose, ViewportScene shown, CameraFrame camera, Vector2 to)
    {
        bool isInside = to.X >= 0 && to.Y >= 0 && to.X < camera.Width && to.Y < camera.Height;
        return isInside && Picking.At(shown, to.X, to.Y).Position is { } seen && (seen - position).Norm() > 1e-4f * LightBody.Reach(camera, position)
            ? seen : OnPlane(camera, to, position + (pose.Direction!.Value * LightBody.Reach(camera, position))) ?? position;
    }

    // The point under the pointer on the ball around the middle of the view, on the side on which the light is.
    private static Vector3 OnBall(LightPose pose, CameraFrame camera, Vector2 to)
    {
        float radius = LightBody.Reach(camera, camera.LookAt);
        Vector3 ray = camera.Through(to);
        Vector3 nearest = camera.Position + (ray * (camera.LookAt - camera.Position).Dot(ray)) - camera.LookAt;
        float depth = (radius * radius) - nearest.Dot(nearest);
        bool isBehind = pose.Direction!.Value.Dot(camera.Forward) < 0;
        return camera.LookAt + (depth > 0 ? nearest + (ray * (isBehind ? MathF.Sqrt(depth) : -MathF.Sqrt(depth))) : nearest.Unit() * radius);
    }

    private static JsonText Widened(JsonText text, LightPose pose, string key, CameraFrame camera, Vector2 to)
    {
        Vector3 foot = pose.Position!.Value;
        Vector3 along = pose.Direction!.Value;
        LaneMath.SinCosTurn((key == "beamWidth" ? pose.Beam!.Value : pose.Cone!.Value) / 360, out _, out float cosine);
        if (OnPlane(camera, to, foot + (along * (cosine * LightBody.Reach(camera, foot)))) is not { } point)
        {
            return text;
        }

        Vector3 arm = point - foot;
        float degrees = LaneMath.Atan2(arm.Cross(along).Norm(), arm.Dot(along)) * (180 / float.Pi);
        if (key == "beamWidth")
        {
            return Set(text, pose, key, float.Clamp(degrees, 0, pose.Cone!.Value), DegreesPrecision);
        }

        bool isBeamWritten = SceneValue.At(text.Root, pose.Pointer + "/beamWidth")?.Node is not null;
        float cone = float.Clamp(degrees, 0.5f, 180);
        text = Set(text, pose, key, cone, DegreesPrecision);
        return isBeamWritten && pose.Beam > cone ? Set(text, pose, "beamWidth", cone, DegreesPrecision) : text;
    }

    private static JsonText Enlarged(JsonText text, LightPose pose, CameraFrame camera, Vector2 to)
    {
        Vector3 middle = pose.Position!.Value;
        if (OnPlane(camera, to, middle) is not { } point || !((point - middle).Norm() > 0))
        {
            return text;
        }

        float scale = pose.Space.Vector(Vector3.UnitX).Norm();
        return Set(text, pose, "radius", (point - middle).Norm() / scale, camera.LengthOf(0.25f, middle) / scale);
    }

    private static JsonText Set(JsonText text, LightPose pose, string key, float value, float within) =>
        text.Set(JsonPointer.Append(pose.Pointer, key), JsonValue.Create(Precision.Round(value, within)));

    // Where the pointer is on the plane across the view through a point.
    private static Vector3? OnPlane(CameraFrame camera, Vector2 to, Vector3 point)
    {
        Vector3 ray = camera.Through(to);
        float distance = (point - camera.Position).Dot(camera.Forward) / ray.Dot(camera.Forward);
        return distance > 0 && float.IsFinite(distance) ? camera.Position + (ray * distance) : null;
    }
}

/// <summary>The drag of a light's handle.</summary>
/// <param name="Pointer">The light.</param>
/// <param name="Kind">The handle.</param>
/// <param name="To">The point of the picture where the pointer is now, in pixels.</param>
/// <param name="Gesture">The gesture: all that it changes is one step to undo.</param>
public sealed record LightDrag(string Pointer, LightHandleKind Kind, Vector2 To, string Gesture);
