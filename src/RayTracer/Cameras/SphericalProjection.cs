using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>All directions around the eye: longitude grows across the picture, colatitude down its height (equirectangular).</summary>
/// <param name="eye">Where the rays start.</param>
/// <param name="forward">Unit direction of the middle of the picture.</param>
/// <param name="right">Unit direction of three quarters of the width, at half the height.</param>
/// <param name="up">Unit direction of the top row.</param>
/// <param name="width">Width of the picture in pixels.</param>
/// <param name="height">Height of the picture in pixels.</param>
internal sealed class SphericalProjection(Vector3 eye, Vector3 forward, Vector3 right, Vector3 up, int width, int height) : CameraProjection
{
    /// <inheritdoc/>
    public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus)
    {
        origin = eye;

        // Pixel filters reach beyond the edges: over the poles, and around.
        LaneMath.SinCosTurn(FloatW.MultiplyAdd(x, 1f / width, -0.5f), out FloatW sinLongitude, out FloatW cosLongitude);
        LaneMath.SinCosTurn(y * (0.5f / height), out FloatW sinColatitude, out FloatW cosColatitude);
        Vec3W level = Vec3W.MultiplyAdd(forward, cosLongitude, (Vec3W)right * sinLongitude);
        toFocus = Vec3W.MultiplyAdd(level, sinColatitude, (Vec3W)up * cosColatitude);
    }
}
