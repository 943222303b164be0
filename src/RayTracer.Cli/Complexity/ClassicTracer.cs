using System.Numerics;
using RayTracer.Acceleration.Classic;

namespace RayTracer.Cli.Complexity;

/// <summary>Traces with one of the classic structures.</summary>
internal sealed class ClassicTracer(Accelerator accelerator) : ITracer
{
    /// <inheritdoc/>
    public long MemoryBytes => accelerator.MemoryBytes;

    /// <inheritdoc/>
    public void Trace(ReadOnlySpan<(Vector3 Origin, Vector3 Direction)> rays, Span<int> hits)
    {
        for (int i = 0; i < rays.Length; i++)
        {
            float distance = float.PositiveInfinity;
            hits[i] = accelerator.ClosestHit(new Ray(rays[i].Origin, rays[i].Direction), ref distance);
        }
    }
}
