using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>The report's loop over all primitives (listing 6.2): every ray costs as much as there are triangles.</summary>
/// <param name="mesh">The triangles.</param>
internal sealed class PlainLoop(MeshData mesh) : Accelerator(mesh)
{
    /// <inheritdoc/>
    public override string Name => "plain loop";

    /// <inheritdoc/>
    public override long MemoryBytes => 0;

    /// <inheritdoc/>
    public override int ClosestHit(in Ray ray, ref float distance)
    {
        int hit = -1;
        for (int triangle = 0; triangle < Count; triangle++)
        {
            Meet(triangle, ray, ref distance, ref hit);
        }

        return hit;
    }
}
