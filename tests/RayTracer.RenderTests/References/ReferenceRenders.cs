namespace RayTracer.RenderTests.References;

/// <summary>Renders of a case.</summary>
/// <param name="Name">Name of the scene.</param>
/// <param name="Lower">Images whose expectation is the truth, or lies below it.</param>
/// <param name="Upper">Images whose expectation lies above the truth; null where <paramref name="Lower"/> is exact.</param>
public sealed record ReferenceRenders(string Name, ImageSamples Lower, ImageSamples? Upper);
