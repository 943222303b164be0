using System.Text.Json;
using System.Text.Json.Serialization;
using RayTracer.Numerics;

namespace RayTracer.Studio;

/// <summary>Colours and radiance as arrays of three numbers.</summary>
internal sealed class ColorConverter : JsonConverter<Rgb>
{
    public override Rgb Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) =>
        JsonSerializer.Deserialize<float[]>(ref reader, options) is [var r, var g, var b] ? new(r, g, b) : throw new JsonException("three numbers are expected");

    public override void Write(Utf8JsonWriter writer, Rgb value, JsonSerializerOptions options) =>
        JsonSerializer.Serialize(writer, new[] { value.R, value.G, value.B }, options);
}
