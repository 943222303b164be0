using System.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What one sample of each pixel sees through mirrors and clear glass, as planes of floats that are written again for each picture of a moving view. Nothing is
/// added up: a filter takes it as it is.
/// </summary>
internal sealed class SeenPlanes
{
    // How far what surrounds everything stands: points there move with the direction alone.
    private const float Beyond = 1e6f;

    /// <summary>Makes room.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    public SeenPlanes(int width, int height)
    {
        (Width, Height) = (width, height);
        int pixels = checked(width * height);
        (Point, Normal, Albedo, Surface) = (new Vector3[pixels], new Vector3[pixels], new Vector3[pixels], new SurfaceName[pixels]);
    }

    /// <summary>Width in pixels.</summary>
    public int Width { get; }

    /// <summary>Height in pixels.</summary>
    public int Height { get; }

    /// <summary>The position of the camera.</summary>
    public Vector3 Eye { get; set; }

    /// <summary>
    /// The points that are seen, as far behind a mirror as the light has gone: there they stay while the camera moves. Where nothing is seen, points far away.
    /// </summary>
    public Vector3[] Point { get; }

    /// <summary>The unit normals there; zero where nothing is seen.</summary>
    public Vector3[] Normal { get; }

    /// <summary>The part of the light that comes from there to the camera; white where nothing is seen.</summary>
    public Vector3[] Albedo { get; }

    /// <summary>The surfaces.</summary>
    public SurfaceName[] Surface { get; }

    /// <summary>Takes what a ray sees.</summary>
    /// <param name="pixel">Its pixel, counted row by row.</param>
    /// <param name="hit">The last surface; <see cref="FirstHit.Primitive"/> is 0 for none.</param>
    /// <param name="instance">The instance that shows it.</param>
    /// <param name="first">The ray from the camera: origin, direction, and the length of the whole path.</param>
    public void Take(long pixel, in FirstHit hit, int instance, in (Vector3 Origin, Vector3 Direction, float Length) first)
    {
        bool isHit = hit.Primitive > 0;
        Point[pixel] = first.Origin + (first.Direction * (isHit ? first.Length : Beyond));
        Normal[pixel] = isHit ? hit.Normal : Vector3.Zero;
        Albedo[pixel] = isHit ? new(hit.Albedo.R, hit.Albedo.G, hit.Albedo.B) : Vector3.One;
        Surface[pixel] = isHit ? new((int)hit.Primitive - 1, instance) : SurfaceName.None;
    }
}
