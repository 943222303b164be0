namespace RayTracer.Testing;

/// <summary>A point of the quadrature of a <see cref="SphericalGrid"/>.</summary>
/// <param name="Cell">The cell.</param>
/// <param name="Direction">The direction.</param>
/// <param name="Weight">What a density's value there is multiplied by, in steradians.</param>
public readonly record struct GridPoint(int Cell, Vector3D Direction, double Weight);
