using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>By parallel rays.</summary>
internal sealed class OrthographicKind() : Projection("orthographic")
{
    /// <inheritdoc/>
    public override bool IsParallel => true;

    /// <inheritdoc/>
    public override float HeightAt(CameraDescription camera, float distance, float aspect) => camera.ViewSize / ViewPlane.Extent(camera.FieldOfViewAxis, aspect, 1);

    /// <inheritdoc/>
    public override CameraDescription Zoomed(CameraDescription camera, float factor) => camera with { ViewSize = camera.ViewSize * factor };

    /// <inheritdoc/>
    public override CameraProjection Create(in CameraView view) => new OrthographicProjection(view);
}

/// <summary>Parallel rays, from a plane through the eye across the viewing direction.</summary>
internal sealed class OrthographicProjection : CameraProjection
{
    private readonly Vector3 _toFocus;
    private readonly Vector3 _corner;
    private readonly Vector3 _stepX;
    private readonly Vector3 _stepY;

    /// <summary>Makes one.</summary>
    public OrthographicProjection(in CameraView view)
    {
        _toFocus = view.Forward * view.Focus;
        (_corner, _stepX, _stepY) = view.OnPlane(view.Camera.Position, view.Camera.ViewSize);
    }

    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = Vec3W.MultiplyAdd(_stepX, x, Vec3W.MultiplyAdd(_stepY, y, _corner));
        toFocus = _toFocus;
    }
}
