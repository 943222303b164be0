using System.CommandLine;
using System.Diagnostics;
using System.Text.Json.Nodes;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary><c>raytracer bench --stages</c>: renders each scene on one thread, and prints what share of the time each stage takes.</summary>
internal sealed class StageBench
{
    private readonly Option<bool> _stages = new("--stages")
    {
        Description = "Renders each scene on one thread, and prints the share of the time that each stage takes: new paths, nearest hits, sorting, shading …",
    };

    /// <summary>Gives a command the option.</summary>
    public StageBench(Command command) => command.Options.Add(_stages);

    /// <summary>Returns whether stages are measured.</summary>
    public bool IsWanted(ParseResult result) => result.GetValue(_stages);

    /// <summary>Measures.</summary>
    /// <param name="scenes">The scene files.</param>
    /// <param name="settings">Values to put in the place of the scenes'.</param>
    /// <param name="isJson">True if a JSON object is printed.</param>
    /// <param name="streams">The streams to write to.</param>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public static int Run(IReadOnlyList<string> scenes, IReadOnlyList<SceneSetting> settings, bool isJson, Streams streams)
    {
        StageClock clock = new();
        List<JsonObject> all = [];
        foreach (string path in scenes)
        {
            SceneLoadResult loaded = SceneFile.Load(path, new(null), settings: settings);
            streams.Read(loaded.Diagnostics);
            if (loaded.Scene is not { } scene || loaded.Description is not { } description)
            {
                return SceneFile.FailureStatus(path);
            }

            double seconds = Render(scene, null);
            scene = scene.WithView(description.Camera, scene.Render with { Sampler = clock.Timed(scene.Render.Sampler) }, new())!;
            double clocked = Render(scene, clock);
            IReadOnlyDictionary<Stage, double> times = clock.Seconds(seconds);
            if (isJson)
            {
                JsonObject stages = [];
                foreach ((Stage stage, double time) in times)
                {
                    stages[Name(stage)] = time;
                }

                all.Add(new() { ["scene"] = path, ["seconds"] = seconds, ["clockedSeconds"] = clocked, ["stages"] = stages });
            }
            else
            {
                streams.Output.WriteLine($"{path}: {seconds:F2} s on one thread, {clocked:F2} s with the clock");
                foreach ((Stage stage, double time) in times.OrderByDescending(t => t.Value))
                {
                    streams.Output.WriteLine($"  {Name(stage),-12}{time,8:F2} s{100 * time / seconds,7:F1} %");
                }
            }
        }

        if (isJson)
        {
            JsonText.Write(streams, new() { ["scenes"] = JsonText.List(all) });
        }

        return ExitStatus.Fine;
    }

    private static string Name(Stage stage) => $"{stage}".ToLowerInvariant();

    // Once more after all code is compiled.
    private static double Render(Scene scene, StageClock? clock)
    {
        double seconds = 0;
        for (int i = 0; i < 2; i++)
        {
            Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator));
            clock?.Start();
            long start = Stopwatch.GetTimestamp();
            new RTracer(scene, new() { Threads = 1, Clock = clock }).Render(film);
            clock?.Enter(Stage.Rest);
            seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        }

        return seconds;
    }
}
