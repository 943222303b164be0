using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>Values as plain JSON, without places.</summary>
public static class JsonValues
{
    /// <summary>A value of a text; of doubled keys the first one.</summary>
    public static Json? Of(JsonNode node)
    {
        switch (node.Kind)
        {
            case JsonKind.Object:
                JsonObject members = [];
                foreach (JsonMember member in node.Members)
                {
                    members.TryAdd(member.Key, Of(member.Value));
                }

                return members;
            case JsonKind.Array:
                return new JsonArray([.. node.Items.Select(Of)]);
            case JsonKind.String:
                return JsonValue.Create(node.Text);
            default:
                return Json.Parse(node.Text);
        }
    }

    /// <summary>A value of a description record; null for what may be missing.</summary>
    public static Json? Of(RecordParameter parameter, object? value) =>
        value is null ? null : Json.Parse(SceneWriter.WriteValue(parameter, value));

    /// <summary>
    /// A value of a description record whose numbers were computed: they are freed of the last digits that rounding left.
    /// </summary>
    /// <exception cref="SessionException">One is too large.</exception>
    public static Json? Rounded(RecordParameter parameter, object? value) => value switch
    {
        float number => Number(number),
        Vector2 v => new JsonArray(Number(v.X), Number(v.Y)),
        Vector3 v => Vector(v),
        _ => Of(parameter, value),
    };

    /// <summary>A number, freed of the last digits that rounding left.</summary>
    /// <exception cref="SessionException">It is too large.</exception>
    public static Json Number(double value)
    {
        float exact = (float)value;
        if (!float.IsFinite(exact))
        {
            throw new SessionException("the shape would move or grow beyond all numbers");
        }

        float round = float.Parse(exact.ToString("G6", System.Globalization.CultureInfo.InvariantCulture), System.Globalization.CultureInfo.InvariantCulture);
        return JsonValue.Create((Math.Abs(round - exact) <= 2.5e-7f * Math.Abs(exact) ? round : exact) + 0f);
    }

    /// <summary>Three numbers.</summary>
    public static JsonArray Vector(Vector3 v) => new(Number(v.X), Number(v.Y), Number(v.Z));
}
