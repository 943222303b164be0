using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Scenes as they are at frames of their animation, read as jobs read them.</summary>
internal static class FrameTimes
{
    /// <summary>The number of the last frame that there may be.</summary>
    public const int Last = 9_999_999;

    /// <summary>Returns whether something moves while frames go by, besides what tracks change.</summary>
    public static bool IsMoving(SceneReadResult read) => read.Root is { } root && HasMotion(root);

    /// <summary>A scene with the values of its tracks at a frame; itself where it has none.</summary>
    /// <param name="read">The scene as it is written.</param>
    /// <param name="frame">The frame; null for the scene as it is written.</param>
    public static SceneReadResult Read(SceneReadResult read, int? frame) =>
        frame is not null && read is { Description.Animation.Count: > 0, Source: { } source } ? SceneReader.ReadText(source.Text, source.FileName, frame: frame) : read;

    /// <summary>Opens the shutter of what is seen of a scene at the time of a frame, where something is animated; null where the scene is seen as it was read.</summary>
    public static Func<SceneDescription, SceneDescription>? Opened(SceneReadResult read, int? frame, SceneDescription? seen) =>
        frame is { } number && (read.Description is { Animation.Count: > 0 } || IsMoving(read)) ? scene => ReadScene.AtFrame(seen ?? scene, number)
        : seen is null || ReferenceEquals(seen, read.Description) ? null : _ => seen;

    /// <summary>The frames a second of a scene.</summary>
    public static double Rate(JsonNode root) =>
        SceneValue.Scene(root).Child("render")!.Number("framesPerSecond") is var rate && rate > 0 ? rate : new RenderDescription().FramesPerSecond;

    /// <summary>The time of a frame, as keys have it.</summary>
    public static float TimeOf(double frame, double rate) => (float)(frame / rate);

    /// <summary>Returns whether a key is at a frame: its time may be written with some digits only.</summary>
    public static bool IsAt(double time, int frame, double rate) => Math.Abs((time * rate) - frame) < 0.01;

    /// <summary>Returns whether a part of a scene is a model, in whose file there may be an animation.</summary>
    public static bool IsModel(JsonNode node) => node.Find("type") is { Kind: JsonKind.String, Text: "model" };

    /// <summary>Returns whether there is a model anywhere in a part of a scene.</summary>
    public static bool HasModel(JsonNode node) => IsModel(node) || node.Items.Any(HasModel) || node.Members.Any(m => HasModel(m.Value));

    private static bool HasMotion(JsonNode node) => IsModel(node)
        || node.Items.Any(HasMotion) || node.Members.Any(m => (m.Key == "motion" && m.Value is { Kind: JsonKind.Array, Items.Count: > 0 }) || HasMotion(m.Value));
}
