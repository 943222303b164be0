using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>The change in the world that a drag of a handle makes.</summary>
/// <param name="camera">The projection of the camera.</param>
/// <param name="center">The middle of the thing.</param>
internal sealed class GizmoDrag(CameraFrame camera, Vector3 center)
{
    /// <summary>The axes of the world.</summary>
    public static IReadOnlyList<Vector3> Axes { get; } = [Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ];

    /// <summary>The change between two points of the picture.</summary>
    /// <param name="kind">The kind of the handle.</param>
    /// <param name="axis">0 to 2 for a handle along or about an axis of the world; null for the one in the middle.</param>
    /// <param name="from">The first point, in pixels.</param>
    /// <param name="to">The second point.</param>
    /// <returns>The change; null where it is undefined, because the axis points at the eye, say.</returns>
    public Placement? Between(GizmoKind kind, int? axis, Vector2 from, Vector2 to) =>
        axis is { } i ? Along(kind, Axes[i], from, to) : Freely(kind, from, to);

    /// <summary>A way with as many digits as make a difference of a part of a pixel.</summary>
    public Vector3 Rounded(Vector3 way) => Precision.Round(way, camera.LengthOf(Precision.PixelShare, center));

    private Placement? Freely(GizmoKind kind, Vector2 from, Vector2 to)
    {
        if (kind != GizmoKind.Scale)
        {
            return OnPlane(from, camera.Forward) is { } a && OnPlane(to, camera.Forward) is { } b ? new(Translate: b - a) : null;
        }

        if (camera.Project(center) is not { } middle)
        {
            return null;
        }

        float factor = Away(to, middle) / Away(from, middle);
        return new(Scale: new(factor));
    }

    // To the right and upwards is larger, as far as some pixels to the other side of the middle.
    private static float Away(Vector2 point, Vector2 middle) => MathF.Max(8, 60 + (point.X - middle.X) - (point.Y - middle.Y));

    private Placement? Along(GizmoKind kind, Vector3 axis, Vector2 from, Vector2 to)
    {
        if (kind == GizmoKind.Rotate)
        {
            return OnPlane(from, axis) is { } p && OnPlane(to, axis) is { } q ? new(Rotate: new(axis, Degrees(axis, p - center, q - center), center)) : null;
        }

        if (AlongAxis(from, axis) is not { } a || AlongAxis(to, axis) is not { } b)
        {
            return null;
        }

        return kind == GizmoKind.Move ? new(Translate: axis * (b - a))
            : a * b > 0 ? new(Scale: Vector3.One + (axis * ((b / a) - 1))) : null;
    }

    private static float Degrees(Vector3 axis, Vector3 from, Vector3 to) =>
        LaneMath.Atan2(axis.Dot(from.Cross(to)), from.Dot(to)) * (180 / float.Pi);

    // The place along an axis through the middle that is nearest to a pixel's ray.
    private float? AlongAxis(Vector2 pixel, Vector3 axis)
    {
        Vector3 direction = camera.Through(pixel);
        Vector3 between = center - camera.Position;
        float cosine = axis.Dot(direction);
        float determinant = 1 - (cosine * cosine);
        return determinant < 1e-4f ? null : ((cosine * between.Dot(direction)) - between.Dot(axis)) / determinant;
    }

    // Where a pixel's ray meets the plane through the middle.
    private Vector3? OnPlane(Vector2 pixel, Vector3 normal)
    {
        Vector3 direction = camera.Through(pixel);
        float slope = direction.Dot(normal);
        if (MathF.Abs(slope) < 1e-3f)
        {
            return null;
        }

        float distance = (center - camera.Position).Dot(normal) / slope;
        return distance > 0 ? camera.Position + (direction * distance) : null;
    }
}
