using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>The camera's end of connections with points of the scene. Only <see cref="Sees"/> has a meaning where it is false, and X and Y where the points lie in front.</summary>
internal struct CameraLinkW
{
    /// <summary>Unit directions from the points towards the camera: towards a point of its lens.</summary>
    public Vec3W Direction;

    /// <summary>The distance to the point of the lens; where rays are parallel, to the plane in which they start.</summary>
    public FloatW Distance;

    /// <summary>Where in the picture the points are seen: columns, in pixels from the left edge.</summary>
    public FloatW X;

    /// <summary>Rows, in pixels from the top edge.</summary>
    public FloatW Y;

    /// <summary>
    /// Camera rays per unit of area perpendicular to the ray at the point, of those through this point of the lens, one for each pixel.
    /// </summary>
    public FloatW Density;

    /// <summary>True where the point lies in front, and within the picture or as near to it as pixel filters reach.</summary>
    public MaskW Sees;
}
