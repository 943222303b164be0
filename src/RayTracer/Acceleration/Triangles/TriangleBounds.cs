using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>The triangles of an indexed mesh as primitives of a tree.</summary>
/// <param name="positions">The corners.</param>
/// <param name="positionCount">Number of corners.</param>
/// <param name="indices">Three corners a triangle.</param>
/// <param name="count">Number of triangles.</param>
internal readonly unsafe struct TriangleBounds(Vector3* positions, int positionCount, int* indices, int count) : IPrimitiveBounds
{
    public int Count => count;

    /// <summary>A corner of a triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3 Corner(int triangle, int corner) => positions[indices[(3L * triangle) + corner]];

    public bool TryGetBounds(int primitive, out Box4 box)
    {
        int* corners = indices + (3L * primitive);
        if ((uint)corners[0] >= (uint)positionCount || (uint)corners[1] >= (uint)positionCount || (uint)corners[2] >= (uint)positionCount)
        {
            box = Box4.Empty;
            return false;
        }

        Vector128<float> a = positions[corners[0]].AsVector128();
        Vector128<float> b = positions[corners[1]].AsVector128();
        Vector128<float> c = positions[corners[2]].AsVector128();
        box = new()
        {
            Lower = Lanes8.Min(Lanes8.Min(a, b), c),
            Upper = Lanes8.Max(Lanes8.Max(a, b), c),
        };

        // The minimum of a number and NaN may be the number: look at all corners.
        return box.IsBounded && Vector128.EqualsAll((a - a) + (b - b) + (c - c), Vector128<float>.Zero) && HasArea(a, b, c);
    }

    /// <summary>Returns whether the corners are not on a line, by the area in double precision, in which the products are exact.</summary>
    private static bool HasArea(Vector128<float> a, Vector128<float> b, Vector128<float> c)
    {
        double x1 = (double)b[0] - a[0];
        double y1 = (double)b[1] - a[1];
        double z1 = (double)b[2] - a[2];
        double x2 = (double)c[0] - a[0];
        double y2 = (double)c[1] - a[1];
        double z2 = (double)c[2] - a[2];
        return (x1 * y2) != (y1 * x2) || (y1 * z2) != (z1 * y2) || (z1 * x2) != (x1 * z2);
    }
}
