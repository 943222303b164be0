using System.Diagnostics;
using System.Text.Json.Nodes;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>Carries out a job of several frames for a command.</summary>
/// <param name="job">The job.</param>
/// <param name="display">The user's choice of what is reported.</param>
/// <param name="streams">The streams to write to.</param>
internal sealed class ConsoleFrames(RenderJob job, Display display, Streams streams)
{
    /// <summary>Renders all that is missing.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public int Run()
    {
        Stopwatch total = Stopwatch.StartNew();
        int status = ExitStatus.Fine;
        ConsoleRun watch = new(display with { Quiet = true, Json = false }, streams);
        FrameRun frames = new(job, watch);
        bool isWhole = frames.Run(
            (one, run) =>
            {
                using StopSignals signals = new(streams);
                (int ended, JobResult? result) = watch.Run(one, run, () => signals.Status, signals.Token);
                status = Math.Max(status, ended);
                if (ended == ExitStatus.Scene)
                {
                    streams.Fail($"these errors are at frame {one.Frame}");
                }

                return (result, ended is ExitStatus.Fine or ExitStatus.Noisy);
            },
            frame =>
            {
                status = frame.IsNoisy ? Math.Max(status, ExitStatus.Noisy) : status;
                Say($"frame {frame.Number} ({frame.Which}): "
                    + (frame.Result is { } result ? $"{result.Seconds:F2} s{string.Concat(frame.Files.Select(w => $", {w}"))}" : "exists already"));
            });
        foreach (string path in frames.Animations)
        {
            Say($"wrote {path}, {frames.Done.Count} frames");
        }

        if (display.Json)
        {
            JsonText.Write(streams, Json(frames, total.Elapsed.TotalSeconds));
        }

        return isWhole || status is not (ExitStatus.Fine or ExitStatus.Noisy) ? status : ExitStatus.InputOutput;
    }

    private void Say(string line)
    {
        if (!display.Quiet && !display.Json)
        {
            streams.Output.WriteLine(line);
        }
    }

    private static JsonObject Json(FrameRun frames, double seconds) => new()
    {
        ["frames"] = JsonText.List(frames.Done.Select(Json)),
        ["outputs"] = JsonText.List(frames.Animations),
        ["totalSeconds"] = seconds,
    };

    private static JsonObject Json(RenderedFrame frame)
    {
        JsonObject json = new() { ["frame"] = frame.Number, ["rendered"] = frame.Result is not null };
        if (frame.Result is { } result)
        {
            json["renderSeconds"] = result.Seconds;
            json["filmHash"] = result.Hash;
        }

        json["outputs"] = JsonText.List(frame.Files);
        return json;
    }
}
