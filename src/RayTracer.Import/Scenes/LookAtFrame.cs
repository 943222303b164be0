using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>The frame of an eye that looks somewhere.</summary>
internal static class LookAtFrame
{
    /// <summary>Maps (1, 0, 0) to the side up × forward, (0, 1, 0) upwards, (0, 0, 1) forward, and the origin to the eye.</summary>
    /// <param name="eye">Where the eye is.</param>
    /// <param name="forward">The unit vector along which it looks.</param>
    /// <param name="up">What is above, roughly.</param>
    /// <returns>The map; null where forward is not finite, or up points along it.</returns>
    public static Transform? Of(Vector3 eye, Vector3 forward, Vector3 up)
    {
        Vector3 side = up.Cross(forward).Unit();
        if (!forward.IsFinite() || !side.IsFinite())
        {
            return null;
        }

        Vector3 top = forward.Cross(side);
        return new Transform(new(side.X, top.X, forward.X, eye.X), new(side.Y, top.Y, forward.Y, eye.Y), new(side.Z, top.Z, forward.Z, eye.Z));
    }
}
