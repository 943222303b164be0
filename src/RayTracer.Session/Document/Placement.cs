using System.Numerics;

namespace RayTracer.Session;

/// <summary>How a thing is put elsewhere; what is null stays.</summary>
/// <param name="Translate">By how much it is moved.</param>
/// <param name="Rotate">How it is turned.</param>
/// <param name="Scale">By which factors it grows.</param>
/// <param name="Center">The point that scaling and turning leave where it is; null for the thing's own.</param>
public sealed record Placement(Vector3? Translate = null, Turn? Rotate = null, Vector3? Scale = null, Vector3? Center = null);

/// <summary>A turn about an axis.</summary>
/// <param name="Axis">The axis.</param>
/// <param name="Degrees">The angle, counter-clockwise seen against the axis.</param>
/// <param name="Center">A point on the axis; null for the thing's own.</param>
public sealed record Turn(Vector3 Axis, float Degrees, Vector3? Center = null);
