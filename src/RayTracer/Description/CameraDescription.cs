using System.Numerics;

namespace RayTracer.Description;

/// <summary>The extent of the picture that the field of view measures.</summary>
public enum FieldOfViewAxis
{
    /// <summary>The height of the picture.</summary>
    Vertical,

    /// <summary>The width of the picture.</summary>
    Horizontal,

    /// <summary>The smaller of width and height.</summary>
    Smaller,

    /// <summary>The larger of width and height.</summary>
    Larger,

    /// <summary>The diagonal of the picture.</summary>
    Diagonal,
}

/// <summary>Describes the camera.</summary>
public sealed record CameraDescription
{
    /// <summary>The position of the eye.</summary>
    [Parameter("The position of the eye.", Unit = "scene units")]
    public Vector3 Position { get; init; } = new(0, 1, 5);

    /// <summary>The point in the middle of the picture.</summary>
    [Parameter("The point shown in the middle of the picture.", Unit = "scene units")]
    public Vector3 LookAt { get; init; }

    /// <summary>The direction that is up in the picture.</summary>
    [Parameter("The direction that is up in the picture; it need not be perpendicular to the viewing direction.")]
    public Vector3 Up { get; init; } = new(0, 1, 0);

    /// <summary>The projection of the scene to the picture.</summary>
    [Parameter("The projection: perspective, orthographic (parallel rays; viewSize sets how much they show), or spherical (all directions "
        + "around the eye: 360 degrees across the picture and 180 along its height, the point looked at in the middle; pixels are square "
        + "in a picture twice as wide as high).")]
    public Projection Projection { get; init; } = Projection.Perspective;

    /// <summary>Extent of what an orthographic camera shows over <see cref="FieldOfViewAxis"/>.</summary>
    [Parameter("Only for orthographic: the extent that the picture shows, over its height unless fieldOfViewAxis says otherwise.",
        Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float ViewSize { get; init; } = 2;

    /// <summary>Full angle of the field of view over <see cref="FieldOfViewAxis"/>.</summary>
    [Parameter("Only for perspective: the full angle that the picture shows, over its height unless fieldOfViewAxis says otherwise.",
        Unit = "degrees", Minimum = 0.001, Maximum = 179)]
    public float FieldOfView { get; init; } = 40;

    /// <summary>The extent of the picture that <see cref="FieldOfView"/> measures.</summary>
    [Parameter("The extent of the picture that the field of view, or viewSize, measures.")]
    public FieldOfViewAxis FieldOfViewAxis { get; init; } = FieldOfViewAxis.Vertical;

    /// <summary>
    /// The part of the whole picture that is shown: where it begins from the upper left, and its size, in fractions of the whole; empty for
    /// all of it.
    /// </summary>
    [Parameter("The part of the whole picture that is shown: x and y of its upper left corner, its width and its height, in fractions of "
        + "the whole. Field of view and viewSize measure the whole. Without it, all is shown.", Minimum = 0, Maximum = 1)]
    public IReadOnlyList<float> Window { get; init; } = [];

    /// <summary>The lens.</summary>
    [Parameter("The lens, for depth of field. Without it the camera is a pinhole.")]
    public LensDescription Lens { get; init; } = new();

    /// <summary>The transform of the camera from where its own numbers put it; empty for none.</summary>
    [Parameter("How the camera is moved from where its numbers put it: steps, the first one applied first.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>The motion of the camera in time, after its transform; empty where it rests.</summary>
    [Parameter("How the camera moves in time, from where it is otherwise: keyframes in the order of their times.")]
    public IReadOnlyList<KeyframeDescription> Motion { get; init; } = [];
}
