namespace RayTracer.Rendering;

/// <summary>Number of samples in the pixel's sums of light.</summary>
public sealed record SamplesImage : FilmImage
{
    /// <inheritdoc/>
    public override string Name => "samples";

    /// <inheritdoc/>
    public override string Title => "Samples";

    /// <inheritdoc/>
    public override string Description => "The number of samples in each pixel: the same everywhere, unless only a region is rendered.";

    /// <inheritdoc/>
    public override bool IsWhole => true;

    /// <inheritdoc/>
    public override void Read(Film film, int x, int y, Span<double> values) => values[0] = film.SampleCount(x, y);

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => $"0 (black) to {Text(range.Most)} (white) samples";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        Grey(values[0] / Math.Max(range.Most, double.Epsilon));
}
