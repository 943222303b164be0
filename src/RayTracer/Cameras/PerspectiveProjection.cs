using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>By rays through one point.</summary>
internal sealed class PerspectiveKind() : Projection("perspective")
{
    private const float NarrowestDegrees = 0.1f;
    private const float WidestDegrees = 170;

    /// <inheritdoc/>
    public override float HeightAt(CameraDescription camera, float distance, float aspect) => Shown(camera, distance) / ViewPlane.Extent(camera.FieldOfViewAxis, aspect, 1);

    /// <inheritdoc/>
    public override CameraDescription Zoomed(CameraDescription camera, float factor)
    {
        float degrees = LaneMath.Atan2(LaneMath.Tan(camera.FieldOfView * (float.Pi / 360)) * factor, 1) * (360 / float.Pi);
        return camera with { FieldOfView = float.Clamp(degrees, NarrowestDegrees, WidestDegrees) };
    }

    /// <inheritdoc/>
    public override CameraProjection Create(in CameraView view) => new PerspectiveProjection(view, Shown(view.Camera, view.Focus));

    // Of a plane at a distance, over the extent that the field of view measures.
    private static float Shown(CameraDescription camera, float distance) => 2 * distance * LaneMath.Tan(camera.FieldOfView * (float.Pi / 360));
}

/// <summary>Rays from the eye through a plane.</summary>
internal sealed class PerspectiveProjection : CameraProjection
{
    private readonly Vector3 _eye;
    private readonly Vector3 _corner;
    private readonly Vector3 _stepX;
    private readonly Vector3 _stepY;

    /// <summary>Makes one.</summary>
    /// <param name="view">The camera.</param>
    /// <param name="shown">How much of the plane in focus it shows over the extent that the field of view measures.</param>
    public PerspectiveProjection(in CameraView view, float shown)
    {
        _eye = view.Camera.Position;
        (_corner, _stepX, _stepY) = view.OnPlane(view.Forward * view.Focus, shown);
    }

    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = _eye;
        toFocus = Vec3W.MultiplyAdd(_stepX, x, Vec3W.MultiplyAdd(_stepY, y, _corner));
    }
}
