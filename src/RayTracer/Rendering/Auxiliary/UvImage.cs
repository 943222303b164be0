using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Surface coordinates: mean over the samples that meet something, zero where none does.</summary>
public sealed record UvImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "uv";

    /// <inheritdoc/>
    public override string Title => "uv";

    /// <inheritdoc/>
    public override string Description => "Surface coordinates, which place textures: u as red, v as green.";

    /// <inheritdoc/>
    public override string Letters => "UV";

    /// <inheritdoc/>
    public override FirstHitParts Needs => FirstHitParts.Surface | FirstHitParts.Uv;

    /// <inheritdoc/>
    public override MeanOver Mean => MeanOver.Hits;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => [Rgb.Black, new(1, 0, 0), new(1, 1, 0), new(0, 1, 0)];

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) => (values[0], values[1]) = (hit.Uv.X, hit.Uv.Y);

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => "the fractions of u and v from 0 to 1 are red and green from 0 to 1";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        (values[0] - Math.Floor(values[0]), values[1] - Math.Floor(values[1]), 0);
}
