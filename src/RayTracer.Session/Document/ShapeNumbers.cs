using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Numerics;
using RayTracer.Scenes;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>Works a map into the numbers of a shape, where that makes one of the same kind with the same look.</summary>
internal static class ShapeNumbers
{
    /// <summary>The numbers after the map; null where it needs a transform.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="map">The map.</param>
    /// <param name="isTextured">Whether its uv is seen.</param>
    public static JsonObject? Moved(SceneValue shape, Transform map, bool isTextured)
    {
        bool keepsTurn = map is { X: { B: 0, C: 0, A: > 0 }, Y: { A: 0, C: 0, B: > 0 }, Z: { A: 0, B: 0, C: > 0 } };
        double? scale = map.UniformScale();

        // What is round keeps its kind if it keeps its shape; its uv would be turned too.
        double? roundScale = isTextured && !keepsTurn ? null : scale;
        Vector3 At(string key) => map.Point(shape.Vector(key));
        return shape.Type?.Name switch
        {
            "sphere" when roundScale is { } s => Of(("center", At("center")), Length(shape, "radius", s)),
            "torus" when roundScale is { } s => Of(("center", At("center")), Direction(shape, "axis", map), Length(shape, "radius", s), Length(shape, "tubeRadius", s)),
            "disk" when roundScale is { } s => Of(("center", At("center")), Normal(shape, map), Length(shape, "radius", s)),
            "cylinder" when roundScale is { } s => Of(("bottom", At("bottom")), ("top", At("top")), Length(shape, "radius", s)),
            "cone" when roundScale is { } s => Of(("bottom", At("bottom")), ("top", At("top")), Length(shape, "radius", s), Length(shape, "topRadius", s)),
            "box" when keepsTurn => Of(("a", At("a")), ("b", At("b"))),
            "rectangle" when map.Determinant > 0 => Of(("corner", At("corner")), ("edgeU", map.Vector(shape.Vector("edgeU"))), ("edgeV", map.Vector(shape.Vector("edgeV")))),
            "triangle" when map.Determinant > 0 => Of(("a", At("a")), ("b", At("b")), ("c", At("c"))),
            "point" => Of(("position", At("position"))),
            "spot" => Of(("position", At("position")), Direction(shape, "direction", map)),
            "directional" => Of(Direction(shape, "direction", map)),
            "plane" => Plane(shape, map, isTextured, scale),
            _ => null,
        };
    }

    /// <summary>About where the middle of a shape is, in its own space: the origin for what consists of others.</summary>
    public static Vector3 Middle(SceneValue shape)
    {
        Vector3 Mean(params ReadOnlySpan<string> keys)
        {
            Vector3 sum = default;
            foreach (string key in keys)
            {
                sum += shape.Vector(key) * (1f / keys.Length);
            }

            return sum;
        }

        return shape.Type?.Name switch
        {
            "sphere" or "torus" or "disk" => shape.Vector("center"),
            "cylinder" or "cone" => Mean("bottom", "top"),
            "box" => Mean("a", "b"),
            "rectangle" => shape.Vector("corner") + (0.5f * (shape.Vector("edgeU") + shape.Vector("edgeV"))),
            "triangle" => Mean("a", "b", "c"),
            "plane" => shape.Vector("point"),
            "point" or "spot" => shape.Vector("position"),
            _ => default,
        };
    }

    private static JsonObject? Plane(SceneValue shape, Transform map, bool isTextured, double? scale)
    {
        Vector3 normal = shape.Vector("normal").Unit();
        Vector3 moved = map.Inverse().TransposedVector(normal).Unit();
        JsonObject numbers = Of(("point", map.Point(shape.Vector("point"))), ("normal", Same(shape.Vector("normal"), moved)));
        JsonNode? size = shape.Child("size")?.Node;
        if (size is null && !isTextured)
        {
            return numbers;
        }

        // The sides of the rectangle, and uv, are what the plane's own rule makes of its normal.
        (Vector3 tangent, Vector3 bitangent) = Sides(normal);
        (Vector3 newTangent, Vector3 newBitangent) = Sides(moved);
        (Vector3 width, Vector3 height) = (map.Vector(tangent), map.Vector(bitangent));
        if (!((newTangent - width.Unit()).Norm() < 1e-6f && (newBitangent - height.Unit()).Norm() < 1e-6f))
        {
            return null;
        }

        if (size is null)
        {
            return scale is { } s && Math.Abs(s - 1) < 1e-6 ? numbers : null;
        }

        if (size is not { Kind: JsonKind.Array, Items.Count: 2 } || size.Items.Any(i => i.Kind != JsonKind.Number))
        {
            return null;
        }

        numbers["size"] = new JsonArray(JsonValues.Number(SceneValue.ToFloat(size.Items[0]) * width.Norm()), JsonValues.Number(SceneValue.ToFloat(size.Items[1]) * height.Norm()));
        return numbers;
    }

    // As RayTracer.Shapes.Plane has them.
    private static (Vector3 Tangent, Vector3 Bitangent) Sides(Vector3 normal)
    {
        bool isLevel = (normal.X * normal.X) + (normal.Z * normal.Z) < 1e-6f;
        Vector3 tangent = (isLevel ? new Vector3(0, 0, -1) : new Vector3(0, 1, 0)).Cross(normal).Unit();
        return (tangent, normal.Cross(tangent));
    }

    private static (string Key, Vector3 Value) Direction(SceneValue shape, string key, Transform map) => (key, Same(shape.Vector(key), map.Vector(shape.Vector(key)).Unit()));

    private static (string Key, Vector3 Value) Normal(SceneValue shape, Transform map) =>
        ("normal", Same(shape.Vector("normal"), map.Inverse().TransposedVector(shape.Vector("normal")).Unit()));

    // A direction of any length stays as it is written if it stays what it is.
    private static Vector3 Same(Vector3 written, Vector3 moved) => (written.Unit() - moved).Norm() < 1e-6f ? written : moved;

    private static (string Key, double Value) Length(SceneValue shape, string key, double scale) => (key, shape.Number(key) * scale);

    private static JsonObject Of(params ReadOnlySpan<Entry> entries)
    {
        JsonObject numbers = [];
        foreach (Entry entry in entries)
        {
            numbers[entry.Key] = entry.Value;
        }

        return numbers;
    }

    private readonly record struct Entry(string Key, System.Text.Json.Nodes.JsonNode Value)
    {
        public static implicit operator Entry((string Key, Vector3 Value) v) => new(v.Key, JsonValues.Vector(v.Value));

        public static implicit operator Entry((string Key, double Value) n) => new(n.Key, JsonValues.Number(n.Value));
    }
}
