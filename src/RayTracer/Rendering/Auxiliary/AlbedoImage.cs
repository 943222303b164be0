using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Fraction of the light that the surface sends on: mean over all samples, zero where they meet nothing.</summary>
public sealed record AlbedoImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "albedo";

    /// <inheritdoc/>
    public override string Title => "Albedo";

    /// <inheritdoc/>
    public override string Description => "The colour of the surfaces, without light or shadow.";

    /// <inheritdoc/>
    public override string Letters => "RGB";

    /// <inheritdoc/>
    public override FirstHitParts Needs => FirstHitParts.Surface;

    /// <inheritdoc/>
    public override bool ShowsLight => true;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => PrimitiveImage.Colors;

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) =>
        (values[0], values[1], values[2]) = (hit.Albedo.R, hit.Albedo.G, hit.Albedo.B);

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => "red, green and blue from 0 to 1";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        (values[0], values[1], values[2]);
}
