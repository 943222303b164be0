using System.Text.Json;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>What <c>render</c> prints when it is done.</summary>
/// <param name="request">What was asked for.</param>
/// <param name="outcome">What it came to.</param>
/// <param name="written">The files that were written.</param>
/// <param name="stages">How long its stages took.</param>
/// <param name="totalSeconds">How long everything took.</param>
internal sealed class RenderReport(RenderRequest request, RenderOutcome outcome, IReadOnlyList<string> written, StageTimes stages, double totalSeconds)
{
    private readonly RenderStatistics _statistics = outcome.Statistics;
    private readonly RenderDescription _render = outcome.Scene.Render;

    /// <summary>Prints the summary or the JSON object, and the warnings.</summary>
    public void Write(Streams streams)
    {
        if (request.Json)
        {
            WriteJson(streams);
        }
        else if (!request.Quiet)
        {
            WriteSummary(streams.Output);
        }

        if (outcome.Plan?.Error > request.Noise)
        {
            streams.Warn($"the wanted noise of {100 * request.Noise:G3} % would take more samples than allowed (--spp); the estimate is {100 * outcome.Plan.Error:G3} %");
        }

        WarnOfBadSamples(streams);
        WarnOfClamped(_statistics, streams);
        if (request.Time is not null && !(outcome.Plan?.Error > request.Noise) && outcome.IsNoisy(request))
        {
            streams.Warn($"time ran out before the wanted noise was reached: there are {outcome.MeanSamples:F0} of {outcome.Header!.Wanted.Count} samples");
        }

        if (_statistics.Cancelled)
        {
            string files = written.Count > 0 ? $"the image so far is in {string.Join(" and ", written)}" : "no image was written";
            string frame = request.IsOfSequence ? $"frame {request.Frame} was " : "";
            streams.Warn($"{frame}stopped after {_statistics.Paths} paths; {files}");
        }
    }

    /// <summary>Warns of samples that were made smaller.</summary>
    public static void WarnOfClamped(RenderStatistics statistics, Streams streams)
    {
        if (statistics.ClampedSamples > 0)
        {
            streams.Warn($"{statistics.ClampedSamples} samples were clamped at ±{Film.SampleLimit}: the picture is too dark there");
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
            streams.Error.WriteLine($"  {request.ReplayCommand(bad)}");
        }
    }

    private void WriteSummary(TextWriter output)
    {
        string threads = outcome.Threads == 1 ? "1 thread" : $"{outcome.Threads} threads";
        output.WriteLine($"{request.ScenePath}: {_render.Width}×{_render.Height} pixels, {outcome.SamplesText} samples each, {threads}");
        output.WriteLine($"{_statistics.Paths:N0} paths and {_statistics.Rays:N0} rays in {outcome.Seconds:F2} s, {outcome.RaysPerSecond / 1e6:F1} M rays/s; {totalSeconds:F2} s in all");
        if (outcome.Plan is { } plan)
        {
            output.WriteLine($"estimated relative error {100 * plan.Error:G3} %, decided with {plan.Statistics.Paths:N0} of these paths");
        }

        if (outcome.Header is { IsComplete: false } header && !_statistics.Cancelled)
        {
            string film = (request.Checkpoint ?? written.FirstOrDefault(FilmFile.IsNamed)) is { } file ? $": \"raytracer resume {file}\" continues it" : "";
            output.WriteLine($"time ran out at {header.Samples.Sum(r => r.Count)} of {header.Wanted.Count} samples{film}");
        }

        output.WriteLine($"film {outcome.Hash}");
        foreach (string path in written)
        {
            output.WriteLine($"wrote {path}");
        }
    }

    private void WriteJson(Streams streams) => JsonText.Write(streams, json =>
    {
        json.WriteNumber("width", _render.Width);
        json.WriteNumber("height", _render.Height);
        json.WriteNumber("samplesPerPixel", outcome.MeanSamples);
        WriteNoise(json);
        json.WriteNumber("threads", outcome.Threads);
        json.WriteNumber("loadSeconds", stages.Load);
        json.WriteNumber("buildSeconds", stages.Build);
        json.WriteNumber("renderSeconds", outcome.Seconds);
        json.WriteNumber("writeSeconds", stages.Write);
        json.WriteNumber("totalSeconds", totalSeconds);
        if (StageTimes.PeakMemory is { } bytes)
        {
            json.WriteNumber("peakMemoryBytes", bytes);
        }

        json.WriteNumber("paths", _statistics.Paths);
        json.WriteNumber("closestHitRays", _statistics.ClosestHitRays);
        json.WriteNumber("shadowRays", _statistics.ShadowRays);
        json.WriteNumber("raysPerSecond", outcome.RaysPerSecond);
        json.WriteString("filmHash", outcome.Hash);
        if (outcome.Header is { } header)
        {
            json.WriteString("samples", header.SamplesText);
            json.WriteBoolean("complete", header.IsComplete);
        }

        if (outcome.Checkpoints is { } checkpoints)
        {
            json.WriteNumber("checkpoints", checkpoints.Count);
            json.WriteNumber("checkpointSeconds", checkpoints.Spent.TotalSeconds);
        }

        json.WriteNumber("nonFiniteSamples", _statistics.NonFiniteSamples);
        json.WriteBoolean("cancelled", _statistics.Cancelled);
        json.WriteStartArray("outputs");
        foreach (string path in written)
        {
            json.WriteStringValue(path);
        }

        json.WriteEndArray();
    });

    private void WriteNoise(Utf8JsonWriter json)
    {
        if (outcome.Plan is not { } plan)
        {
            return;
        }

        json.WriteNumber("fewestSamples", plan.Fewest);
        json.WriteNumber("mostSamples", plan.Most);
        json.WriteNumber("estimatedError", plan.Error);
        json.WriteNumber("decidingPaths", plan.Statistics.Paths);
        if (request.Noise is { } wanted)
        {
            json.WriteNumber("wantedError", wanted);
            json.WriteBoolean("reached", plan.Error <= wanted);
        }
    }
}
