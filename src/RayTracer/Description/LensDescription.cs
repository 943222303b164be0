using System.Numerics;

namespace RayTracer.Description;

/// <summary>The distribution of points on a lens.</summary>
public enum LensShape
{
    /// <summary>A uniform disk of the aperture radius.</summary>
    Disk,

    /// <summary>A uniform square whose half side is the aperture radius.</summary>
    Square,

    /// <summary>A regular polygon whose corners lie on the circle of the aperture radius: the blades of a diaphragm.</summary>
    Bladed,

    /// <summary>The report's depth of field (listing 6.1): the eye itself is moved within a box, while the plane in focus stays.</summary>
    EyeJitter,
}

/// <summary>Describes a thin lens (report, section 6.2.3, "depth of field").</summary>
public sealed record LensDescription
{
    /// <summary>The distribution of points on the lens.</summary>
    [Parameter("How points on the lens are distributed: over a disk, over a square, over the regular polygon of a bladed diaphragm, or as "
        + "the report's jitter of the eye within a box.")]
    public LensShape Shape { get; init; } = LensShape.Disk;

    /// <summary>Radius of the aperture; zero is a pinhole.</summary>
    [Parameter("Radius of the aperture (half the side of a square one; from the middle to the corners of a bladed one). Zero is a pinhole: "
        + "everything is sharp.", Unit = "scene units", Minimum = 0)]
    public float ApertureRadius { get; init; }

    /// <summary>Number of sides of a bladed aperture.</summary>
    [Parameter("Only for bladed: the number of blades, which is the number of the polygon's sides.", Minimum = 3, Maximum = 64)]
    public int Blades { get; init; } = 6;

    /// <summary>Angle by which a bladed aperture is turned.</summary>
    [Parameter("Only for bladed: the angle by which the polygon is turned counter-clockwise, as seen from behind the camera. At 0 one "
        + "corner is on the right.", Unit = "degrees")]
    public float Rotation { get; init; }

    /// <summary>Distance of the plane in focus along the optical axis; zero means the distance to the point looked at.</summary>
    [Parameter("Distance from the eye to the plane in focus, along the viewing direction. Zero means the distance to the point looked at.",
        Unit = "scene units", Minimum = 0)]
    public float FocusDistance { get; init; }

    /// <summary>Sides of the box within which <see cref="LensShape.EyeJitter"/> moves the eye, centred on the camera's position.</summary>
    [Parameter("Only for eyeJitter: the sides of the box, parallel to the axes and centred on the eye, within which the eye is moved. The "
        + "report used 1/20 on each side.", Unit = "scene units", Minimum = 0)]
    public Vector3 Jitter { get; init; } = new(0.05f, 0.05f, 0.05f);
}
