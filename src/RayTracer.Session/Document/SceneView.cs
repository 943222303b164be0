using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>What the camera of a scene's text looks at: where new things are put, and how large they are.</summary>
/// <param name="Target">The point in the middle of the picture.</param>
/// <param name="Right">Unit vector to the right in the picture.</param>
/// <param name="Up">Unit vector upwards in the picture.</param>
/// <param name="Towards">Unit vector from the target to the camera.</param>
/// <param name="Size">A length that is well seen: about an eighth of the picture's height.</param>
internal sealed record SceneView(Vector3 Target, Vector3 Right, Vector3 Up, Vector3 Towards, float Size)
{
    /// <summary>The view of a text's camera.</summary>
    public static SceneView Of(JsonNode root)
    {
        SceneValue camera = SceneValue.Scene(root).Child("camera")!;
        Vector3 position = camera.Vector("position");
        Vector3 target = camera.Vector("lookAt");
        Vector3 back = position - target;
        float distance = back.Norm();
        if (!(distance > 0) || !float.IsFinite(distance))
        {
            return new(target, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, 1);
        }

        Vector3 towards = back * (1 / distance);
        Vector3 right = camera.Vector("up").Cross(towards).Unit();
        right = right.IsFinite() ? right : Vector3.UnitX;
        return new(target, right, towards.Cross(right), towards, Round(HeightAt(camera, distance) / 8));
    }

    // How much a picture shows over its height at a distance.
    private static float HeightAt(SceneValue camera, float distance)
    {
        if (camera.Child("projection")?.Node is { Kind: JsonKind.String, Text: "orthographic" })
        {
            return camera.Number("viewSize");
        }

        LaneMath.SinCosTurn(Math.Clamp(camera.Number("fieldOfView"), 0.001f, 170) / 720, out float sin, out float cos);
        return 2 * distance * sin / cos;
    }

    // To one digit, so that new things have round numbers.
    private static float Round(float size)
    {
        float round = float.Parse(size.ToString("E0", System.Globalization.CultureInfo.InvariantCulture), System.Globalization.CultureInfo.InvariantCulture);
        return round > 0 && float.IsFinite(round) ? round : 1;
    }
}
