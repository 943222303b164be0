using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// The way that what is seen goes in the picture while the shutter is open, in pixels to the right and down: mean over the samples that meet something, zero where
/// none does. Programs that blur or join pictures by motion ask for it.
/// </summary>
public sealed record MotionImage : FirstHitImage
{
    /// <inheritdoc/>
    public override string Name => "motion";

    /// <inheritdoc/>
    public override string Title => "Motion";

    /// <inheritdoc/>
    public override string Description => "How far things move in the picture while the shutter is open: to the right as red, down as green.";

    /// <inheritdoc/>
    public override string Letters => "XY";

    /// <inheritdoc/>
    public override FirstHitParts Needs => FirstHitParts.Surface | FirstHitParts.Motion;

    /// <inheritdoc/>
    public override MeanOver Mean => MeanOver.Hits;

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => [new(0, 0.5f, 0.5f), new(0.5f, 0.5f, 0.5f), new(1, 0.5f, 0.5f)];

    /// <inheritdoc/>
    public override string? Complaint(Scene scene) =>
        !scene.Camera.CanLink ? "the camera's projection does not say where in the picture a point of the scene is seen"
        : scene.Render.Shutter.X == scene.Render.Shutter.Y ? "nothing moves while the shutter is open for no time: give \"shutter\" under \"render\" its times of opening and closing"
        : null;

    /// <inheritdoc/>
    public override void Read(in FirstHit hit, Span<double> values) => (values[0], values[1]) = (hit.Motion.X, hit.Motion.Y);

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => $"{Text(-Reach(range))} to {Text(Reach(range))} pixels: to the left and up is dark, to the right bright red, down bright green";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) =>
        (0.5 + (values[0] / Reach(range) / 2), 0.5 + (values[1] / Reach(range) / 2), 0.5);

    private static double Reach(NumberRange range) => Math.Max(Math.Max(-range.Least, range.Most), 1e-9);
}
