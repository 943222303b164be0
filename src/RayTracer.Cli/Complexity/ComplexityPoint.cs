namespace RayTracer.Cli.Complexity;

/// <summary>What was measured of a method with some number of triangles.</summary>
/// <param name="Triangles">How many.</param>
/// <param name="NanosecondsPerRay">Time a ray, on one thread.</param>
/// <param name="BuildSeconds">How long building took.</param>
/// <param name="BytesPerTriangle">Memory beside corners and indices.</param>
internal sealed record ComplexityPoint(int Triangles, double NanosecondsPerRay, double BuildSeconds, double BytesPerTriangle);
