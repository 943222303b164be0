using RayTracer.Rendering;

namespace RayTracer.SamplePlugin;

/// <summary>One over the distance along the camera ray; 0 where nothing is met.</summary>
public sealed record NearnessImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "nearness";

    /// <inheritdoc/>
    public override string Title => "Nearness";

    /// <inheritdoc/>
    public override string Description => "One over the distance from the eye.";

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) => values[0] = 1 / (double)hit.Distance;

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => $"0 (black) to {Text(range.Most)} (white)";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) => Grey(range.Most > 0 ? values[0] / range.Most : 0);
}
