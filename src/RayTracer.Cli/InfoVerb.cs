using System.CommandLine;
using System.Diagnostics;
using System.Text.Json.Nodes;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;
using JsonNode = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Cli;

/// <summary>
/// <c>raytracer info FILE</c>, of a scene or model here, of a film in <see cref="FilmInfo"/>, of a picture in <see cref="ImageInfo"/>.
/// </summary>
internal static class InfoVerb
{
    private const int MostTrees = 6;

    public static void Build(Command command, Streams streams)
    {
        Argument<string> file = new("FILE") { Description = "The file: a scene, a model, a film (.rtfilm) or an image." };
        Option<bool> hash = new("--hash") { Description = "For a film: reads all of it and prints its hash, or what is damaged." };
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.Arguments.Add(file);
        command.AddOptions(hash, json);
        JobOptionSet settings = new(command, [JobOptions.Set]);
        VerboseOption verbose = new(command);
        command.SetAction(result =>
        {
            string path = result.GetValue(file)!;
            ImageFormat? format = ImageFile.FormatOf(path);
            bool isFilm = format is FilmFormat || FilmFile.IsNamed(path);
            bool isImage = !isFilm && (format ?? ImageFormat.OfName(path)) is not null;
            if ((isFilm || isImage) && settings.Given(result).Settings is [var setting, ..])
            {
                throw new CommandException(ExitStatus.Usage, $"--set {setting.Text}: films and images have no settings");
            }

            if (result.GetValue(hash) && !isFilm && !FilmExr.Is(path))
            {
                throw new CommandException(
                    ExitStatus.Usage, "--hash is for films (.rtfilm); an image states its film's hash in its text, if it has one");
            }

            StageTimes stages = verbose.Times(result, streams);
            int status = ExitStatus.Fine;
            if (isFilm)
            {
                FilmInfo.Show(path, result.GetValue(hash), result.GetValue(json), streams);
                stages.End(JobStage.Load);
            }
            else if (isImage)
            {
                ImageInfo.Show(path, result.GetValue(hash), result.GetValue(json), streams);
                stages.End(JobStage.Load);
            }
            else
            {
                status = Show(path, settings.Given(result).Settings, result.GetValue(json), stages, streams);
            }

            stages.EndAll();
            return status;
        });
    }

    private static int Show(string path, IReadOnlyList<SceneSetting> settings, bool json, StageTimes stages, Streams streams)
    {
        Dictionary<string, long> pictures = [];
        SceneLoadResult result = SceneFile.Load(path, stages, readPicture: (file, raw) =>
        {
            Picture picture = ImageFile.Read(file, raw);
            pictures[file] = sizeof(float) * picture.Pixels.LongLength;
            return picture;
        }, settings: settings, change: ModelFile.IsModel(path) ? WithoutView : null);
        streams.Read(result.Diagnostics, isQuiet: true);
        if (result.Scene is not { } scene)
        {
            return SceneFile.FailureStatus(path);
        }

        SceneContent content = new(result.Description!);
        string folder = Path.GetDirectoryName(path) ?? "";
        long textures = content.Images.Sum(i => pictures.GetValueOrDefault(Path.Combine(folder, i.File)));
        SceneStatistics statistics = new(scene);
        if (json)
        {
            JsonText.Write(streams, Json(scene, content, statistics, textures));
        }
        else
        {
            Write(path, scene, content, statistics, textures, streams.Output);
        }

        return ExitStatus.Fine;
    }

    // The model alone, without what was made up for its picture.
    private static SceneDescription WithoutView(SceneDescription scene) => scene with { Lights = [], Shapes = [.. scene.Shapes.Take(1)] };

    private static void Write(string path, Scene scene, SceneContent content, SceneStatistics statistics, long textures, TextWriter output)
    {
        RenderDescription render = scene.Render;
        output.WriteLine(path);
        output.WriteLine($"shapes     {Counts(content.Shapes)}");
        output.WriteLine($"materials  {Counts(content.Materials)}");
        output.WriteLine($"textures   {Counts(content.Textures)}");
        output.WriteLine($"lights     {scene.Lights.Count}");
        output.WriteLine($"triangles  {statistics.Triangles:N0} in {statistics.Meshes} {(statistics.Meshes == 1 ? "mesh" : "meshes")}{(statistics.Instances > 0 ? $", {statistics.TrianglesShown:N0} shown" : "")}");
        output.WriteLine($"instances  {statistics.Instances:N0}");
        output.WriteLine(
            FiniteBounds(statistics) is { } box ? $"bounds     {Text(box.Minimum)} to {Text(box.Maximum)}" : "bounds     no finite shape");
        output.WriteLine($"picture    {render.Width}×{render.Height} pixels, {render.SamplesPerPixel} samples each ({render.Sampler.ToString().ToLowerInvariant()})");
        IntegratorAdvice advice = IntegratorAdvice.For(scene);
        output.WriteLine($"integrator {render.Integrator}; {(advice.Integrator == render.Integrator ? "it fits" : $"{advice.Integrator} fits better")}: {advice.Reason}");
        string memory = string.Join(", ", Memory(render, statistics, textures).Select(m => $"{m.Kind} {FilmMemory.Text(m.Bytes)}"));
        output.WriteLine($"memory     {memory}");
        foreach (SceneTree tree in statistics.Trees.OrderByDescending(t => t.Statistics.Primitives).Take(MostTrees))
        {
            BvhStatistics t = tree.Statistics;
            output.WriteLine($"tree       {t.Primitives:N0} {tree.Holds}: {t.Nodes:N0} nodes, {t.Leaves:N0} leaves, depth {t.Depth}, SAH cost {t.SahCost:F2}, built in {BuildSeconds(tree):F3} s");
        }

        if (statistics.Trees.Count > MostTrees)
        {
            output.WriteLine($"           and {statistics.Trees.Count - MostTrees} smaller trees");
        }
    }

    private static IEnumerable<(string Kind, long Bytes)> Memory(RenderDescription render, SceneStatistics statistics, long textures) =>
    [
        ("film", FilmMemory.Bytes(render.Width, render.Height, FilmPlane.Needed(render.Integrator))), ("textures", textures), ("shapes", statistics.ShapeBytes),
        ("triangles", statistics.TriangleBytes), ("nodes", statistics.NodeBytes), ("instances", statistics.InstanceBytes),
    ];

    // Measured by building once more: the scene does not look at the clock while it is made.
    private static double BuildSeconds(SceneTree tree)
    {
        long start = Stopwatch.GetTimestamp();
        tree.Build();
        return Stopwatch.GetElapsedTime(start).TotalSeconds;
    }

    private static string Counts(IReadOnlyDictionary<string, int> counts) => counts.Count == 0 ? "0" :
        $"{counts.Values.Sum()} ({string.Join(", ", counts.Select(c => $"{c.Value} {c.Key}"))})";

    private static string Text(System.Numerics.Vector3 v) => $"({v.X}, {v.Y}, {v.Z})";

    private static Bounds? FiniteBounds(SceneStatistics statistics) => statistics.FiniteBounds is { IsFinite: true } box ? box : null;

    private static JsonObject Json(Scene scene, SceneContent content, SceneStatistics statistics, long textures)
    {
        Bounds? box = FiniteBounds(statistics);
        JsonObject json = new()
        {
            ["kind"] = "scene",
            ["shapes"] = Json(content.Shapes),
            ["materials"] = Json(content.Materials),
            ["textures"] = Json(content.Textures),
            ["lights"] = scene.Lights.Count,
            ["boundsMinimum"] = Corner(box?.Minimum),
            ["boundsMaximum"] = Corner(box?.Maximum),
            ["width"] = scene.Render.Width,
            ["height"] = scene.Render.Height,
            ["samplesPerPixel"] = scene.Render.SamplesPerPixel,
            ["integrator"] = scene.Render.Integrator.Name,
            ["recommendedIntegrator"] = IntegratorAdvice.For(scene).Integrator.Name,
            ["recommendedBecause"] = IntegratorAdvice.For(scene).Reason,
            ["meshes"] = statistics.Meshes,
            ["triangles"] = statistics.Triangles,
            ["trianglesShown"] = statistics.TrianglesShown,
            ["instances"] = statistics.Instances,
        };
        foreach ((string kind, long bytes) in Memory(scene.Render, statistics, textures))
        {
            json[$"{kind.TrimEnd('s')}Bytes"] = bytes;
        }

        json["trees"] = JsonText.List(statistics.Trees.Select(Json));
        return json;
    }

    private static JsonObject Json(SceneTree tree) => new()
    {
        ["holds"] = tree.Holds,
        ["primitives"] = tree.Statistics.Primitives,
        ["nodes"] = tree.Statistics.Nodes,
        ["leaves"] = tree.Statistics.Leaves,
        ["depth"] = tree.Statistics.Depth,
        ["sahCost"] = tree.Statistics.SahCost,
        ["bytes"] = tree.Statistics.MemoryBytes,
        ["buildSeconds"] = BuildSeconds(tree),
    };

    private static JsonObject Json(IReadOnlyDictionary<string, int> counts) =>
        new(counts.Select(c => KeyValuePair.Create(c.Key, (JsonNode?)c.Value)));

    private static JsonArray? Corner(System.Numerics.Vector3? corner) => corner is { } point ? new(point.X, point.Y, point.Z) : null;
}
