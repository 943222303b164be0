using System.Text.Json.Nodes;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>Diagnostics in the Static Analysis Results Interchange Format (OASIS SARIF 2.1.0).</summary>
internal static class SarifLog
{
    /// <summary>Returns the log.</summary>
    public static JsonObject Of(IReadOnlyList<CheckedScene> scenes) => new()
    {
        ["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json",
        ["version"] = "2.1.0",
        ["runs"] = new JsonArray(new JsonObject
        {
            ["tool"] = new JsonObject { ["driver"] = Tool() },
            ["columnKind"] = "utf16CodeUnits",
            ["artifacts"] = JsonText.List(scenes.Select(s => new JsonObject { ["location"] = new JsonObject { ["uri"] = UriOf(s.Path) } })),
            ["results"] = JsonText.List(scenes.SelectMany((s, i) => s.Diagnostics.Select(d => Result(s, i, d)))),
        }),
    };

    private static JsonObject Tool() => new()
    {
        ["name"] = "raytracer",
        ["version"] = typeof(SarifLog).Assembly.GetName().Version!.ToString(3),
        ["rules"] = JsonText.List(DiagnosticRule.All.Select(r => new JsonObject { ["id"] = r.Id, ["shortDescription"] = Text(r.Summary) })),
    };

    private static JsonObject Result(CheckedScene scene, int index, Diagnostic diagnostic)
    {
        bool isOption = diagnostic is { Line: 0, Column: > 0 };
        bool isScene = isOption || diagnostic.File == scene.Path || diagnostic.Line == 0;
        JsonObject file = new() { ["uri"] = UriOf(isScene ? scene.Path : diagnostic.File) };
        if (isScene)
        {
            file["index"] = index;
        }

        JsonObject location = new() { ["artifactLocation"] = file };
        if (diagnostic.Line > 0)
        {
            location["region"] = new JsonObject { ["startLine"] = diagnostic.Line, ["startColumn"] = diagnostic.Column };
        }

        return new()
        {
            ["ruleId"] = diagnostic.Rule.Id,
            ["ruleIndex"] = DiagnosticRule.All.ToList().IndexOf(diagnostic.Rule),
            ["level"] = diagnostic.Severity.ToString().ToLowerInvariant(),
            ["message"] = Text(isOption ? $"{diagnostic.File}, column {diagnostic.Column}: {diagnostic.Message}" : diagnostic.Message),
            ["locations"] = new JsonArray(new JsonObject { ["physicalLocation"] = location }),
        };
    }

    private static JsonObject Text(string text) => new() { ["text"] = text };

    // Relative paths stay so: the reader of the log knows from where.
    private static string UriOf(string path)
    {
        string escaped = string.Join('/', path.Split(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar).Select(Uri.EscapeDataString));
        return Path.IsPathRooted(path) ? new Uri(Path.GetFullPath(path)).AbsoluteUri : escaped;
    }
}
