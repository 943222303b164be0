using System.CommandLine;
using System.Text.Json.Nodes;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary><c>raytracer check SCENE…</c></summary>
internal static class CheckVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string[]> scenes = new("SCENE") { Description = "Scene files; - for standard input.", Arity = ArgumentArity.OneOrMore };
        ParsedOption<CheckFormat?> format = OptionValues.Choice<CheckFormat>("--format", "Output format: one line per problem (at most 20 per file), or everything as one JSON object or SARIF 2.1.0. Default: text.");
        command.Arguments.Add(scenes);
        command.Options.Add(format);
        JobOptionSet settings = new(command, [JobOptions.Set]);
        VerboseOption verbose = new(command);
        command.SetAction(result => Run(result.GetValue(scenes)!, settings.Given(result).Settings, format.Value(result) ?? CheckFormat.Text, verbose.Times(result, streams), streams));
    }

    private static int Run(string[] paths, IReadOnlyList<SceneSetting> settings, CheckFormat format, StageTimes stages, Streams streams)
    {
        List<CheckedScene> all = [];
        foreach (string path in paths)
        {
            SceneLoadResult result = SceneFile.Load(path, stages, settings: settings);
            CheckedScene scene = new(SceneFile.Name(path), result.Diagnostics, result.Scene is null ? SceneFile.FailureStatus(path) : ExitStatus.Fine);
            all.Add(scene);
            if (format == CheckFormat.Text)
            {
                streams.Output.WriteLine(scene.Diagnostics.Count == 0 ? $"{scene.Path}: fine" : Diagnostic.Format(scene.Diagnostics));
            }
        }

        if (format != CheckFormat.Text)
        {
            JsonText.Write(streams, format == CheckFormat.Json ? Json(all) : SarifLog.Of(all));
        }

        stages.EndAll();
        return all.Max(s => s.Status);
    }

    private static JsonObject Json(List<CheckedScene> scenes) => new()
    {
        ["errors"] = scenes.Sum(s => s.Diagnostics.Count(d => d.Severity == Severity.Error)),
        ["warnings"] = scenes.Sum(s => s.Diagnostics.Count(d => d.Severity == Severity.Warning)),
        ["files"] = JsonText.List(scenes.Select(s => new JsonObject
        {
            ["path"] = s.Path,
            ["fine"] = s.Diagnostics.Count == 0,
            ["diagnostics"] = JsonText.List(s.Diagnostics.Select(Json)),
        })),
    };

    private static JsonObject Json(Diagnostic diagnostic) => new()
    {
        ["severity"] = diagnostic.Severity.ToString().ToLowerInvariant(),
        ["rule"] = diagnostic.Rule.Id,
        ["file"] = diagnostic.File,
        ["line"] = diagnostic.Line,
        ["column"] = diagnostic.Column,
        ["message"] = diagnostic.Message,
    };

    /// <summary>The form of what <c>raytracer check</c> prints.</summary>
    private enum CheckFormat
    {
        /// <summary>A line each, as compilers write them.</summary>
        Text,

        /// <summary>A JSON object.</summary>
        Json,

        /// <summary>SARIF 2.1.0, which code hosts and editors show.</summary>
        Sarif,
    }
}

/// <summary>A scene file that was checked.</summary>
/// <param name="Path">The file.</param>
/// <param name="Diagnostics">All that is wrong, by position.</param>
/// <param name="Status">One of <see cref="ExitStatus"/>.</param>
internal sealed record CheckedScene(string Path, IReadOnlyList<Diagnostic> Diagnostics, int Status);
