using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Describes the cameras of a glTF file (glTF 2.0, section 3.10): they look along −z, with y up.</summary>
internal sealed class GltfCameras(GltfDocument document)
{
    private const float NarrowestDegrees = 0.001f;
    private const float WidestDegrees = 179;
    private const float LargestRatio = 16;
    private const int MostKeyframes = 2000;

    // Of the way from key to key, where that is curved.
    private const int Pieces = 4;

    /// <summary>A node's camera; null where it has none, or one that there is none like here.</summary>
    /// <param name="node">The node.</param>
    /// <param name="world">Its place.</param>
    /// <param name="aspectRatio">Width over height of the picture that the camera is meant for; null where it says nothing.</param>
    public CameraDescription? Describe(GltfObject node, Transform world, out float? aspectRatio)
    {
        aspectRatio = null;
        if (document.Reference(node, "camera", "cameras") is not { } index)
        {
            return null;
        }

        GltfObject camera = document.List("cameras")[index];
        switch (camera.Text("type"))
        {
            case "perspective":
                GltfObject perspective = camera.RequiredChild("perspective");
                aspectRatio = perspective.Has("aspectRatio") ? perspective.Number("aspectRatio", 1, 0) : null;
                float degrees = float.Clamp(perspective.RequiredNumber("yfov", float.Epsilon) * (180 / float.Pi), NarrowestDegrees, WidestDegrees);
                return At(node, world) is { } eye ? eye with { FieldOfView = degrees } : null;
            case "orthographic":
                GltfObject orthographic = camera.RequiredChild("orthographic");
                (float across, float along) = (float.Abs(orthographic.RequiredNumber("xmag")), float.Abs(orthographic.RequiredNumber("ymag")));
                if (!(across > 0 && along > 0 && float.IsFinite(2 * along)))
                {
                    throw orthographic.Error("ymag", "an orthographic camera must have a size above 0");
                }

                aspectRatio = across / along;
                return At(node, world) is { } placed ? placed with { Projection = Projection.Orthographic, ViewSize = 2 * along } : null;
            default:
                throw camera.Error("type", "expected \"perspective\" or \"orthographic\"");
        }
    }

    /// <summary>A camera that moves with its node: <see cref="Describe"/> of one that stands at the origin, and keyframes for all of an animation.</summary>
    /// <param name="still">That camera.</param>
    /// <param name="nodes">The nodes.</param>
    /// <param name="clip">The animation.</param>
    /// <param name="node">The camera's node.</param>
    /// <returns>The camera; null where it stands still, or its node vanishes.</returns>
    public static CameraDescription? Moving(CameraDescription still, GltfNodes nodes, GltfClip clip, int node)
    {
        IReadOnlyList<GltfSampler> keys = nodes.KeysOf(clip, node);
        double[] times = Times(keys);
        Transform?[] places = [.. times.Select(t => Rigid(nodes.Worlds(clip, t)[node]))];
        return places.Length > 1 && places.All(p => p is not null) && places.Any(p => p != places[0])
            ? still with { Motion = [.. places.Zip(times, (p, t) => new KeyframeDescription { Time = (float)t, Transform = GltfPose.Steps(p!.Value) })] }
            : null;
    }

    // A straight way at constant speed is as far as its keys say what it is.
    private static double[] Times(IReadOnlyList<GltfSampler> keys)
    {
        double[] times = [.. keys.SelectMany(k => k.Times).Select(t => (double)t).Distinct().Order()];
        int pieces = keys.Count(k => k.Times.Count > 1) > 3 || keys.Any(k => k.IsCurved) ? Pieces : 1;
        double[] all = [.. times.Zip(times.Skip(1)).SelectMany(i => Enumerable.Range(0, pieces).Select(p => i.First + ((i.Second - i.First) * p / pieces))), .. times.TakeLast(1)];
        double step = all.Length > MostKeyframes ? all[^1] / MostKeyframes : 0;
        float last = float.NegativeInfinity;
        List<double> apart = [];
        foreach (double time in all)
        {
            if ((float)time > last && (apart.Count == 0 || time >= apart[^1] + step))
            {
                apart.Add(time);
                last = (float)time;
            }
        }

        return [.. apart];
    }

    // Only the directions and the position of a node count for a camera. Null where it has none.
    private static Transform? Rigid(Transform world)
    {
        Vector3 back = world.Vector(Vector3.UnitZ).Unit();
        Vector3 right = world.Vector(Vector3.UnitY).Cross(back).Unit();
        Vector3 up = back.Cross(right);
        Vector3 at = world.Point(Vector3.Zero);
        Transform rigid = new(new(right.X, up.X, back.X, at.X), new(right.Y, up.Y, back.Y, at.Y), new(right.Z, up.Z, back.Z, at.Z));
        return GltfPose.IsGood(rigid) ? rigid : null;
    }

    /// <summary>The size of a picture of so many times its height in width; the default where nothing is said.</summary>
    public static RenderDescription PictureSize(float? aspectRatio)
    {
        RenderDescription render = new();
        return aspectRatio is { } ratio && ratio > 0
            ? render with { Width = (int)(render.Height * float.Clamp(ratio, 1 / LargestRatio, LargestRatio)) }
            : render;
    }

    // A node's camera in the middle of its space; null where that is nowhere.
    private CameraDescription? At(GltfObject node, Transform world)
    {
        // The point looked at is as far away as the coordinates are large, so that their rounding does not turn the view.
        Vector3 position = world.Point(Vector3.Zero);
        Vector3 lookAt = position - (world.Vector(Vector3.UnitZ).Unit() * float.Max(1, position.Norm()));
        CameraDescription camera = new()
        {
            Position = position,
            LookAt = lookAt,
            Up = world.Vector(Vector3.UnitY).Unit(),
        };
        if (camera.Position.IsFinite() && camera.LookAt.IsFinite() && camera.Up.IsFinite())
        {
            return camera;
        }

        document.Notes.Add($"the camera at {node.Path} is ignored: its node is scaled to nothing, or too far away");
        return null;
    }
}
