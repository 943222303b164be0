namespace RayTracer.Acceleration;

/// <summary>Walks through a tree and counts.</summary>
internal static unsafe class BvhInspection
{
    /// <summary>The statistics of a tree.</summary>
    public static BvhStatistics Count(WideBvh tree)
    {
        Totals totals = default;
        double area = tree.Count > 0 ? tree.Bounds.HalfArea : 0;
        Visit(tree.Nodes, 0, area, area, 1, ref totals);
        double cost = area > 0 ? totals.Area / area : totals.Nodes + totals.Leaves;
        GC.KeepAlive(tree);
        return new(tree.Count, totals.Nodes, totals.Leaves, totals.Depth, cost, tree.MemoryBytes);
    }

    private static void Visit(BvhNode* nodes, uint index, double area, double largest, int depth, ref Totals totals)
    {
        totals.Nodes++;
        totals.Area += area;
        totals.Depth = Math.Max(totals.Depth, depth);
        BvhNode* node = nodes + index;
        for (int child = 0; child < node->Count; child++)
        {
            double childArea = Math.Min(largest, BvhNode.Decode(node, child).HalfArea);
            if ((node->Child[child] & BvhNode.LeafBit) != 0)
            {
                totals.Leaves++;
                totals.Area += childArea;
            }
            else
            {
                Visit(nodes, node->Child[child], childArea, largest, depth + 1, ref totals);
            }
        }
    }

    private struct Totals
    {
        public int Nodes;
        public int Leaves;
        public int Depth;
        public double Area;
    }
}
