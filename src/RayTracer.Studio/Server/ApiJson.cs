using System.Numerics;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;
using RayTracer.Numerics;

namespace RayTracer.Studio;

/// <summary>
/// The options of JSON: camelCase, words for choices, arrays for vectors and colours, null for numbers that are not finite.
/// </summary>
internal static class ApiJson
{
    /// <summary>The conventions.</summary>
    public static JsonSerializerOptions Options { get; } = Configure(new(JsonSerializerDefaults.Web));

    /// <summary>Sets the conventions.</summary>
    public static JsonSerializerOptions Configure(JsonSerializerOptions options)
    {
        options.Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping;
        options.Converters.Add(new JsonStringEnumConverter(JsonNamingPolicy.CamelCase));
        options.Converters.Add(new ArrayConverter<Vector2>(2, n => new(n[0], n[1]), v => [v.X, v.Y]));
        options.Converters.Add(new ArrayConverter<Vector3>(3, n => new(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]));
        options.Converters.Add(new ArrayConverter<Rgb>(3, n => new(n[0], n[1], n[2]), c => [c.R, c.G, c.B]));
        options.Converters.Add(new DoubleConverter());
        options.Converters.Add(new FloatConverter());
        return options;
    }

    private sealed class ArrayConverter<T>(int length, Func<float[], T> read, Func<T, float[]> write) : JsonConverter<T>
    {
        public override T Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) =>
            JsonSerializer.Deserialize<float[]>(ref reader, options) is { } numbers && numbers.Length == length ? read(numbers)
                : throw new JsonException($"{length} numbers are expected.");

        public override void Write(Utf8JsonWriter writer, T value, JsonSerializerOptions options) =>
            JsonSerializer.Serialize(writer, write(value), options);
    }

    private sealed class DoubleConverter : JsonConverter<double>
    {
        public override double Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) => reader.GetDouble();

        public override void Write(Utf8JsonWriter writer, double value, JsonSerializerOptions options)
        {
            if (double.IsFinite(value))
            {
                writer.WriteNumberValue(value);
            }
            else
            {
                writer.WriteNullValue();
            }
        }
    }

    private sealed class FloatConverter : JsonConverter<float>
    {
        public override float Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) => reader.GetSingle();

        public override void Write(Utf8JsonWriter writer, float value, JsonSerializerOptions options)
        {
            if (float.IsFinite(value))
            {
                writer.WriteNumberValue(value);
            }
            else
            {
                writer.WriteNullValue();
            }
        }
    }
}
