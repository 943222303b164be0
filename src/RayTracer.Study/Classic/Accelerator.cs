using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>
/// A way to find the first triangle that a ray meets, written to be read: one ray at a time, in scalar code, and the same test of a
/// triangle in all of them. What the renderer uses is a hierarchy of bounding volumes, eight boxes wide; these are what it is compared
/// with.
/// </summary>
/// <param name="mesh">The triangles; all corners must be finite.</param>
internal abstract class Accelerator(MeshData mesh) : ITracer
{
    private readonly Vector3[] _positions = mesh.Positions;
    private readonly int[] _indices = mesh.Indices;

    /// <summary>The structure's name.</summary>
    public abstract string Name { get; }

    /// <inheritdoc/>
    public abstract long MemoryBytes { get; }

    /// <summary>Number of triangles.</summary>
    public int Count => _indices.Length / 3;

    /// <summary>Finds the nearest hit; of equally near ones, that of the lowest number.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="distance">In: how far to look; out: the distance of the hit, if there is one.</param>
    /// <returns>The number of the triangle; −1 for none.</returns>
    public abstract int ClosestHit(in Ray ray, ref float distance);

    /// <inheritdoc/>
    public void Trace(ReadOnlySpan<(Vector3 Origin, Vector3 Direction)> rays, Span<int> hits)
    {
        for (int i = 0; i < rays.Length; i++)
        {
            float distance = float.PositiveInfinity;
            hits[i] = ClosestHit(new(rays[i].Origin, rays[i].Direction), ref distance);
        }
    }

    /// <summary>The box around a triangle.</summary>
    private protected Bounds BoundsOf(int triangle)
    {
        (Vector3 a, Vector3 b, Vector3 c) = Corners(triangle);
        return new(Vector3.Min(a, Vector3.Min(b, c)), Vector3.Max(a, Vector3.Max(b, c)));
    }

    /// <summary>The box around all triangles.</summary>
    private protected Bounds BoundsOfAll() => Enumerable.Range(0, Count).Aggregate(Bounds.Empty, (all, t) => all.Union(BoundsOf(t)));

    /// <summary>Shortens a ray to a triangle, if it meets that first (Möller &amp; Trumbore 1997).</summary>
    private protected void Meet(int triangle, in Ray ray, ref float distance, ref int hit)
    {
        (Vector3 a, Vector3 b, Vector3 c) = Corners(triangle);
        Vector3 ab = b - a;
        Vector3 ac = c - a;
        Vector3 p = ray.Direction.Cross(ac);
        float inverse = 1 / ab.Dot(p);
        Vector3 from = ray.Origin - a;
        float u = from.Dot(p) * inverse;
        Vector3 q = from.Cross(ab);
        float v = ray.Direction.Dot(q) * inverse;
        float t = ac.Dot(q) * inverse;

        // Written so that a triangle without area, whose numbers are not numbers, is never hit.
        if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && (t < distance || (t == distance && triangle < hit)))
        {
            distance = t;
            hit = triangle;
        }
    }

    private (Vector3 A, Vector3 B, Vector3 C) Corners(int triangle) =>
        (_positions[_indices[3 * triangle]], _positions[_indices[(3 * triangle) + 1]], _positions[_indices[(3 * triangle) + 2]]);
}
