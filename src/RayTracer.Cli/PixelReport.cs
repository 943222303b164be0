using System.Text.Json.Nodes;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>The report that <c>render --pixel</c> prints.</summary>
internal static class PixelReport
{
    public static void Write(RenderJob job, JobResult result, bool json, Streams streams)
    {
        (int x, int y) = job.Pixel!.Value;
        Rgb mean = result.Film.Mean(x, y);
        uint count = result.Film.SampleCount(x, y);
        if (json)
        {
            JsonText.Write(streams, Json(job, result, mean));
        }
        else if (count > 0)
        {
            string what = job.Sample is { } sample ? $"sample {sample}" : $"mean of {count} samples";
            streams.Output.WriteLine($"pixel {x},{y}, {what}: {Text(mean)}");
        }

        foreach (BadSample bad in result.Statistics.BadSamples)
        {
            streams.Error.WriteLine($"pixel {x},{y}, sample {bad.Sample}: {Text(bad.Value)}, not finite and discarded");
        }

        result.WarnOfClamped(streams);
    }

    // Floats are written with as many digits as distinguish them from every other float.
    private static string Text(Rgb color) => $"radiance {color.R} {color.G} {color.B}, luminance {color.Luminance}";

    private static JsonObject Json(RenderJob job, JobResult result, Rgb mean)
    {
        JsonObject json = new() { ["x"] = job.Pixel!.Value.X, ["y"] = job.Pixel.Value.Y };
        if (job.Sample is { } sample)
        {
            json["sample"] = sample;
        }

        json["samples"] = result.Film.TotalSamples;
        json["radiance"] = new JsonArray(mean.R, mean.G, mean.B);
        json["luminance"] = mean.Luminance;
        json["nonFiniteSamples"] = result.Statistics.NonFiniteSamples;
        return json;
    }
}
