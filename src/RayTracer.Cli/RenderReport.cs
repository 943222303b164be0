using System.Text.Json;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>What <c>render</c> prints when it is done.</summary>
/// <param name="job">What was asked for.</param>
/// <param name="result">What it came to.</param>
/// <param name="display">What is reported.</param>
/// <param name="stages">How long its stages took.</param>
/// <param name="totalSeconds">How long everything took.</param>
internal sealed class RenderReport(RenderJob job, JobResult result, Display display, StageTimes stages, double totalSeconds)
{
    private readonly RenderStatistics _statistics = result.Statistics;
    private readonly RenderDescription _render = result.Scene.Render;

    /// <summary>Prints the summary or the JSON object, and the warnings.</summary>
    public void Write(Streams streams)
    {
        if (display.Json)
        {
            WriteJson(streams);
        }
        else if (!display.Quiet)
        {
            WriteSummary(streams.Output);
        }

        if (result.Plan?.Error > job.Noise)
        {
            streams.Warn($"the wanted noise of {100 * job.Noise:G3} % would take more samples than allowed (--spp); the estimate is {100 * result.Plan.Error:G3} %");
        }

        WarnOfBadSamples(streams);
        result.WarnOfClamped(streams);
        if (job.Time is not null && !(result.Plan?.Error > job.Noise) && result.IsNoisy(job))
        {
            streams.Warn($"time ran out before the wanted noise was reached: there are {result.MeanSamples:F0} of {result.Header!.Wanted.Count} samples");
        }

        if (_statistics.Cancelled)
        {
            string files = result.Files.Count > 0 ? $"the image so far is in {string.Join(" and ", result.Files)}" : "no image was written";
            string frame = job.IsOfSequence ? $"frame {job.Frame} was " : "";
            streams.Warn($"{frame}stopped after {_statistics.Paths} paths; {files}");
        }
    }

    private void WarnOfBadSamples(Streams streams)
    {
        if (_statistics.NonFiniteSamples == 0)
        {
            return;
        }

        streams.Warn($"{_statistics.NonFiniteSamples} samples were not finite and were discarded; to trace them again:");
        foreach (BadSample bad in _statistics.BadSamples)
        {
            streams.Error.WriteLine($"  {job.ReplayCommand(bad)}");
        }
    }

    private void WriteSummary(TextWriter output)
    {
        string threads = result.Threads == 1 ? "1 thread" : $"{result.Threads} threads";
        output.WriteLine($"{job.Scene}: {_render.Width}×{_render.Height} pixels, {result.SamplesText} samples each, {threads}");
        output.WriteLine($"{_statistics.Paths:N0} paths and {_statistics.Rays:N0} rays in {result.Seconds:F2} s, {result.RaysPerSecond / 1e6:F1} M rays/s; {totalSeconds:F2} s in all");
        if (result.Plan is { } plan)
        {
            output.WriteLine($"estimated relative error {100 * plan.Error:G3} %, decided with {plan.Statistics.Paths:N0} of these paths");
        }

        if (result.Header is { IsComplete: false } header && !_statistics.Cancelled)
        {
            string film = (job.Checkpoint ?? result.Files.FirstOrDefault(FilmFile.IsNamed)) is { } file ? $": \"raytracer resume {file}\" continues it" : "";
            output.WriteLine($"time ran out at {header.Samples.Sum(r => r.Count)} of {header.Wanted.Count} samples{film}");
        }

        output.WriteLine($"film {result.Hash}");
        foreach (string path in result.Files)
        {
            output.WriteLine($"wrote {path}");
        }
    }

    private void WriteJson(Streams streams) => JsonText.Write(streams, json =>
    {
        json.WriteNumber("width", _render.Width);
        json.WriteNumber("height", _render.Height);
        json.WriteNumber("samplesPerPixel", result.MeanSamples);
        WriteNoise(json);
        json.WriteNumber("threads", result.Threads);
        json.WriteNumber("loadSeconds", stages.Load);
        json.WriteNumber("buildSeconds", stages.Build);
        json.WriteNumber("renderSeconds", result.Seconds);
        json.WriteNumber("writeSeconds", stages.Write);
        json.WriteNumber("totalSeconds", totalSeconds);
        if (StageTimes.PeakMemory is { } bytes)
        {
            json.WriteNumber("peakMemoryBytes", bytes);
        }

        json.WriteNumber("paths", _statistics.Paths);
        json.WriteNumber("closestHitRays", _statistics.ClosestHitRays);
        json.WriteNumber("shadowRays", _statistics.ShadowRays);
        json.WriteNumber("raysPerSecond", result.RaysPerSecond);
        json.WriteString("filmHash", result.Hash);
        if (result.Header is { } header)
        {
            json.WriteString("samples", header.SamplesText);
            json.WriteBoolean("complete", header.IsComplete);
        }

        if (result.Checkpoints is { } checkpoints)
        {
            json.WriteNumber("checkpoints", checkpoints.Count);
            json.WriteNumber("checkpointSeconds", checkpoints.Spent.TotalSeconds);
        }

        json.WriteNumber("nonFiniteSamples", _statistics.NonFiniteSamples);
        json.WriteBoolean("cancelled", _statistics.Cancelled);
        json.WriteStartArray("outputs");
        foreach (string path in result.Files)
        {
            json.WriteStringValue(path);
        }

        json.WriteEndArray();
    });

    private void WriteNoise(Utf8JsonWriter json)
    {
        if (result.Plan is not { } plan)
        {
            return;
        }

        json.WriteNumber("fewestSamples", plan.Fewest);
        json.WriteNumber("mostSamples", plan.Most);
        json.WriteNumber("estimatedError", plan.Error);
        json.WriteNumber("decidingPaths", plan.Statistics.Paths);
        if (job.Noise is { } wanted)
        {
            json.WriteNumber("wantedError", wanted);
            json.WriteBoolean("reached", plan.Error <= wanted);
        }
    }
}
