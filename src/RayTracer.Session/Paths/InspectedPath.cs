using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>A light path, for people.</summary>
/// <param name="Sample">The sample's number in its pixel.</param>
/// <param name="Radiance">What it brings.</param>
/// <param name="Vertices">From the camera to its end.</param>
public sealed record InspectedPath(int Sample, Rgb Radiance, IReadOnlyList<InspectedVertex> Vertices);
