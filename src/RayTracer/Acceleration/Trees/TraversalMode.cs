namespace RayTracer.Acceleration;

/// <summary>How a stream of rays goes through a tree. All ways find the same hits, to the bit.</summary>
internal enum TraversalMode
{
    /// <summary>By what the rays look like: blocks as they come where neighbours point the same way, else sorted.</summary>
    Automatic,

    /// <summary>One ray after another: one ray against eight boxes or eight triangles.</summary>
    Single,

    /// <summary>Blocks of 64 rays in the order in which they come.</summary>
    Blocks,

    /// <summary>Blocks of 64 rays after sorting all by origin and direction.</summary>
    Sorted,
}
