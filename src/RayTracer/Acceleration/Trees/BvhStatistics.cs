namespace RayTracer.Acceleration;

/// <summary>The size and shape of a tree.</summary>
/// <param name="Primitives">Primitives in its leaves.</param>
/// <param name="Nodes">Inner nodes.</param>
/// <param name="Leaves">Leaves.</param>
/// <param name="Depth">Nodes on the longest way from the root to a leaf.</param>
/// <param name="SahCost">
/// Nodes, plus leaves, that a random line through the root's box is expected to visit (MacDonald &amp; Booth 1990), by the ratio of surface
/// areas.
/// </param>
/// <param name="MemoryBytes">Memory of the nodes and of what the leaves hold.</param>
public readonly record struct BvhStatistics(int Primitives, int Nodes, int Leaves, int Depth, double SahCost, long MemoryBytes);
