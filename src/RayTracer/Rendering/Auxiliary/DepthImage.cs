using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Distance along the camera ray, in scene units: mean over the samples that meet something, infinite where none does.</summary>
public sealed record DepthImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "depth";

    /// <inheritdoc/>
    public override string Title => "Depth";

    /// <inheritdoc/>
    public override string Description => "Distance from the eye: white is near, black is far.";

    /// <inheritdoc/>
    public override string Letters => "Z";

    /// <inheritdoc/>
    public override MeanOver Mean => MeanOver.Hits;

    /// <inheritdoc/>
    public override double Nothing => double.PositiveInfinity;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => [Rgb.White, Rgb.Black];

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) => values[0] = hit.Distance;

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => double.IsFinite(range.Least)
        ? $"{Text(range.Least)} (white) to {Text(range.Most)} (black) scene units, evenly in 1/distance; black too where nothing is hit"
        : "nothing is hit: black";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range)
    {
        // Evenly in the inverse, so that a horizon leaves some grey to what stands before it.
        (double distance, double least, double most) = (values[0], range.Least, range.Most);
        return Grey(double.IsInfinity(distance) ? 0 : most > least ? ((1 / distance) - (1 / most)) / ((1 / least) - (1 / most)) : 1);
    }
}
