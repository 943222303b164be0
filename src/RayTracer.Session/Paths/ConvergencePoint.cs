namespace RayTracer.Session;

/// <summary>The error of a picture.</summary>
/// <param name="Samples">Samples in each pixel.</param>
/// <param name="Error">Root of the mean square error over pixels and channels.</param>
public readonly record struct ConvergencePoint(int Samples, double Error);
