using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>What <c>render --pixel</c> prints.</summary>
internal static class PixelReport
{
    public static void Write(RenderRequest request, RenderOutcome outcome, Streams streams)
    {
        (int x, int y) = (request.Pixel![0], request.Pixel[1]);
        Rgb mean = outcome.Film.Mean(x, y);
        uint count = outcome.Film.SampleCount(x, y);
        if (request.Json)
        {
            WriteJson(request, outcome, mean, streams);
        }
        else if (count > 0)
        {
            string what = request.Sample is { } sample ? $"sample {sample}" : $"mean of {count} samples";
            streams.Output.WriteLine($"pixel {x},{y}, {what}: {Text(mean)}");
        }

        foreach (BadSample bad in outcome.Statistics.BadSamples)
        {
            streams.Error.WriteLine($"pixel {x},{y}, sample {bad.Sample}: {Text(bad.Value)}, not finite and discarded");
        }

        RenderReport.WarnOfClamped(outcome.Statistics, streams);
    }

    // Floats are written with as many digits as tell them from every other float.
    private static string Text(Rgb color) => $"radiance {color.R} {color.G} {color.B}, luminance {color.Luminance}";

    private static void WriteJson(RenderRequest request, RenderOutcome outcome, Rgb mean, Streams streams) => JsonText.Write(streams, json =>
    {
        json.WriteNumber("x", request.Pixel![0]);
        json.WriteNumber("y", request.Pixel[1]);
        if (request.Sample is { } sample)
        {
            json.WriteNumber("sample", sample);
        }

        json.WriteNumber("samples", outcome.Film.TotalSamples);
        json.WriteStartArray("radiance");
        json.WriteNumberValue(mean.R);
        json.WriteNumberValue(mean.G);
        json.WriteNumberValue(mean.B);
        json.WriteEndArray();
        json.WriteNumber("luminance", mean.Luminance);
        json.WriteNumber("nonFiniteSamples", outcome.Statistics.NonFiniteSamples);
    });
}
