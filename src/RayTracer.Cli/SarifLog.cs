using System.Text.Json;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>Diagnostics in the Static Analysis Results Interchange Format (OASIS SARIF 2.1.0).</summary>
internal static class SarifLog
{
    /// <summary>Writes the members of the log.</summary>
    public static void Write(Utf8JsonWriter json, IReadOnlyList<CheckedScene> scenes)
    {
        json.WriteString("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
        json.WriteString("version", "2.1.0");
        json.WriteStartArray("runs");
        json.WriteStartObject();
        WriteTool(json);
        json.WriteString("columnKind", "utf16CodeUnits");
        WriteFiles(json, scenes);
        json.WriteStartArray("results");
        foreach ((CheckedScene scene, int index) in scenes.Select((s, i) => (s, i)))
        {
            foreach (Diagnostic diagnostic in scene.Diagnostics)
            {
                WriteResult(json, scene, index, diagnostic);
            }
        }

        json.WriteEndArray();
        json.WriteEndObject();
        json.WriteEndArray();
    }

    private static void WriteTool(Utf8JsonWriter json)
    {
        json.WriteStartObject("tool");
        json.WriteStartObject("driver");
        json.WriteString("name", "raytracer");
        json.WriteString("version", typeof(SarifLog).Assembly.GetName().Version!.ToString(3));
        json.WriteStartArray("rules");
        foreach (DiagnosticRule rule in DiagnosticRule.All)
        {
            json.WriteStartObject();
            json.WriteString("id", rule.Id);
            WriteText(json, "shortDescription", rule.Summary);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void WriteFiles(Utf8JsonWriter json, IReadOnlyList<CheckedScene> scenes)
    {
        json.WriteStartArray("artifacts");
        foreach (CheckedScene scene in scenes)
        {
            json.WriteStartObject();
            json.WriteStartObject("location");
            json.WriteString("uri", UriOf(scene.Path));
            json.WriteEndObject();
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteResult(Utf8JsonWriter json, CheckedScene scene, int index, Diagnostic diagnostic)
    {
        json.WriteStartObject();
        json.WriteString("ruleId", diagnostic.Rule.Id);
        json.WriteNumber("ruleIndex", DiagnosticRule.All.ToList().IndexOf(diagnostic.Rule));
        json.WriteString("level", diagnostic.Severity == Severity.Error ? "error" : "warning");
        bool isOption = diagnostic is { Line: 0, Column: > 0 };
        WriteText(json, "message", isOption ? $"{diagnostic.File}, column {diagnostic.Column}: {diagnostic.Message}" : diagnostic.Message);
        json.WriteStartArray("locations");
        json.WriteStartObject();
        json.WriteStartObject("physicalLocation");
        bool isScene = isOption || diagnostic.File == scene.Path || diagnostic.Line == 0;
        json.WriteStartObject("artifactLocation");
        json.WriteString("uri", UriOf(isScene ? scene.Path : diagnostic.File));
        if (isScene)
        {
            json.WriteNumber("index", index);
        }

        json.WriteEndObject();
        if (diagnostic.Line > 0)
        {
            json.WriteStartObject("region");
            json.WriteNumber("startLine", diagnostic.Line);
            json.WriteNumber("startColumn", diagnostic.Column);
            json.WriteEndObject();
        }

        json.WriteEndObject();
        json.WriteEndObject();
        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WriteText(Utf8JsonWriter json, string key, string text)
    {
        json.WriteStartObject(key);
        json.WriteString("text", text);
        json.WriteEndObject();
    }

    // Relative paths stay so: whoever reads the log knows from where.
    private static string UriOf(string path)
    {
        string escaped = string.Join('/', path.Split(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar).Select(Uri.EscapeDataString));
        return Path.IsPathRooted(path) ? new Uri(Path.GetFullPath(path)).AbsoluteUri : escaped;
    }
}
