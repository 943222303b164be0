using System.Collections;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>The equality of descriptions by their values: texts that differ in comments and formatting only give equal ones.</summary>
public static class DescriptionEquality
{
    /// <summary>Compares two values of parameters.</summary>
    public static bool Same(object? a, object? b)
    {
        if (ReferenceEquals(a, b))
        {
            return true;
        }

        return (a, b) switch
        {
            (null, _) or (_, null) => false,
            (string, _) => a.Equals(b),
            (IDictionary x, IDictionary y) => x.Count == y.Count && x.Keys.Cast<object>().All(k => y.Contains(k) && Same(x[k], y[k])),
            (IList x, IList y) => x.Count == y.Count && SameItems(x, y),
            _ when IsRecord(a) => a.GetType() == b.GetType() && RecordType.Of(a.GetType()).Parameters.All(p => Same(p.Get(a), p.Get(b))),
            _ => a.Equals(b),
        };
    }

    /// <summary>Returns whether two scenes are the same but for camera and rendering.</summary>
    public static bool SameThings(SceneDescription a, SceneDescription b) =>
        Same(a with { Camera = b.Camera, Render = b.Render }, b);

    private static bool SameItems(IList a, IList b)
    {
        for (int i = 0; i < a.Count; i++)
        {
            if (!Same(a[i], b[i]))
            {
                return false;
            }
        }

        return true;
    }

    private static bool IsRecord(object value) => value is SceneDescription or CameraDescription or RenderDescription or LensDescription or FilterDescription
        or ShapeDescription or MaterialDescription or TextureDescription or EnvironmentDescription or TransformDescription or KeyframeDescription;
}
