using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>The paths whose light came to a pixel.</summary>
/// <param name="X">Column.</param>
/// <param name="Y">Row.</param>
/// <param name="Pixel">The mean of all samples rendered so far; null where there are none.</param>
/// <param name="Rendered">How many these are.</param>
/// <param name="Samples">Some of its paths.</param>
public sealed record InspectedPixel(int X, int Y, Rgb? Pixel, int Rendered, IReadOnlyList<InspectedPath> Samples);
