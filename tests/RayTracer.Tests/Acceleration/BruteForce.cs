using System.Numerics;
using System.Runtime.Intrinsics;
using RayTracer.Acceleration;

namespace RayTracer.Tests.Acceleration;

/// <summary>Every ray against every triangle, one by one, by the same test as the trees': what they must find.</summary>
internal static unsafe class BruteForce
{
    public static (float[] Distance, int[] Primitive) Closest(TestMesh mesh, TestRays rays)
    {
        TriangleBvh all = TriangleBvh.Build(mesh.Positions, mesh.Indices, 1);
        Box4 bounds = new() { Lower = all.Lower.AsVector128(), Upper = all.Upper.AsVector128() };
        float[] distance = [.. rays.Distance];
        int[] primitive = new int[rays.Count];
        float* rows = stackalloc float[TriangleLeaf.Rows + 8];
        RayBlock block = default;
        RayBlock* one = &block;
        fixed (Vector3* positions = mesh.Positions)
        fixed (int* indices = mesh.Indices)
        {
            TriangleBounds triangles = new(positions, mesh.Positions.Length, indices, mesh.Count);
            for (int ray = 0; ray < rays.Count; ray++)
            {
                bool sane = false;
                int index = ray;
                rays.Use(stream => sane = RayBlock.Load(one, stream, index, 1, null, bounds) != 0);
                for (int triangle = 0; triangle < mesh.Count && sane; triangle++)
                {
                    if (triangles.TryGetBounds(triangle, out _))
                    {
                        Pack(mesh, triangle, rows);
                        TriangleLeaf.Intersect<ClosestSearch>(rows, BvhNode.LeafReference(0, 1), one, 0);
                    }
                }

                primitive[ray] = sane ? one->Primitive[0] : -1;
                distance[ray] = primitive[ray] >= 0 ? one->Distance[0] : distance[ray];
            }
        }

        return (distance, primitive);
    }

    private static void Pack(TestMesh mesh, int triangle, float* rows)
    {
        for (int corner = 0; corner < 3; corner++)
        {
            Vector3 position = mesh.Corner(triangle, corner);
            (rows[3 * corner], rows[(3 * corner) + 1], rows[(3 * corner) + 2]) = (position.X, position.Y, position.Z);
        }

        ((int*)rows)[9] = triangle;
    }
}
