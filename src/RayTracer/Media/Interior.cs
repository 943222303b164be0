namespace RayTracer.Media;

/// <summary>The inside of a shape.</summary>
/// <param name="Medium">What fills it; null for nothing.</param>
/// <param name="Nesting">How it goes with others that overlap it; null for a boundary whose index is relative to what is around.</param>
public sealed record Interior(Medium? Medium, Nesting? Nesting);
