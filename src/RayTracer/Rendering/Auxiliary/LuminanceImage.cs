using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>The luminance of the pixel's light, in false colours that are as far apart as exposures are.</summary>
public sealed record LuminanceImage : FilmImage
{
    // Below the brightest.
    private const int Stops = 10;

    /// <inheritdoc/>
    public override string Name => "luminance";

    /// <inheritdoc/>
    public override string Title => "Luminance";

    /// <inheritdoc/>
    public override string Description => "How bright the light is, in false colours: equal steps of the scale are equal ratios, so that shadows and lamps can be compared.";

    // A lamp or a spark would leave nothing but black to the others.
    /// <inheritdoc/>
    public override bool IsSkewed => true;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => HeatMap.Colors;

    /// <inheritdoc/>
    public override void Read(Film film, int x, int y, Span<double> values) => values[0] = film.Mean(x, y).Luminance;

    /// <inheritdoc/>
    public override string Legend(NumberRange range) =>
        $"{Text(range.Top / (1 << Stops))} or less to {Text(range.Top)} and more, evenly in {Stops} doublings: {HeatMap.Legend}; at most {Text(range.Most)}";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        Heat(values[0] > 0 && range.Top > 0 ? 1 + (PortableMath.Log2(values[0] / range.Top) / Stops) : 0);
}
