using System.Text.Json.Nodes;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

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
            foreach ((string name, Rgb weighted, Rgb? alone) in Ways(job, result))
            {
                string weight = alone is { Luminance: > 0 } whole ? $"; alone {whole.R} {whole.G} {whole.B}, weight {weighted.Luminance / whole.Luminance}" : "";
                streams.Output.WriteLine($"  {name}: radiance {weighted.R} {weighted.G} {weighted.B}{weight}");
            }
        }

        foreach (BadSample bad in result.Statistics.BadSamples)
        {
            streams.Error.WriteLine($"pixel {x},{y}, sample {bad.Sample}: {Text(bad.Value)}, not finite and discarded");
        }

        result.WarnOfClamped(streams);
    }

    // What the ways to make paths bring to the pixel, those that bring something; the light of the longest paths is not known alone.
    private static IEnumerable<(string Name, Rgb Weighted, Rgb? Alone)> Ways(RenderJob job, JobResult result)
    {
        if (result.Strategies is not { } film)
        {
            return [];
        }

        Rgb Of(string layer) => PixelOf(film.Layers.Single(l => l.Name == layer).Image, job.Pixel!.Value);
        return film.Strategies.Select(s => (s.Name, Of($"{s.Name}.weighted"), (Rgb?)Of($"{s.Name}.unweighted")))
            .Append((StrategyFilm.Longer, Of(StrategyFilm.Longer), null))
            .Where(way => way is not { Item2.IsBlack: true, Item3: null or { IsBlack: true } });
    }

    private static Rgb PixelOf(IImageRows image, (int X, int Y) pixel)
    {
        float[] row = new float[3 * image.Width];
        image.ReadRow(pixel.Y, row);
        return new(row[3 * pixel.X], row[(3 * pixel.X) + 1], row[(3 * pixel.X) + 2]);
    }

    // Floats are written with as many digits as distinguish them from every other float.
    private static string Text(Rgb color) => $"radiance {color.R} {color.G} {color.B}, luminance {color.Luminance}";

    private static JsonArray Numbers(Rgb color) => new(color.R, color.G, color.B);

    private static JsonObject Json(RenderJob job, JobResult result, Rgb mean)
    {
        JsonObject json = new() { ["x"] = job.Pixel!.Value.X, ["y"] = job.Pixel.Value.Y };
        if (job.Sample is { } sample)
        {
            json["sample"] = sample;
        }

        json["samples"] = result.Film.TotalSamples;
        json["radiance"] = Numbers(mean);
        json["luminance"] = mean.Luminance;
        if (result.Strategies is not null)
        {
            json["strategies"] = new JsonArray([.. Ways(job, result).Select(way => (JsonNode)new JsonObject
            {
                ["name"] = way.Name,
                ["weighted"] = Numbers(way.Weighted),
                ["unweighted"] = way.Alone is { } alone ? Numbers(alone) : null,
            })]);
        }

        json["nonFiniteSamples"] = result.Statistics.NonFiniteSamples;
        return json;
    }
}
