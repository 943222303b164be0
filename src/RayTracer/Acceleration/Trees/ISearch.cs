namespace RayTracer.Acceleration;

/// <summary>What a traversal looks for; constants, so that each search is compiled on its own.</summary>
internal interface ISearch
{
    /// <summary>Whether any hit ends the search.</summary>
    static abstract bool EndsAtAnyHit { get; }

    /// <summary>Whether visited nodes and tested triangles are counted.</summary>
    static abstract bool Counts { get; }
}

/// <summary>The nearest hit.</summary>
internal readonly struct ClosestSearch : ISearch
{
    public static bool EndsAtAnyHit => false;

    public static bool Counts => false;
}

/// <summary>The nearest hit, and what it took to find it.</summary>
internal readonly struct CountingSearch : ISearch
{
    public static bool EndsAtAnyHit => false;

    public static bool Counts => true;
}

/// <summary>Whether there is a hit.</summary>
internal readonly struct AnySearch : ISearch
{
    public static bool EndsAtAnyHit => true;

    public static bool Counts => false;
}
