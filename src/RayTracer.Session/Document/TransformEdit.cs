using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Numerics;
using RayTracer.Scenes;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>Reads and edits the steps under "transform": a list of them, or one alone.</summary>
internal static class TransformEdit
{
    /// <summary>The map of a list of steps; those that cannot be computed with are left out.</summary>
    public static Transform Map(SceneValue? list) =>
        Steps(list).Aggregate(Transform.Identity, (map, step) => MapOfStep(step) * map);

    /// <summary>The steps, in their order.</summary>
    public static IEnumerable<SceneValue> Steps(SceneValue? list) => list is { IsList: false } ? [list] : list?.Children() ?? [];

    /// <summary>
    /// Moves what a list of steps moves a little further. The last step is changed where it can hold the movement; otherwise another one
    /// follows.
    /// </summary>
    /// <param name="text">The text.</param>
    /// <param name="pointer">The list, which may be missing.</param>
    /// <param name="movement">The movement.</param>
    public static JsonText Append(JsonText text, string pointer, Movement movement)
    {
        SceneValue? list = SceneValue.At(text.Root, pointer);
        if (Steps(list).LastOrDefault() is { Node.Kind: JsonKind.Object } last && Join(text, last, movement) is { } joined)
        {
            return joined;
        }

        return list is { IsList: false, Node: { } only }
            ? text.Set(pointer, new JsonArray(JsonValues.Of(only), Step(movement)))
            : text.Set(JsonPointer.Append(pointer, "-"), Step(movement));
    }

    // A step does matrix, scale, rotation and translation in this order.
    private static JsonText? Join(JsonText text, SceneValue step, Movement movement)
    {
        Vector3 translate = step.Vector("translate");
        float rotate = step.Number("rotate");
        Vector3 scale = step.Vector("scale");
        switch (movement)
        {
            case Movement.Translation t:
                return Translate(text, step, translate + t.By);
            case Movement.Rotation r when rotate == 0 || IsParallel(step.Vector("axis"), r.Axis):
                bool isOpposite = rotate != 0 && Vector3.Dot(step.Vector("axis"), r.Axis) < 0;
                double angle = (rotate + (isOpposite ? -(double)r.Degrees : r.Degrees)) % 360;
                text = text.Set(step.Pointer + "/rotate", JsonValues.Number(angle));
                text = rotate == 0 && step.Vector("axis") != r.Axis ? text.Set(step.Pointer + "/axis", JsonValues.Vector(r.Axis)) : text;
                return Translate(text, step, Clean(r.Map.Point(translate), translate, r.Center));
            case Movement.Scaling s when rotate == 0 || s.IsUniform:
                text = text.Set(step.Pointer + "/scale", JsonValues.Vector(scale * s.Factors));
                return Translate(text, step, Clean(s.Map.Point(translate), translate, s.Center));
            default:
                return null;
        }
    }

    private static JsonText Translate(JsonText text, SceneValue step, Vector3 to) =>
        to == step.Vector("translate") ? text : text.Set(step.Pointer + "/translate", JsonValues.Vector(to));

    /// <summary>A movement as a step.</summary>
    internal static JsonObject Step(Movement movement)
    {
        JsonObject step = [];
        Vector3 translate = default;
        switch (movement)
        {
            case Movement.Translation t:
                translate = t.By;
                break;
            case Movement.Rotation r:
                step["rotate"] = JsonValues.Number(r.Degrees);
                if (r.Axis != Vector3.UnitY)
                {
                    step["axis"] = JsonValues.Vector(r.Axis);
                }

                translate = Clean(r.Map.Point(default), default, r.Center);
                break;
            case Movement.Scaling s:
                step["scale"] = JsonValues.Vector(s.Factors);
                translate = Clean(s.Map.Point(default), default, s.Center);
                break;
            default:
                step["matrix"] = new JsonArray([.. new[] { movement.Map.X, movement.Map.Y, movement.Map.Z }
                    .SelectMany(r => new[] { r.A, r.B, r.C, r.D }).Select(JsonValues.Number)]);
                return step;
        }

        if (translate != default || step.Count == 0)
        {
            step["translate"] = JsonValues.Vector(translate);
        }

        return step;
    }

    // What rounding leaves of a coordinate that is zero.
    private static Vector3 Clean(Vector3 v, Vector3 a, Vector3 b)
    {
        float least = 1e-6f * (a.Norm() + b.Norm());
        return new(Math.Abs(v.X) < least ? 0 : v.X, Math.Abs(v.Y) < least ? 0 : v.Y, Math.Abs(v.Z) < least ? 0 : v.Z);
    }

    private static bool IsParallel(Vector3 a, Vector3 b) => Vector3.Cross(a, b).Norm() < 1e-6f * a.Norm() * b.Norm();

    private static Transform MapOfStep(SceneValue step)
    {
        Vector3 scale = step.Vector("scale");
        Transform map = Transform.Translation(step.Vector("translate"))
            * (step.Number("rotate") is var degrees && degrees != 0 && step.Vector("axis").Norm() > 0 ? Transform.Rotation(step.Vector("axis"), degrees) : Transform.Identity)
            * (scale.X * scale.Y * scale.Z != 0 ? Transform.Scaling(scale) : Transform.Identity)
            * Matrix(step.Child("matrix")?.Node);
        return map.IsInvertible ? map : Transform.Identity;
    }

    private static Transform Matrix(JsonNode? node)
    {
        if (node is not { Kind: JsonKind.Array, Items.Count: 12 or 16 } || node.Items.Any(i => i.Number is null))
        {
            return Transform.Identity;
        }

        float[] m = [.. node.Items.Select(i => i.Number!.Value)];
        return new(new(m[0], m[1], m[2], m[3]), new(m[4], m[5], m[6], m[7]), new(m[8], m[9], m[10], m[11]));
    }
}
