using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>The cube from −1 to 1, as triangles.</summary>
internal static class CubeMesh
{
    // For each face, what is to the front, and along which directions u and v grow.
    private static readonly (Vector3 Front, Vector3 U, Vector3 V)[] s_faces =
    [
        (new(1, 0, 0), new(0, 1, 0), new(0, 0, -1)), (new(-1, 0, 0), new(0, 1, 0), new(0, 0, 1)),
        (new(0, 1, 0), new(-1, 0, 0), new(0, 0, -1)), (new(0, -1, 0), new(0, 0, 1), new(1, 0, 0)),
        (new(0, 0, 1), new(0, 1, 0), new(1, 0, 0)), (new(0, 0, -1), new(0, -1, 0), new(1, 0, 0)),
    ];

    /// <summary>The cube.</summary>
    /// <param name="hasUv">Whether its corners have uv: on each face from 0 to 1.</param>
    public static MeshDescription Create(bool hasUv)
    {
        List<Vector3> positions = [];
        List<TriangleIndices> triangles = [];
        foreach ((Vector3 front, Vector3 u, Vector3 v) in s_faces)
        {
            int first = positions.Count;
            positions.AddRange([front - u - v, front + u - v, front + u + v, front - u + v]);
            bool isLeftTurn = u.Cross(v).Dot(front) > 0;
            triangles.AddRange(isLeftTurn
                ? [new(first, first + 1, first + 2), new(first, first + 2, first + 3)]
                : [new(first, first + 2, first + 1), new(first, first + 3, first + 2)]);
        }

        Vector2[] uv = [new(0, 0), new(1, 0), new(1, 1), new(0, 1)];
        return new() { Positions = positions, Triangles = triangles, Uv = hasUv ? [.. s_faces.SelectMany(_ => uv)] : [] };
    }
}
