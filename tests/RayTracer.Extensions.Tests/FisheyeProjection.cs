using RayTracer.Cameras;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Extensions.Tests;

/// <summary>A lens that shows angles from the viewing direction as distances from the middle; the field of view is that over the height.</summary>
public sealed class FisheyeProjection() : Projection("fisheye")
{
    /// <inheritdoc/>
    public override bool IsStraight => false;

    /// <inheritdoc/>
    public override float HeightAt(CameraDescription camera, float distance, float aspect) => 2 * distance;

    /// <inheritdoc/>
    public override CameraDescription Zoomed(CameraDescription camera, float factor) => camera with { FieldOfView = float.Min(camera.FieldOfView * factor, 179) };

    /// <inheritdoc/>
    public override CameraProjection Create(in CameraView view) => new Fisheye(view);

    private sealed class Fisheye(CameraView view) : CameraProjection
    {
        private readonly float _turnsPerPixel = view.Camera.FieldOfView / 360 / view.Height;

        public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
        {
            FloatW right = x - (0.5f * view.Width);
            FloatW up = (0.5f * view.Height) - y;
            FloatW distance = FloatW.Max(FloatW.Sqrt((right * right) + (up * up)), 1e-6f);
            LaneMath.SinCosTurn(distance * _turnsPerPixel, out FloatW sin, out FloatW cos);
            Vec3W across = ((Vec3W)view.Right * right) + ((Vec3W)view.Up * up);
            origin = view.Camera.Position;
            toFocus = ((Vec3W)view.Forward * cos) + (across * (sin / distance));
        }
    }
}
