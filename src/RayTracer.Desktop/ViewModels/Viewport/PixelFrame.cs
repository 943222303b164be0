namespace RayTracer.Desktop.ViewModels;

/// <summary>Pixels for the screen: four bytes each, red, green, blue and how opaque it is, row by row from the top.</summary>
/// <param name="Width">Pixels across.</param>
/// <param name="Height">Pixels down.</param>
/// <param name="Rgba">The bytes. Whoever shows them takes them at once: they are used again.</param>
internal sealed record PixelFrame(int Width, int Height, byte[] Rgba);
