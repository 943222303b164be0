using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Nodes visited and triangles tested to find what a ray meets, one ray by itself: mean over all samples.</summary>
public sealed record BvhCostImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "bvhCost";

    /// <inheritdoc/>
    public override string Title => "Tree cost";

    /// <inheritdoc/>
    public override string Description =>
        "Nodes visited and triangles tested until the nearest hit is found: the cost of a ray. Only meshes have trees.";

    /// <inheritdoc/>
    public override FirstHitParts Needs => FirstHitParts.Cost;

    // A few rays that graze a surface cost many times what others do.
    /// <inheritdoc/>
    public override bool IsSkewed => true;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => HeatMap.Colors;

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) => values[0] = hit.Cost;

    /// <inheritdoc/>
    public override string Legend(NumberRange range) =>
        $"0 to {Text(range.Top)} and more nodes and triangles per ray: {HeatMap.Legend}; at most {Text(range.Most)}";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        Heat(values[0] / Math.Max(range.Top, double.Epsilon));
}
