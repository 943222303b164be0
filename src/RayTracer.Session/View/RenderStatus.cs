using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>The progress of the picture.</summary>
public sealed record RenderStatus
{
    /// <summary>"idle" (there is nothing to render), "rendering", "paused", "stopped" or "done".</summary>
    public string Status { get; init; } = "idle";

    /// <summary>Width of the picture.</summary>
    public int Width { get; init; }

    /// <summary>Height of the picture.</summary>
    public int Height { get; init; }

    /// <summary>Samples in every pixel.</summary>
    public int Samples { get; init; }

    /// <summary>Samples that every pixel gets.</summary>
    public int SamplesTotal { get; init; }

    /// <summary>Rays a second, while rendering; previews are left out.</summary>
    public double RaysPerSecond { get; init; }

    /// <summary>Seconds spent on rendering; previews are left out.</summary>
    public double Seconds { get; init; }

    /// <summary>Seconds until the last sample, by what the others took; null where that is not known.</summary>
    public double? SecondsLeft { get; init; }

    /// <summary>Standard error of the pixels' luminance, mean over the pixels, relative to their mean luminance; null below two samples.</summary>
    public double? Noise { get; init; }

    /// <summary>Number of threads.</summary>
    public int Threads { get; init; }

    /// <summary>The map that is shown.</summary>
    public ViewMap Map { get; init; } = ViewMap.Light;

    /// <summary>The part that is rendered; null for all of it.</summary>
    public Tile? Region { get; init; }

    /// <summary>Returns whether there is less than a sample in each pixel.</summary>
    public bool IsPreview { get; init; }

    /// <summary>Samples that were not finite, and left out.</summary>
    public long BadSamples { get; init; }
}
