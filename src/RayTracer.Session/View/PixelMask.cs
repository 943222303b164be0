namespace RayTracer.Session;

/// <summary>Some pixels of a picture.</summary>
/// <param name="Width">Width of the picture, which may be smaller than the rendered one.</param>
/// <param name="Height">Its height.</param>
/// <param name="Runs">Start and length of each run of pixels, counted row by row.</param>
public sealed record PixelMask(int Width, int Height, IReadOnlyList<int> Runs);
