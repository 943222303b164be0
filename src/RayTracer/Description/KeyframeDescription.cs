namespace RayTracer.Description;

/// <summary>
/// Where a moving thing is at one time. Between keyframes, translation and scale change in proportion to time and the rotation
/// at constant speed; before the first and after the last one nothing moves.
/// </summary>
public sealed record KeyframeDescription
{
    /// <summary>The time.</summary>
    [Parameter("The time. A picture shows those within the render's shutter. Keyframes are in the order of their times.", Unit = "seconds", Required = true)]
    public float Time { get; init; }

    /// <summary>The motion at that time, after the thing's own transform.</summary>
    [Parameter("How the thing is moved at that time from where it would be without motion: steps, the first one applied first.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];
}
