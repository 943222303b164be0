using System.Numerics;

namespace RayTracer.Description;

/// <summary>
/// One step of moving a thing. Of several parameters in one step the matrix is applied first, then scale, rotation and
/// translation; of several steps in a list, the first one first.
/// </summary>
public sealed record TransformDescription
{
    /// <summary>A matrix, row by row: 12 numbers, or 16 whose last four are 0, 0, 0, 1.</summary>
    [Parameter("A matrix, row by row: 3 rows of 4 numbers, or 4 rows, the last of which is 0, 0, 0, 1. The fourth column is the "
        + "translation. Applied before the other parameters of the step.")]
    public IReadOnlyList<float> Matrix { get; init; } = [];

    /// <summary>Factors along the axes; negative ones mirror.</summary>
    [Parameter("Factors along x, y and z, from the origin; a negative one mirrors. None may be 0. One number stands for all three.",
        IsNumber = true)]
    public Vector3 Scale { get; init; } = Vector3.One;

    /// <summary>Angle of rotation about <see cref="Axis"/>, by the right-hand rule.</summary>
    [Parameter("Angle of a rotation about the axis, through the origin: counter-clockwise when the axis points at the viewer. Applied "
        + "after the scale.", Unit = "degrees")]
    public float Rotate { get; init; }

    /// <summary>Axis of the rotation, of any length.</summary>
    [Parameter("Axis of the rotation, of any length.")]
    public Vector3 Axis { get; init; } = new(0, 1, 0);

    /// <summary>Added last.</summary>
    [Parameter("How far the thing is moved along x, y and z, after the other parameters of the step.", Unit = "scene units")]
    public Vector3 Translate { get; init; }
}

/// <summary>
/// Where a moving thing is at one time. Between keyframes, translation and scale change in proportion to time and the rotation
/// at constant speed; before the first and after the last one nothing moves.
/// </summary>
public sealed record KeyframeDescription
{
    /// <summary>The time.</summary>
    [Parameter("The time. A picture shows those within the render's shutter. Keyframes are in the order of their times.",
        Unit = "seconds", Required = true)]
    public float Time { get; init; }

    /// <summary>The motion at that time, after the thing's own transform.</summary>
    [Parameter("How the thing is moved at that time from where it would be without motion: steps, the first one applied first.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];
}
