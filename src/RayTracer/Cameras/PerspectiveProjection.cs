using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>Rays from the eye through a plane.</summary>
internal sealed class PerspectiveProjection : CameraProjection
{
    private readonly Vector3 _eye;
    private readonly Vector3 _corner;
    private readonly Vector3 _stepX;
    private readonly Vector3 _stepY;

    /// <summary>Makes one.</summary>
    /// <param name="eye">Where the rays start.</param>
    /// <param name="toFocus">From the eye to the middle of the plane in focus.</param>
    /// <param name="right">Unit direction to the right in the picture.</param>
    /// <param name="up">Unit direction upwards in the picture.</param>
    /// <param name="pixel">How much of the plane in focus a pixel shows.</param>
    /// <param name="middleX">From the left edge of the picture to the viewing direction, in pixels.</param>
    /// <param name="middleY">From the top edge.</param>
    public PerspectiveProjection(Vector3 eye, Vector3 toFocus, Vector3 right, Vector3 up, float pixel, float middleX, float middleY)
    {
        _eye = eye;
        _stepX = right * pixel;
        _stepY = up * -pixel;
        _corner = toFocus - _stepX * middleX - _stepY * middleY;
    }

    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = _eye;
        toFocus = Vec3W.MultiplyAdd(_stepX, x, Vec3W.MultiplyAdd(_stepY, y, _corner));
    }
}
