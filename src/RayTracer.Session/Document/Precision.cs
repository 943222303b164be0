using System.Globalization;
using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>Rounds what a hand has set to as many digits as make a difference.</summary>
public static class Precision
{
    private const int MostDecimals = 9;

    /// <summary>The part of a pixel that nobody sees.</summary>
    internal const float PixelShare = 0.05f;

    /// <summary>The number with the fewest decimals that differs by no more than a bound.</summary>
    /// <param name="value">The number.</param>
    /// <param name="within">The bound; where it is no positive number, nothing is rounded.</param>
    public static float Round(float value, float within)
    {
        if (!(within > 0) || !float.IsFinite(value))
        {
            return value;
        }

        for (int decimals = 0; decimals <= MostDecimals; decimals++)
        {
            float round = float.Parse(value.ToString("F" + decimals, CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
            if (MathF.Abs(round - value) <= within)
            {
                return round + 0f;
            }
        }

        return value;
    }

    /// <summary>Rounds each coordinate.</summary>
    public static Vector3 Round(Vector3 value, float within) => new(Round(value.X, within), Round(value.Y, within), Round(value.Z, within));

    /// <summary>A camera's pose, so that nothing moves by more than a small part of a pixel.</summary>
    /// <param name="shown">The picture through the camera.</param>
    public static CameraPose Round(ViewportScene shown)
    {
        CameraPose pose = CameraPose.Of(shown.Camera);
        float pixels = shown.Scene.Render.Height / PixelShare;
        float length = CameraMotion.HeightAt(shown.Camera, (pose.LookAt - pose.Position).Norm(), shown.Aspect) / pixels;
        return new(
            Round(pose.Position, length), Round(pose.LookAt, length), Round(pose.Up, 1e-4f),
            Round(pose.FieldOfView, pose.FieldOfView / pixels), Round(pose.ViewSize, pose.ViewSize / pixels));
    }
}
