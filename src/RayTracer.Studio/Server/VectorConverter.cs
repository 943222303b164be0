using System.Numerics;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace RayTracer.Studio;

/// <summary>Vectors as arrays of three numbers.</summary>
internal sealed class VectorConverter : JsonConverter<Vector3>
{
    public override Vector3 Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) =>
        JsonSerializer.Deserialize<float[]>(ref reader, options) is [var x, var y, var z] ? new(x, y, z) : throw new JsonException("three numbers are expected");

    public override void Write(Utf8JsonWriter writer, Vector3 value, JsonSerializerOptions options) =>
        JsonSerializer.Serialize(writer, new[] { value.X, value.Y, value.Z }, options);
}
