using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>Puts cameras where something is seen well. Points and directions are in the camera's local coordinates.</summary>
public static class CameraFraming
{
    // The part of the picture, across its smaller side, that a framed thing takes.
    private const float Share = 0.8f;

    // Straight down or up, right and left have no meaning: so much beside it.
    private const float DegreesBesidePole = 0.05f;

    /// <summary>Moves a camera along its view until a ball fills the picture.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="middle">The ball's middle.</param>
    /// <param name="radius">Its radius.</param>
    /// <param name="aspect">Width of the picture over its height.</param>
    public static CameraDescription Frame(CameraDescription camera, Vector3 middle, float radius, float aspect)
    {
        (_, _, Vector3 forward) = CameraMotion.Axes(camera);
        float half = CameraMotion.HeightAt(camera, 1, aspect) / 2 * MathF.Min(1, aspect);
        if (camera.Projection.IsParallel)
        {
            float away = MathF.Max((camera.LookAt - camera.Position).Norm(), 2 * radius);
            CameraDescription moved = camera with { Position = middle - (forward * away), LookAt = middle };
            return camera.Projection.Zoomed(moved, radius / (Share * half)) ?? moved;
        }

        // The ball touches the cone of rays whose tangent is the half height at a distance of one.
        float distance = MathF.Max(radius * MathF.Sqrt(1 + (1 / (half * half))) / Share, 1.01f * radius);
        return camera with { Position = middle - (forward * distance), LookAt = middle };
    }

    /// <summary>Looks at the same point, from the same distance, but along a direction.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="from">The direction from the point to the eye.</param>
    public static CameraDescription Along(CameraDescription camera, Vector3 from)
    {
        Vector3 arm = camera.Position - camera.LookAt;
        (Vector3 towards, Vector3 up) = (from.Unit(), camera.Up.Unit());
        if (towards.Cross(up).Norm() < 1e-3f)
        {
            Vector3 level = arm - (up * arm.Dot(up));
            level = level.Norm() > 1e-6f * arm.Norm() ? level : CameraMotion.Axes(camera).Up;
            towards = Transform.Rotation(towards.Cross(level).Unit(), DegreesBesidePole).Vector(towards).Unit();
        }

        return camera with { Position = camera.LookAt + (towards * arm.Norm()) };
    }
}
