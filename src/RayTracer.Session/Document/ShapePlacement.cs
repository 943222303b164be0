using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>
/// Moves shapes in the world. The movement is worked into a shape's own numbers where that keeps it the same kind, else into its transform.
/// Of what moves in time, every keyframe is moved, so that it moves as before at another place.
/// </summary>
public static class ShapePlacement
{
    /// <summary>Adds a vector.</summary>
    /// <exception cref="SessionException">There is no shape, or it would be moved beyond all numbers.</exception>
    public static JsonText Translate(JsonText text, string pointer, Vector3 by) => Translate(text, pointer, by, null);

    /// <summary>The same; of what moves in time, the keyframe at a frame alone.</summary>
    internal static JsonText Translate(JsonText text, string pointer, Vector3 by, int? frame) => Place(text, pointer, new Movement.Translation(by), frame);

    /// <summary>Turns about an axis by the right-hand rule.</summary>
    /// <param name="text">The text.</param>
    /// <param name="pointer">The shape.</param>
    /// <param name="axis">The axis, of any length above zero.</param>
    /// <param name="degrees">The angle.</param>
    /// <param name="center">A point on the axis; null for the shape's middle.</param>
    /// <exception cref="SessionException">There is no shape, or the axis has no length.</exception>
    public static JsonText Rotate(JsonText text, string pointer, Vector3 axis, float degrees, Vector3? center = null) => Rotate(text, pointer, axis, degrees, center, null);

    /// <summary>The same; of what moves in time, the keyframe at a frame alone.</summary>
    internal static JsonText Rotate(JsonText text, string pointer, Vector3 axis, float degrees, Vector3? center, int? frame) => axis.Norm() > 0 && axis.Unit().IsFinite()
        ? Place(text, pointer, new Movement.Rotation(axis.Unit() is var unit && (axis - unit).Norm() < 1e-6f ? axis : unit, degrees, center ?? MiddleAt(text, pointer, frame)), frame)
        : throw new SessionException("the axis of a rotation must have a length");

    /// <summary>Makes larger or smaller along the axes of the world.</summary>
    /// <param name="text">The text.</param>
    /// <param name="pointer">The shape.</param>
    /// <param name="factors">The factors, none of them 0; negative ones mirror.</param>
    /// <param name="center">The point that stays; null for the shape's middle.</param>
    /// <exception cref="SessionException">There is no shape, or a factor is 0.</exception>
    public static JsonText Scale(JsonText text, string pointer, Vector3 factors, Vector3? center = null) => Scale(text, pointer, factors, center, null);

    /// <summary>The same; of what moves in time, the keyframe at a frame alone.</summary>
    internal static JsonText Scale(JsonText text, string pointer, Vector3 factors, Vector3? center, int? frame) => factors.X * factors.Y * factors.Z != 0
        ? Place(text, pointer, new Movement.Scaling(factors, center ?? MiddleAt(text, pointer, frame)), frame)
        : throw new SessionException("no factor of a scaling may be 0");

    /// <summary>About where a shape's middle is in the world: for what consists of others, where its own origin is.</summary>
    /// <exception cref="SessionException">There is no shape.</exception>
    public static Vector3 Middle(JsonText text, string pointer) => MiddleAt(text.Root, pointer, null);

    /// <summary>The same at a time.</summary>
    /// <param name="root">The scene.</param>
    /// <param name="pointer">The shape.</param>
    /// <param name="time">The time in seconds; null for where the first keyframes put things.</param>
    internal static Vector3 MiddleAt(JsonNode root, string pointer, double? time) =>
        SpaceAt(root, pointer, time).Point(Record(Shape(root, pointer)).Middle);

    /// <summary>The map from a shape's own space to the world at a time.</summary>
    /// <exception cref="SessionException">There is no shape.</exception>
    internal static Transform SpaceAt(JsonNode root, string pointer, double? time)
    {
        SceneValue shape = Shape(root, pointer);
        return Outer(root, pointer, time) * MotionAt(shape, time) * TransformEdit.Map(shape.Child("transform"));
    }

    /// <summary>Where its motion puts a thing at a time; null for where its first keyframe does.</summary>
    internal static Transform MotionAt(SceneValue thing, double? time)
    {
        (float Time, Transform Place)[] keys = [.. (thing.Child("motion")?.Children() ?? []).Select(k => (k.Number("time"), TransformEdit.Map(k.Child("transform"))))];
        int next = Array.FindIndex(keys, k => k.Time > (time ?? double.NegativeInfinity));
        return keys.Length == 0 ? Transform.Identity
            : next <= 0 ? (next == 0 ? keys[0].Place : keys[^1].Place)
            : new MotionSegment(keys[next - 1].Time, keys[next - 1].Place, keys[next].Time, keys[next].Place).At(time!.Value);
    }

    private static Vector3 MiddleAt(JsonText text, string pointer, int? frame) => MiddleAt(text.Root, pointer, TimeOf(text, frame));

    private static double? TimeOf(JsonText text, int? frame) => frame is { } number ? FrameTimes.TimeOf(number, FrameTimes.Rate(text.Root)) : null;

    private static JsonText Place(JsonText text, string pointer, Movement movement, int? frame)
    {
        SceneValue shape = Shape(text.Root, pointer);
        if (!movement.Map.IsInvertible)
        {
            throw new SessionException("the shape would become too large, too small or too far away to compute with");
        }

        Transform outer = Outer(text.Root, pointer, TimeOf(text, frame));
        Movement inner = outer.IsIdentity ? movement : movement.Within(outer);
        if (shape.Child("motion") is { Node.Items.Count: > 0 } motion)
        {
            double rate = FrameTimes.Rate(text.Root);
            return motion.Children().Where(k => frame is not { } number || FrameTimes.IsAt(k.Number("time"), number, rate))
                .Aggregate(text, (t, key) => TransformEdit.Append(t, key.Pointer + "/transform", inner));
        }

        ShapeDescription record = Record(shape);
        bool isPlain = !TransformEdit.Steps(shape.Child("transform")).Any();
        return isPlain && record.Moved(new(inner.Map, IsTextured(text.Root, shape))) is { } moved
            ? Write(text, shape, record, moved)
            : TransformEdit.Append(text, shape.Pointer + "/transform", inner);
    }

    private static ShapeDescription Record(SceneValue shape) => (ShapeDescription)shape.Record();

    // Only what changes is written.
    private static JsonText Write(JsonText text, SceneValue shape, ShapeDescription before, ShapeDescription after)
    {
        foreach (RecordParameter parameter in shape.Type!.Parameters)
        {
            (object? was, object? value) = (parameter.Get(before), parameter.Get(after));
            if (!Equals(was, value) && JsonValues.Rounded(parameter, value) is var json && !Json.DeepEquals(JsonValues.Rounded(parameter, was), json))
            {
                text = text.Set(JsonPointer.Append(shape.Pointer, parameter.Key), json);
            }
        }

        return text;
    }

    private static SceneValue Shape(JsonNode root, string pointer) =>
        SceneValue.At(root, pointer) is { Family: { } family, Type: not null } shape && family == SceneTypes.Shapes
            ? shape : throw new SessionException($"there is no shape at {JsonLayout.Quote(pointer)}");

    // Of all groups around a shape: what takes their space to the world.
    private static Transform Outer(JsonNode root, string pointer, double? time)
    {
        Transform map = Transform.Identity;
        SceneValue value = SceneValue.Scene(root);
        foreach (string step in JsonPointer.Parse(pointer).SkipLast(1))
        {
            value = value.Child(step)!;
            map = value.Family == SceneTypes.Shapes ? map * MotionAt(value, time) * TransformEdit.Map(value.Child("transform")) : map;
        }

        return map;
    }

    // Whether a texture of the shape's material, or of the groups around it, varies.
    private static bool IsTextured(JsonNode root, SceneValue shape)
    {
        for (string? pointer = shape.Pointer; pointer is { Length: > 0 }; pointer = JsonPointer.Parent(pointer))
        {
            if (SceneValue.At(root, pointer)?.Child("material") is { Node: not null } material)
            {
                return HasTexture(root, material, 0);
            }
        }

        return false;
    }

    private static bool HasTexture(JsonNode root, SceneValue thing, int nesting)
    {
        SceneValue made = thing.Resolved(root);
        bool varies = made.Family == SceneTypes.Textures && made.Type is { Name: not "solid" };
        return varies || (nesting < 16 && made.Children().Any(c => c.Family is not null && HasTexture(root, c, nesting + 1)));
    }
}
