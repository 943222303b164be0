using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>How far the picture is, as pages are told.</summary>
internal sealed record RenderState(
    string Status, int Width, int Height, int Samples, int SamplesTotal, double RaysPerSecond, double Seconds, double? SecondsLeft, double? Noise,
    int Threads, int Cores, string Map, int[]? Region, RenderQuality? Quality, bool IsPreview, long BadSamples)
{
    /// <summary>That of a view, by what is known of its picture and what the user wants.</summary>
    public static RenderState Of(RenderStatus status, ViewSettings settings)
    {
        int[]? region = settings.Region is { } r ? [r.X, r.Y, r.Width, r.Height] : null;
        return new(
            status.Status, status.Width, status.Height, status.Samples, status.SamplesTotal, status.RaysPerSecond, status.Seconds, status.SecondsLeft, status.Noise,
            settings.Threads, Environment.ProcessorCount, settings.Map.Name, region, settings.Quality, status.IsPreview, status.BadSamples);
    }
}
