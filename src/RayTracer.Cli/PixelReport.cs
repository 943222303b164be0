using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>What <c>render --pixel</c> prints.</summary>
internal static class PixelReport
{
    public static void Write(RenderJob job, JobResult result, bool json, Streams streams)
    {
        (int x, int y) = job.Pixel!.Value;
        Rgb mean = result.Film.Mean(x, y);
        uint count = result.Film.SampleCount(x, y);
        if (json)
        {
            WriteJson(job, result, mean, streams);
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

    // Floats are written with as many digits as tell them from every other float.
    private static string Text(Rgb color) => $"radiance {color.R} {color.G} {color.B}, luminance {color.Luminance}";

    private static void WriteJson(RenderJob job, JobResult result, Rgb mean, Streams streams) => JsonText.Write(streams, json =>
    {
        json.WriteNumber("x", job.Pixel!.Value.X);
        json.WriteNumber("y", job.Pixel.Value.Y);
        if (job.Sample is { } sample)
        {
            json.WriteNumber("sample", sample);
        }

        json.WriteNumber("samples", result.Film.TotalSamples);
        json.WriteStartArray("radiance");
        json.WriteNumberValue(mean.R);
        json.WriteNumberValue(mean.G);
        json.WriteNumberValue(mean.B);
        json.WriteEndArray();
        json.WriteNumber("luminance", mean.Luminance);
        json.WriteNumber("nonFiniteSamples", result.Statistics.NonFiniteSamples);
    });
}
