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
internal sealed class SphericalProjection(CameraView view) : InvertibleProjection
{
    // At the poles pixels have no width, and the density no limit.
    private const float SmallestSine = 1e-6f;
    private readonly CameraView _view = view;
    private readonly float _perSteradian = (float)(view.Width * (double)view.Height / (2 * double.Pi * double.Pi));

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
    /// <inheritdoc/>
    public override void Find(in Vec3W point, in Vec3W shift, out FloatW x, out FloatW y)
    {
        Vec3W towards = point - _view.Camera.Position;
        FloatW forward = Vec3W.Dot(towards, _view.Forward);
        FloatW right = Vec3W.Dot(towards, _view.Right);
        FloatW level = FloatW.Sqrt(FloatW.MultiplyAdd(forward, forward, right * right));
        x = FloatW.MultiplyAdd(LaneMath.Atan2(right, forward), _view.Width * (0.5f / float.Pi), 0.5f * _view.Width);
        y = LaneMath.Atan2(level, Vec3W.Dot(towards, _view.Up)) * (_view.Height / float.Pi);
    }

    /// <summary>A pixel covers its extents in longitude and colatitude times the sine of the colatitude, in steradians.</summary>
    public override void Density(in Vec3W origin, in Vec3W direction, in FloatW distance, out FloatW density)
    {
        FloatW forward = Vec3W.Dot(direction, _view.Forward);
        FloatW right = Vec3W.Dot(direction, _view.Right);
        FloatW sine = FloatW.Sqrt(FloatW.MultiplyAdd(forward, forward, right * right));
        density = _perSteradian / (FloatW.Max(sine, SmallestSine) * distance * distance);
    }

    /// <summary>The picture continues beyond a pole on its other side, and beyond the left and right edges at the opposite edge.</summary>
    public override void Fold(ref FloatW x, ref FloatW y)
    {
        float twice = 2f * _view.Height;
        y -= FloatW.Floor(y / twice) * twice;
        MaskW beyond = y > _view.Height;
        y = beyond.Select(twice - y, y);
        x += beyond.Select(0.5f * _view.Width, 0f);
        x -= FloatW.Floor(x / _view.Width) * _view.Width;
    }
}
