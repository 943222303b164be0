using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>By all directions around one point.</summary>
internal sealed class SphericalKind() : Projection("spherical")
{
    /// <inheritdoc/>
    public override string LensComplaint => "a spherical camera looks in all directions and cannot have a lens";

    /// <inheritdoc/>
    public override string WindowComplaint => "a spherical camera shows all directions and cannot have a window";

    /// <inheritdoc/>
    public override bool IsStraight => false;

    /// <summary>The quarter of the sphere around the middle, as a pinhole camera would show it.</summary>
    public override float HeightAt(CameraDescription camera, float distance, float aspect) => 2 * distance;

    /// <summary>Returns null: it sees everything.</summary>
    public override CameraDescription? Zoomed(CameraDescription camera, float factor) => null;

    /// <inheritdoc/>
    public override float DegreesOfHeight(CameraDescription camera) => 180;

    /// <inheritdoc/>
    public override CameraProjection Create(in CameraView view) => new SphericalProjection(view);
}

/// <summary>All directions around the eye: longitude grows across the picture, colatitude down its height (equirectangular).</summary>
internal sealed class SphericalProjection(CameraView view) : CameraProjection
{
    private readonly CameraView _view = view;

    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = _view.Camera.Position;

        // Pixel filters reach beyond the edges: over the poles, and around.
        LaneMath.SinCosTurn(FloatW.MultiplyAdd(x, 1f / _view.Width, -0.5f), out FloatW sinLongitude, out FloatW cosLongitude);
        LaneMath.SinCosTurn(y * (0.5f / _view.Height), out FloatW sinColatitude, out FloatW cosColatitude);
        Vec3W level = Vec3W.MultiplyAdd(_view.Forward, cosLongitude, (Vec3W)_view.Right * sinLongitude);
        toFocus = Vec3W.MultiplyAdd(level, sinColatitude, (Vec3W)_view.Up * cosColatitude);
    }
}
