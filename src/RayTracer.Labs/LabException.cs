namespace RayTracer.Labs;

/// <summary>A lab cannot be made, checked or graded, and why.</summary>
/// <param name="message">The fault and what was expected, in one sentence.</param>
public sealed class LabException(string message) : Exception(message);
