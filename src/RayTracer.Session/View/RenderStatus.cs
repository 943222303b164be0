namespace RayTracer.Session;

/// <summary>The progress of the picture.</summary>
/// <param name="Status">"idle" (there is nothing to render), "rendering", "paused", "stopped" or "done".</param>
/// <param name="Width">The width of the picture.</param>
/// <param name="Height">The height of the picture.</param>
/// <param name="Samples">The number of samples in every pixel.</param>
/// <param name="SamplesTotal">The number of samples that every pixel gets.</param>
/// <param name="RaysPerSecond">The rays per second of rendering, without previews.</param>
/// <param name="Seconds">The seconds spent on rendering, without previews.</param>
/// <param name="SecondsLeft">The seconds until the last sample, by what the others took; null where that is not known.</param>
/// <param name="Noise">
/// The standard error of the pixels' luminance, mean over the pixels, relative to their mean luminance; null below two samples.
/// </param>
/// <param name="IsPreview">True where some pixels have less than a sample.</param>
/// <param name="BadSamples">The number of samples that were not finite, and left out.</param>
/// <param name="Legend">The meaning of the colours where a map is shown; null for light.</param>
public sealed record RenderStatus(
    string Status = "idle", int Width = 0, int Height = 0, int Samples = 0, int SamplesTotal = 0, double RaysPerSecond = 0, double Seconds = 0,
    double? SecondsLeft = null, double? Noise = null, bool IsPreview = false, long BadSamples = 0, string? Legend = null);
