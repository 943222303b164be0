namespace RayTracer.Acceleration;

/// <summary>The nodes that one ray has yet to visit.</summary>
internal unsafe struct TraversalStack
{
    /// <summary>Entries that can come together: seven a level, and the depth of a tree is bounded (<see cref="BvhBuilder"/>).</summary>
    public const int Capacity = 512;

    /// <summary>Nodes and leaves; eight are written at a time.</summary>
    public fixed uint Reference[Capacity + 8];

    /// <summary>The distances at which the ray enters them.</summary>
    public fixed float Entry[Capacity + 8];

    /// <summary>Nodes visited and triangles tested, where that is counted.</summary>
    public long Cost;
}
