using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>The ways of things through the picture of one frame while the frames go by.</summary>
/// <param name="Camera">The camera's places in the picture, in pixels, one a step; null behind the eye. Empty where it stands still.</param>
/// <param name="Thing">Those of the thing's middle.</param>
/// <param name="Step">The frames from one place to the next.</param>
public sealed record MotionPaths(IReadOnlyList<Vector2?> Camera, IReadOnlyList<Vector2?> Thing, int Step)
{
    private const int MostPlaces = 240;

    /// <summary>The ways.</summary>
    /// <param name="read">The scene as it is written.</param>
    /// <param name="frame">The camera of the picture.</param>
    /// <param name="thing">The pointer of the thing; null for none.</param>
    /// <param name="frames">The number of frames.</param>
    /// <param name="rate">The frames a second.</param>
    internal static MotionPaths Of(SceneReadResult read, CameraFrame frame, string? thing, int frames, double rate)
    {
        int step = Math.Max(1, frames / MostPlaces);
        if (read is not { Description: { } scene, Root: { } root } || frames == 0)
        {
            return new([], [], step);
        }

        List<Vector3> camera = [];
        List<Vector3> middle = [];
        bool isShape = thing is not null && SceneValue.At(root, thing) is { Family: { } family, Type: not null, Node: not null } && family == SceneTypes.Shapes;
        for (int i = 0; i <= frames; i += step)
        {
            double time = i / rate;
            JsonNode then = scene.Animation.Count == 0 ? root : AnimationTrack.Apply(root, scene.Animation, read.SourceMap, time);
            SceneValue eye = SceneValue.At(then, "/camera")!;
            camera.Add((ShapePlacement.MotionAt(eye, time) * TransformEdit.Map(eye.Child("transform"))).Point(eye.Vector("position")));
            if (isShape)
            {
                middle.Add(ShapePlacement.MiddleAt(then, thing!, time));
            }
        }

        return new(Seen(camera, frame), Seen(middle, frame), step);
    }

    // Where one stands still, there is no way.
    private static Vector2?[] Seen(List<Vector3> places, CameraFrame frame) =>
        places.TrueForAll(p => p == places[0]) ? [] : [.. places.Select(frame.Project)];
}
