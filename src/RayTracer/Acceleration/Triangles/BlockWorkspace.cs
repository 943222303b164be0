namespace RayTracer.Acceleration;

/// <summary>Memory that a block of rays needs on its way through a tree. It must begin at a cache line.</summary>
internal unsafe struct BlockWorkspace
{
    /// <summary>The rays.</summary>
    public RayBlock Rays;

    /// <summary>Boxes of a node's children: eight lower bounds for x, y, z, then the upper ones.</summary>
    public fixed float Boxes[48];

    /// <summary>For each ray the set of children that it meets.</summary>
    public fixed byte Met[RayBlock.Size];

    /// <summary>For each child, a distance that no ray enters it before.</summary>
    public fixed float Entry[8];

    /// <summary>Spare, so that what follows begins at a cache line.</summary>
    public fixed float Padding[8];

    /// <summary>For rays that are alone.</summary>
    public TraversalStack Single;

    /// <summary>The nodes that groups of rays have yet to visit: <see cref="PendingVisit"/>.</summary>
    public fixed ulong Pending[2 * TraversalStack.Capacity];
}

/// <summary>A node or leaf that rays of a block have yet to visit.</summary>
internal struct PendingVisit
{
    /// <summary>The rays.</summary>
    public ulong Rays;

    /// <summary>Node or leaf.</summary>
    public uint Reference;

    /// <summary>No ray enters it before this distance.</summary>
    public float Entry;
}
