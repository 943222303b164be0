using System.CommandLine;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;
using JsonNode = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Cli;

/// <summary>
/// <c>raytracer sweep SCENE --set PATH=VALUE,VALUE -o FILE</c>: renders a scene with all values of some settings, as one labelled sheet.
/// </summary>
internal sealed class SweepVerb
{
    private const int StandardCell = 240;

    private readonly Argument<string> _scene = new("SCENE") { Description = "The scene file." };
    private readonly WritingOptions _writing;
    private readonly JobOptionSet _overrides;
    private readonly ParsedOption<long?> _cell = OptionValues.Integer(
        "--cell", $"Columns of each picture, its rows by the scene's shape; without it (and --width, --height and --scale), at most {StandardCell}.", 8, 1 << 16);

    private readonly DisplayOptions _display;

    private SweepVerb(Command command)
    {
        command.Arguments.Add(_scene);
        _writing = new(command, $"The sheet's file: {ImageFormat.Endings()}. May be given several times.");
        _overrides = new(command, [.. JobOptions.OfScenes, JobOptions.Threads]);
        command.AddOptions([_cell, .. _writing.Looks]);
        _display = new(command, hasPreview: false);
    }

    public static void Build(Command command, Streams streams)
    {
        SweepVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    private int Run(ParseResult result, Streams streams)
    {
        Display display = _display.Of(result);
        IReadOnlyList<string> outputs = _writing.Files(result, display, "the films' hashes", JobFiles.Check);
        _writing.WarnOfUnused(result, outputs, streams, isSeen: true);
        StageTimes stages = _display.Times(result, streams);
        RenderJob job = _overrides.Given(result) with { Scene = result.GetValue(_scene)!, Outputs = outputs, Writing = _writing.Writing(result) };
        if (JobRules.Complaint(job, "--json") is { } complaint)
        {
            throw new CommandException(ExitStatus.Usage, complaint);
        }

        SweepAxes axes = new(job.Settings);
        bool isSized = _cell.Value(result) is null && (job.Scale is not null || job.Settings.Any(s => s.Path is "render.width" or "render.height"));
        SweepRun run = new(job, axes, scene => isSized ? scene : Fit(scene, result), display, streams);
        if (!run.Check())
        {
            return SceneFile.FailureStatus(job.Scene);
        }

        stages.End("check");
        using StopSignals signals = new(streams);
        int failed = run.Render(signals.Token);
        stages.End("pictures");
        ImageWriteOptions writing = job.Writing with { Exposure = null, ToneMap = null, Metadata = PictureTexts.Of(CommandLine.Text(result), job.Scene) };
        IReadOnlyList<string> written = run.Sheet is { } sheet ? JobFiles.Write(outputs, sheet.Picture, writing, streams) : [];
        stages.End(JobStage.Write);
        if (display.Json)
        {
            JsonText.Write(streams, Json(axes, run.Films, written));
        }
        else if (!display.Quiet)
        {
            streams.Wrote(written);
        }

        return signals.Status != 0 ? signals.Status : failed != ExitStatus.Fine ? failed
            : written.Count < outputs.Count ? ExitStatus.InputOutput : ExitStatus.Fine;
    }

    private SceneDescription Fit(SceneDescription scene, ParseResult result)
    {
        int width = (int)(_cell.Value(result) ?? Math.Min(StandardCell, scene.Render.Width));
        return scene with
        {
            Render = scene.Render with { Width = width, Height = Math.Max(1, (int)Math.Round((double)scene.Render.Height * width / scene.Render.Width)) },
        };
    }

    private static JsonObject Json(SweepAxes axes, IReadOnlyList<(SweepCell Cell, string Hash)> films, IReadOnlyList<string> written) =>
        new()
        {
            ["films"] = JsonText.List(films.Select(f => new JsonObject
            {
                ["settings"] = new JsonObject(axes.Changes(f.Cell).Select(s => KeyValuePair.Create(s.Path, (JsonNode?)s.Value))),
                ["filmHash"] = f.Hash,
            })),
            ["outputs"] = JsonText.List(written),
        };
}
