using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// How far the outlines of flat shapes are moved outwards, so that no ray passes between neighbours that share an edge: each
/// shape rounds the point where a ray meets it in its own way, and both may find a ray beyond the edge that runs along it.
/// </summary>
/// <remarks>
/// With unit roundoff u = 2⁻²⁴ and M the largest coordinate of ray and shape, the ray's distance from the edge is wrong by at most
/// √14·uM from n·o and 4u·t from the other steps of the distance t, √3·uM from the point, √14·uM from each of map and plane, and 5uM from the constants'
/// own roundings: 32 uM if all errors take their worst values together, for rays as long as a room is wide. Half of that leaves
/// no leak among 72 million rays that were aimed at edges and corners (a quarter: 11; none at all: one ray in seven). Longer rays err more: from D rooms
/// away, cracks of D·uM may be seen.
/// </remarks>
internal static class OutlineSlack
{
    // 16 u.
    private const float Relative = 1f / (1 << 20);

    /// <summary>The distance for a shape of these bounds.</summary>
    public static float Distance(Bounds bounds) => Relative * Vector3.Max(Vector3.Abs(bounds.Minimum), Vector3.Abs(bounds.Maximum)).Largest();
}
