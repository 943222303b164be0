namespace RayTracer.Session;

/// <summary>The numbers of a pixel in the map that is shown: linear light, or those of an auxiliary image.</summary>
/// <param name="X">The pixel's column.</param>
/// <param name="Y">The pixel's row.</param>
/// <param name="Letters">A letter for each number, as the channels of files have them.</param>
/// <param name="Values">The numbers; null where one is not finite.</param>
public sealed record PixelReading(int X, int Y, string Letters, IReadOnlyList<double?> Values);
