using System.Numerics;

namespace RayTracer.Cli.Complexity;

/// <summary>Something that traces rays through triangles.</summary>
internal interface ITracer
{
    /// <summary>Memory beside the triangles' corners and indices, in bytes.</summary>
    long MemoryBytes { get; }

    /// <summary>Finds the triangle that each ray meets first; −1 for none.</summary>
    void Trace(ReadOnlySpan<(Vector3 Origin, Vector3 Direction)> rays, Span<int> hits);
}
