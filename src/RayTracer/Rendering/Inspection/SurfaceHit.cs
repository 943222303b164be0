using System.Numerics;

namespace RayTracer.Rendering;

/// <summary>The point at which a ray meets a surface.</summary>
/// <param name="Name">Which surface.</param>
/// <param name="Distance">How far from the ray's start.</param>
/// <param name="Position">Where, in the world.</param>
/// <param name="Normal">The unit normal with which the surface is shaded, on the ray's side.</param>
public sealed record SurfaceHit(SurfaceName Name, float Distance, Vector3 Position, Vector3 Normal);
