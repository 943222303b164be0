namespace RayTracer.Shapes;

/// <summary>The corners of one triangle of a mesh, as positions in its list of corners, from 0.</summary>
/// <param name="A">First corner.</param>
/// <param name="B">Second corner.</param>
/// <param name="C">Third corner.</param>
public readonly record struct TriangleIndices(int A, int B, int C);
