using RayTracer.Jobs;

namespace RayTracer.Cli.Reproduce;

/// <summary>One timed rendering.</summary>
/// <param name="Scene">What was rendered.</param>
/// <param name="Size">Width and height in pixels.</param>
/// <param name="SamplesPerPixel">Samples a pixel.</param>
/// <param name="Threads">On how many threads.</param>
/// <param name="Seconds">How long it took, without loading and writing.</param>
/// <param name="Rays">Rays traced, shadow rays among them.</param>
internal sealed record Measurement(ReportScene Scene, int Size, int SamplesPerPixel, int Threads, double Seconds, long Rays)
{
    /// <summary>Seconds a light path.</summary>
    public double SecondsPerPath => Seconds / ((double)Size * Size * SamplesPerPixel);

    /// <summary>Rays a second.</summary>
    public double RaysPerSecond => Rays / Seconds;
}
