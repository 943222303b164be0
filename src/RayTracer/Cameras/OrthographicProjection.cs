using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>Parallel rays, from a plane through the eye across the viewing direction.</summary>
internal sealed class OrthographicProjection : CameraProjection
{
    private readonly Vector3 _toFocus;
    private readonly Vector3 _corner;
    private readonly Vector3 _stepX;
    private readonly Vector3 _stepY;

    /// <summary>Makes one.</summary>
    /// <param name="eye">Where the ray through the middle of the picture starts.</param>
    /// <param name="toFocus">From there to the plane in focus.</param>
    /// <param name="right">Unit direction to the right in the picture.</param>
    /// <param name="up">Unit direction upwards in the picture.</param>
    /// <param name="pixel">How much a pixel shows, in scene units.</param>
    /// <param name="middleX">From the left edge of the picture to the viewing direction, in pixels.</param>
    /// <param name="middleY">From the top edge.</param>
    public OrthographicProjection(Vector3 eye, Vector3 toFocus, Vector3 right, Vector3 up, float pixel, float middleX, float middleY)
    {
        _toFocus = toFocus;
        _stepX = right * pixel;
        _stepY = up * -pixel;
        _corner = eye - _stepX * middleX - _stepY * middleY;
    }

    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = Vec3W.MultiplyAdd(_stepX, x, Vec3W.MultiplyAdd(_stepY, y, _corner));
        toFocus = _toFocus;
    }
}
