using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace RayTracer.Studio;

/// <summary>How data is written as JSON: camelCase, words for choices, arrays for vectors and colours, null for what is not finite.</summary>
internal static class ApiJson
{
    /// <summary>The conventions.</summary>
    public static JsonSerializerOptions Options { get; } = Configure(new(JsonSerializerDefaults.Web));

    /// <summary>Sets the conventions.</summary>
    public static JsonSerializerOptions Configure(JsonSerializerOptions options)
    {
        options.Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping;
        options.Converters.Add(new JsonStringEnumConverter(JsonNamingPolicy.CamelCase));
        options.Converters.Add(new VectorConverter());
        options.Converters.Add(new ColorConverter());
        options.Converters.Add(new DoubleConverter());
        options.Converters.Add(new FloatConverter());
        return options;
    }
}
