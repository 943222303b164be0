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

/// <summary><c>raytracer sweep SCENE --set PATH=VALUE,VALUE -o FILE</c>: renders a scene with all values of some settings, as one labelled sheet.</summary>
internal sealed class SweepVerb
{
    private const int StandardCell = 240;

    private readonly Argument<string> _scene = new("SCENE") { Description = "The scene file." };
    private readonly WritingOptions _writing;
    private readonly JobOptionSet _overrides;
    private readonly ParsedOption<long?> _cell = OptionValues.Integer("--cell", $"Columns of each picture, its rows by the scene's shape; without it (and --width and --height), at most {StandardCell}.", 8, 1 << 16);
    private readonly ParsedOption<long?> _threads = OptionValues.Integer("--threads", "Number of threads; without it, one for each core.", 1, 1024);
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Prints errors and warnings only." };
    private readonly VerboseOption _verbose;
    private readonly Option<bool> _json = new("--json") { Description = "Prints one JSON object of the axes and films." };

    private SweepVerb(Command command)
    {
        command.Arguments.Add(_scene);
        _writing = new(command, $"The sheet's file: {ImageFormat.Endings()}. May be given several times.");
        _overrides = new(command, JobOptions.OfScenes);
        foreach (Option option in new Option[] { _cell.Symbol, _threads.Symbol }.Concat(_writing.Looks).Concat([_quiet, _json]))
        {
            command.Options.Add(option);
        }

        _verbose = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        SweepVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    private int Run(ParseResult result, Streams streams)
    {
        IReadOnlyList<string> outputs = _writing.Files(result);
        if (outputs.Count == 0 && !result.GetValue(_json))
        {
            throw new CommandException(ExitStatus.Usage, "where to? Give -o FILE (or --json alone for the films' hashes)");
        }

        foreach (string output in outputs)
        {
            JobFiles.Check(output);
        }

        _writing.WarnOfUnused(result, outputs, streams, isSeen: true);
        StageTimes stages = _verbose.Times(result, streams);
        string path = result.GetValue(_scene)!;
        IReadOnlyList<SceneSetting> given = _overrides.Given(result).Settings;
        SweepAxes axes = new(given);
        bool isSized = _cell.Value(result) is null && given.Any(s => s.Path is "render.width" or "render.height");
        SceneDescription Changed(SceneDescription scene) => isSized ? scene : Fit(scene, result);
        (int Width, int Height)? size = null;
        foreach (SweepCell cell in axes.Samples)
        {
            // Before hours of rendering: is there a scene for each value, of the size of the others?
            if (SceneFile.Load(path, streams, Changed, axes.Settings(cell)) is not { } scene)
            {
                return SceneFile.FailureStatus(path);
            }

            size ??= (scene.Render.Width, scene.Render.Height);
            if (size != (scene.Render.Width, scene.Render.Height))
            {
                throw new CommandException(ExitStatus.Usage, OtherSize(size.Value.Width, size.Value.Height, scene.Render.Width, scene.Render.Height));
            }
        }

        stages.End("check");
        using StopSignals signals = new(streams);
        ImageWriteOptions writing = _writing.Writing(result);
        ContactSheet? sheet = null;
        int failed = ExitStatus.Fine;
        List<(SweepCell Cell, string Hash)> films = [];
        foreach (SweepCell cell in axes.Cells.TakeWhile(_ => !signals.Token.IsCancellationRequested))
        {
            RenderJob job = new() { Scene = path, Writing = writing, Threads = (int)(_threads.Value(result) ?? Environment.ProcessorCount), Settings = axes.Settings(cell) };
            ConsoleRun watch = new(new(Quiet: true, Verbose: _verbose.Value(result)), streams);
            if (new JobRun(job, watch) { Change = Changed }.Compute(signals.Token) is not { } outcome)
            {
                // Its place stays dark.
                failed = SceneFile.FailureStatus(path);
                streams.Fail($"these errors are with {string.Join(' ', axes.Changes(cell).Select(s => s.Text))}");
                continue;
            }

            sheet ??= Sheet(axes, outcome.Film);
            if ((outcome.Film.Width, outcome.Film.Height) != (sheet.CellWidth, sheet.CellHeight))
            {
                failed = ExitStatus.Usage;
                streams.Fail(OtherSize(sheet.CellWidth, sheet.CellHeight, outcome.Film.Width, outcome.Film.Height));
                continue;
            }

            // As it is to be seen, whatever the file: labels have no exposure.
            sheet.Place(new ToneMappedRows(outcome.Film, writing.ToneMap, writing.Exposure), cell.Column, cell.Row, cell.Block);
            films.Add((cell, outcome.Hash));
            outcome.WarnOfClamped(streams);
            if (!result.GetValue(_quiet))
            {
                streams.Error.WriteLine($"{films.Count} of {axes.Cells.Count()}: {string.Join(' ', axes.Changes(cell).Select(s => s.Text))}, {outcome.Seconds:F2} s");
            }
        }

        stages.End("pictures");
        IReadOnlyList<string> written = sheet is null ? [] : JobFiles.Write(outputs, sheet.Picture, writing with { Exposure = 0, ToneMap = ToneMap.Clamp, Metadata = PictureTexts.Of(CommandLine.Text(result), path) }, streams);
        stages.EndWrite();
        Report(result, axes, films, written, streams);
        return signals.Status != 0 ? signals.Status : failed != ExitStatus.Fine ? failed : written.Count < outputs.Count ? ExitStatus.InputOutput : ExitStatus.Fine;
    }

    private static string OtherSize(int width, int height, int otherWidth, int otherHeight) =>
        $"pictures of {width}×{height} and of {otherWidth}×{otherHeight} pixels do not fit one grid: give --width and --height";

    private static ContactSheet Sheet(SweepAxes axes, Film film)
    {
        try
        {
            return new(axes.Columns, axes.Rows, axes.Blocks, film.Width, film.Height);
        }
        catch (ArgumentException e)
        {
            throw new CommandException(ExitStatus.Usage, $"{e.Message}: give a smaller --cell, or fewer values");
        }
    }

    private SceneDescription Fit(SceneDescription scene, ParseResult result)
    {
        int width = (int)(_cell.Value(result) ?? Math.Min(StandardCell, scene.Render.Width));
        return scene with
        {
            Render = scene.Render with { Width = width, Height = Math.Max(1, (int)Math.Round((double)scene.Render.Height * width / scene.Render.Width)) },
        };
    }

    private void Report(ParseResult result, SweepAxes axes, List<(SweepCell Cell, string Hash)> films, IReadOnlyList<string> written, Streams streams)
    {
        if (result.GetValue(_json))
        {
            JsonText.Write(streams, Json(axes, films, written));
        }
        else if (!result.GetValue(_quiet))
        {
            foreach (string file in written)
            {
                streams.Output.WriteLine($"wrote {file}");
            }
        }
    }

    private static JsonObject Json(SweepAxes axes, List<(SweepCell Cell, string Hash)> films, IReadOnlyList<string> written) => new()
    {
        ["films"] = JsonText.List(films.Select(f => new JsonObject
        {
            ["settings"] = new JsonObject(axes.Changes(f.Cell).Select(s => KeyValuePair.Create(s.Path, (JsonNode?)s.Value))),
            ["filmHash"] = f.Hash,
        })),
        ["outputs"] = JsonText.List(written),
    };
}
