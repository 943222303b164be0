using System.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Extensions.Tests;

/// <summary>An auxiliary image of the cosine between the camera ray and the surface that it meets.</summary>
public sealed record FacingImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "facing";

    /// <inheritdoc/>
    public override string Title => "Facing";

    /// <inheritdoc/>
    public override string Description => "White where surfaces face the camera, black at their edges.";

    /// <inheritdoc/>
    public override FirstHitParts Needs => FirstHitParts.Surface;

    /// <inheritdoc/>
    public override MeanOver Mean => MeanOver.Hits;

    /// <inheritdoc/>
    public override double Nothing => -1;

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) => values[0] = -Vector3.Dot(hit.Direction, hit.Normal);

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => "the cosine from 0 (black) to 1 (white)";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) => Grey(values[0]);
}
