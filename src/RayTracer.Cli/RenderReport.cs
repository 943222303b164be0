using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>The report that <c>render</c> prints when it is done.</summary>
/// <param name="job">The job.</param>
/// <param name="result">Its result.</param>
/// <param name="display">The user's choice of what is reported.</param>
/// <param name="stages">The times of its stages.</param>
/// <param name="totalSeconds">The time of everything together, in seconds.</param>
internal sealed class RenderReport(RenderJob job, JobResult result, Display display, StageTimes stages, double totalSeconds)
{
    private readonly RenderStatistics _statistics = result.Statistics;
    private readonly RenderDescription _render = result.Scene.Render;

    /// <summary>Prints the summary or the JSON object, and the warnings.</summary>
    public void Write(Streams streams)
    {
        if (display.Json)
        {
            JsonText.Write(streams, Json());
        }
        else if (!display.Quiet)
        {
            WriteSummary(streams.Output);
            streams.Wrote(result.Files);
            if (result.Denoised is not null && result.IsWritten)
            {
                streams.Output.WriteLine($"the denoised picture is {string.Join(" and ", new PictureFiles(job).Denoised)}");
            }
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

    /// <summary>Says what a denoised picture lacks.</summary>
    public static string Cut(DenoiseResult denoised) => $"denoised; {100 * denoised.CutShare:G2} % of the light stood out of one half of the samples, and was cut";

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
        (string rays, string speed) = Edition.For(job.Edition, _render) is not { } edition ? ($" and {_statistics.Rays:N0} rays", $", {result.RaysPerSecond / 1e6:F1} M rays/s") : ("", $", {edition} edition");
        output.WriteLine($"{_statistics.Paths:N0} paths{rays} in {result.Seconds:F2} s{speed}; {totalSeconds:F2} s in all");
        if (result.Plan is { } plan)
        {
            output.WriteLine($"the noise is about {100 * plan.Error:G3} % of the picture's brightness; {plan.Statistics.Paths:N0} of these paths were rendered to estimate that");
        }

        if (result.Guide is { } guide)
        {
            output.WriteLine(guide.Paths > 0 ? $"guided by what {guide.Paths:N0} other paths learned in {guide.Seconds:F2} s" : $"guided by {job.GuideFile}");
        }

        if (result.Header is { IsComplete: false } header && !_statistics.Cancelled)
        {
            string film = (job.Checkpoint ?? result.Files.FirstOrDefault(FilmFile.IsNamed)) is { } file
                ? $": \"raytracer resume {file}\" continues it" : "";
            output.WriteLine($"time ran out at {header.Samples.Sum(r => r.Count)} of {header.Wanted.Count} samples{film}");
        }

        if (display.Verbose && result.Denoised is { } denoised)
        {
            output.WriteLine(Cut(denoised));
        }

        output.WriteLine($"film {result.Hash}");
    }

    private JsonObject Json()
    {
        JsonObject json = new() { ["width"] = _render.Width, ["height"] = _render.Height, ["samplesPerPixel"] = result.MeanSamples };
        AddNoise(json);
        if (result.Guide is { } guide)
        {
            json["guideHash"] = guide.Hash;
            json["learningPaths"] = guide.Paths;
            json["learningSeconds"] = guide.Seconds;
        }

        json["threads"] = result.Threads;
        json["lanes"] = FloatW.Count;
        json["loadSeconds"] = stages[JobStage.Load];
        json["buildSeconds"] = stages[JobStage.Build];
        json["renderSeconds"] = result.Seconds;
        if (result.Denoised is { } denoised)
        {
            json["denoiseSeconds"] = stages[JobStage.Denoise];
            json["cutShare"] = denoised.CutShare;
        }

        json["writeSeconds"] = stages[JobStage.Write];
        json["totalSeconds"] = totalSeconds;
        if (StageTimes.PeakMemory is { } bytes)
        {
            json["peakMemoryBytes"] = bytes;
        }

        json["paths"] = _statistics.Paths;
        json["closestHitRays"] = _statistics.ClosestHitRays;
        json["shadowRays"] = _statistics.ShadowRays;
        json["raysPerSecond"] = result.RaysPerSecond;
        json["filmHash"] = result.Hash;
        if (result.Header is { } header)
        {
            json["samples"] = header.SamplesText;
            json["complete"] = header.IsComplete;
        }

        if (result.Checkpoints is { } checkpoints)
        {
            json["checkpoints"] = checkpoints.Count;
            json["checkpointSeconds"] = checkpoints.Spent.TotalSeconds;
        }

        json["nonFiniteSamples"] = _statistics.NonFiniteSamples;
        json["cancelled"] = _statistics.Cancelled;
        json["outputs"] = JsonText.List(result.Files);
        return json;
    }

    private void AddNoise(JsonObject json)
    {
        if (result.Plan is not { } plan)
        {
            return;
        }

        json["fewestSamples"] = plan.Fewest;
        json["mostSamples"] = plan.Most;
        json["estimatedError"] = plan.Error;
        json["decidingPaths"] = plan.Statistics.Paths;
        if (job.Noise is { } wanted)
        {
            json["wantedError"] = wanted;
            json["reached"] = plan.Error <= wanted;
        }
    }
}
