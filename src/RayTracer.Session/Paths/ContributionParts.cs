namespace RayTracer.Session;

/// <summary>The light that a path gathers at a vertex; red, green and blue each.</summary>
/// <param name="Emitted">The surface's own light, or the background's.</param>
/// <param name="Ambient">Ambient light.</param>
/// <param name="Direct">Light that comes straight from the sources.</param>
public sealed record ContributionParts(IReadOnlyList<double> Emitted, IReadOnlyList<double> Ambient, IReadOnlyList<double> Direct);
