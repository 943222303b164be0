using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Standard error of the pixel's luminance, estimated from the spread of its samples.</summary>
public sealed record ErrorImage : FilmImage
{
    /// <inheritdoc/>
    public override string Name => "error";

    /// <inheritdoc/>
    public override string Title => "Noise";

    /// <inheritdoc/>
    public override string Description =>
        "Where the noise is, as the standard error of each pixel. Bright pixels need more samples: caustics, soft shadows, glossy metal.";

    // The brightest hundredth would leave nothing but black to the others.
    /// <inheritdoc/>
    public override bool IsSkewed => true;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => HeatMap.Colors;

    /// <inheritdoc/>
    public override void Read(Film film, int x, int y, Span<double> values) =>
        values[0] = float.Sqrt(film.MeanVariance(x, y));

    /// <inheritdoc/>
    public override string Legend(NumberRange range) =>
        $"0 to {Text(range.Top)} and more, in units of luminance: {HeatMap.Legend}; at most {Text(range.Most)}";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        Heat(values[0] / Math.Max(range.Top, double.Epsilon));
}
