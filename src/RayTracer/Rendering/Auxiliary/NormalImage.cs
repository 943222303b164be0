using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Unit normal with which the surface is shaded, on the ray's side: mean over all samples, zero where they meet nothing.</summary>
public sealed record NormalImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "normal";

    /// <inheritdoc/>
    public override string Title => "Normals";

    /// <inheritdoc/>
    public override string Description => "The direction that each surface faces: x as red, y as green, z as blue.";

    /// <inheritdoc/>
    public override string Letters => "XYZ";

    /// <inheritdoc/>
    public override FirstHitParts Needs => FirstHitParts.Surface;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => [new(1, 0.5f, 0.5f), new(0.5f, 1, 0.5f), new(0.5f, 0.5f, 1)];

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) =>
        (values[0], values[1], values[2]) = (hit.Normal.X, hit.Normal.Y, hit.Normal.Z);

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => "x, y and z from -1 to 1 are red, green and blue from 0 to 1";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        ((0.5 * values[0]) + 0.5, (0.5 * values[1]) + 0.5, (0.5 * values[2]) + 0.5);
}
