using System.CommandLine;
using System.Diagnostics;
using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Study;

namespace RayTracer.Cli;

/// <summary><c>raytracer bench [SCENE…]</c></summary>
internal static class BenchVerb
{
    private sealed record Measurement(string Path, Scene Scene, int Threads, double Seconds, long Rays)
    {
        public double RaysPerSecond => Rays / Seconds;
    }

    public static void Build(Command command, Streams streams)
    {
        Argument<string[]> scenes = new("SCENE")
        {
            Description = $"Scene files; without any, those of {ReportScenes.Folder}, and the Cornell box.",
            Arity = ArgumentArity.ZeroOrMore,
        };
        ParsedOption<long?> repeat = OptionValues.Integer("--repeat", "How often each scene is rendered; the best counts. 3 without it.", 1, 1000);
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.Arguments.Add(scenes);
        command.AddOptions(repeat, json);
        IntegratorBench integrators = new(command);
        BenchAgainst builds = new(command);
        StageBench profile = new(command);
        JobOptionSet settings = new(command, [JobOptions.Find("--spp")!, JobOptions.Set]);
        VerboseOption verbose = new(command);
        command.SetAction(result =>
        {
            (string[] paths, IReadOnlyList<SceneSetting> given, StageTimes stages) = (result.GetValue(scenes)!, settings.Given(result).Settings, verbose.Times(result, streams));
            if (profile.IsWanted(result))
            {
                return builds.IsWanted(result) || integrators.IsWanted(result, repeat) || repeat.Value(result) is not null
                    ? throw new CommandException(ExitStatus.Usage, "--stages does not go with --against, --integrators or --repeat")
                    : StageBench.Run(Scenes(paths), given, result.GetValue(json), streams);
            }

            return builds.IsWanted(result) ? builds.Run(result, Scenes(paths), given, result.GetValue(json), streams)
                : integrators.IsWanted(result, repeat) ? integrators.Run(result, paths, given, result.GetValue(json), stages, streams)
                : Run(paths, given, (int)(repeat.Value(result) ?? 3), result.GetValue(json), stages, streams);
        });
    }

    private static int Run(string[] scenes, IReadOnlyList<SceneSetting> settings, int repeat, bool json, StageTimes stages, Streams streams)
    {
        IReadOnlyList<string> paths = Scenes(scenes);
        List<Measurement> all = [];
        if (!json)
        {
            streams.Output.WriteLine(
                $"{"M rays/s",-32}{"1 thread",12}{$"{Environment.ProcessorCount} threads",12}{"ratio",8}   ({Vector<float>.Count} lanes)");
        }

        foreach (string path in paths)
        {
            SceneLoadResult loaded = SceneFile.Load(path, stages, settings: settings);
            streams.Read(loaded.Diagnostics);
            if (loaded.Scene is not { } scene)
            {
                return SceneFile.FailureStatus(path);
            }

            Measurement one = Best(path, scene, 1, repeat);
            Measurement many = Best(path, scene, Environment.ProcessorCount, repeat);
            stages.End(JobStage.Render);
            all.AddRange(one, many);
            if (!json)
            {
                double ratio = many.RaysPerSecond / one.RaysPerSecond;
                streams.Output.WriteLine($"{path,-32}{one.RaysPerSecond / 1e6,12:F1}{many.RaysPerSecond / 1e6,12:F1}{ratio,8:F2}");
            }
        }

        if (json)
        {
            JsonText.Write(streams, Json(all));
        }

        stages.EndAll();
        return ExitStatus.Fine;
    }

    private static IReadOnlyList<string> Scenes(string[] given) => given.Length > 0 ? given : ReportScenes.FindMeasured();

    private static Measurement Best(string path, Scene scene, int threads, int repeat)
    {
        RTracer tracer = new(scene, new() { Threads = threads });
        Measurement? best = null;
        for (int i = 0; i < repeat; i++)
        {
            Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator));
            long start = Stopwatch.GetTimestamp();
            RenderStatistics statistics = tracer.Render(film);
            double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
            best = best is null || seconds < best.Seconds ? new(path, scene, threads, seconds, statistics.Rays) : best;
        }

        return best!;
    }

    private static JsonObject Json(IEnumerable<Measurement> measurements) => new()
    {
        ["lanes"] = Vector<float>.Count,
        ["runs"] = JsonText.List(measurements.Select(m => new JsonObject
        {
            ["scene"] = m.Path,
            ["width"] = m.Scene.Render.Width,
            ["height"] = m.Scene.Render.Height,
            ["samplesPerPixel"] = m.Scene.Render.SamplesPerPixel,
            ["threads"] = m.Threads,
            ["renderSeconds"] = m.Seconds,
            ["rays"] = m.Rays,
            ["raysPerSecond"] = m.RaysPerSecond,
        })),
    };
}
