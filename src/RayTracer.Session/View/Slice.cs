using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>A part of the work on a picture, between two looks at what the user wants.</summary>
/// <param name="Area">The pixels.</param>
/// <param name="Samples">The samples.</param>
public readonly record struct Slice(Tile Area, SampleRange Samples);
