using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>Number, from 1, of the shape or triangle that the pixel's first sample meets; 0 where it meets nothing.</summary>
public sealed record PrimitiveImage : FirstHitImage
{
    /// <summary>The colours of legends of many things.</summary>
    internal static IReadOnlyList<Rgb> Colors { get; } =
        [new(0.75f, 0.22f, 0.17f), new(0.89f, 0.64f, 0.36f), new(0.31f, 0.62f, 0.41f), new(0.18f, 0.44f, 0.69f), new(0.48f, 0.31f, 0.6f)];

    /// <inheritdoc/>
    public override string Name => "primitive";

    /// <inheritdoc/>
    public override string Title => "Primitives";

    /// <inheritdoc/>
    public override string Description => "Each shape or triangle in a different colour.";

    /// <inheritdoc/>
    public override bool IsWhole => true;

    /// <inheritdoc/>
    public override MeanOver Mean => MeanOver.First;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => Colors;

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) => values[0] = hit.Primitive;

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => "a colour for each shape or triangle; black where nothing is hit";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        values[0] > 0 ? ColorOf(Hash.Mix((uint)values[0])) : default;

    /// <summary>A colour of random bits, never so dark that it looks like nothing.</summary>
    internal static (double R, double G, double B) ColorOf(uint bits)
    {
        static double Channel(uint eight) => (30 + (225 * (eight & 0xff) / 255.0)) / 255;
        return (Channel(bits), Channel(bits >> 8), Channel(bits >> 16));
    }
}
