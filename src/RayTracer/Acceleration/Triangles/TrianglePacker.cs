using System.Numerics;

namespace RayTracer.Acceleration;

/// <summary>Writes the triangles of a tree into memory in the order and the shape in which leaves are tested.</summary>
internal static unsafe class TrianglePacker
{
    private const int NodesAPiece = 1024;

    /// <summary>Packs all leaves; see <see cref="TriangleLeaf"/>.</summary>
    public static NativeMemoryBlock Pack(WideBvh tree, TriangleBounds triangles, int threads)
    {
        NativeMemoryBlock memory = new((long)tree.Count * TriangleLeaf.Rows * sizeof(float));
        float* target = (float*)memory.Pointer;
        int pieces = (tree.NodeCount + NodesAPiece - 1) / NodesAPiece;
        ParallelLoop.Run(threads, pieces, piece =>
        {
            int end = Math.Min((piece + 1) * NodesAPiece, tree.NodeCount);
            for (int index = piece * NodesAPiece; index < end; index++)
            {
                BvhNode* node = tree.Nodes + index;
                for (int child = 0; child < node->Count; child++)
                {
                    if ((node->Child[child] & BvhNode.LeafBit) != 0)
                    {
                        PackLeaf(tree.Order, triangles, node->Child[child], target);
                    }
                }
            }
        });
        return memory;
    }

    private static void PackLeaf(ReadOnlySpan<int> order, TriangleBounds triangles, uint leaf, float* target)
    {
        int count = BvhNode.LeafCount(leaf);
        int first = BvhNode.LeafFirst(leaf);
        float* rows = target + ((long)first * TriangleLeaf.Rows);
        for (int i = 0; i < count; i++)
        {
            int number = order[first + i];
            for (int corner = 0; corner < 3; corner++)
            {
                Vector3 position = triangles.Corner(number, corner);
                float* cell = rows + (3 * corner * count) + i;
                cell[0] = position.X;
                cell[count] = position.Y;
                cell[2 * count] = position.Z;
            }

            ((int*)rows)[(9 * count) + i] = number;
        }
    }
}
