using System.CommandLine;
using System.Text.Json;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary><c>raytracer check SCENE…</c></summary>
internal static class CheckVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string[]> scenes = new("SCENE") { Description = "Scene files.", Arity = ArgumentArity.OneOrMore };
        ParsedOption<CheckFormat?> format = OptionValues.Choice<CheckFormat>("--format", "Output format: one line per problem (at most 20 per file), or everything as one JSON object or SARIF 2.1.0. Default: text.");
        command.Arguments.Add(scenes);
        command.Options.Add(format.Symbol);
        SettingOption settings = new(command);
        VerboseOption verbose = new(command);
        command.SetAction(result => Run(result.GetValue(scenes)!, settings.Values(result), format.Value(result) ?? CheckFormat.Text, verbose.Times(result, streams), streams));
    }

    private static int Run(string[] paths, IReadOnlyList<SceneSetting> settings, CheckFormat format, StageTimes stages, Streams streams)
    {
        List<CheckedScene> all = [];
        foreach (string path in paths)
        {
            SceneLoadResult result = SceneFile.Load(path, stages, settings: settings);
            CheckedScene scene = new(path, result.Diagnostics, result.Scene is null ? SceneFile.FailureStatus(path) : ExitStatus.Fine);
            all.Add(scene);
            if (format == CheckFormat.Text)
            {
                streams.Output.WriteLine(scene.Diagnostics.Count == 0 ? $"{path}: fine" : Diagnostic.Format(scene.Diagnostics));
            }
        }

        if (format == CheckFormat.Json)
        {
            JsonText.Write(streams, json => WriteJson(json, all));
        }
        else if (format == CheckFormat.Sarif)
        {
            JsonText.Write(streams, json => SarifLog.Write(json, all));
        }

        stages.EndAll();
        return all.Max(s => s.Status);
    }

    private static void WriteJson(Utf8JsonWriter json, List<CheckedScene> scenes)
    {
        json.WriteNumber("errors", scenes.Sum(s => s.Diagnostics.Count(d => d.Severity == Severity.Error)));
        json.WriteNumber("warnings", scenes.Sum(s => s.Diagnostics.Count(d => d.Severity == Severity.Warning)));
        json.WriteStartArray("files");
        foreach (CheckedScene scene in scenes)
        {
            json.WriteStartObject();
            json.WriteString("path", scene.Path);
            json.WriteBoolean("fine", scene.Diagnostics.Count == 0);
            json.WriteStartArray("diagnostics");
            foreach (Diagnostic diagnostic in scene.Diagnostics)
            {
                json.WriteStartObject();
                json.WriteString("severity", diagnostic.Severity == Severity.Error ? "error" : "warning");
                json.WriteString("rule", diagnostic.Rule.Id);
                json.WriteString("file", diagnostic.File);
                json.WriteNumber("line", diagnostic.Line);
                json.WriteNumber("column", diagnostic.Column);
                json.WriteString("message", diagnostic.Message);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }
}
