namespace RayTracer.Acceleration;

/// <summary>The goal of a traversal; constants, so that each search is compiled by itself.</summary>
internal interface ISearch
{
    /// <summary>True where any hit ends the search.</summary>
    static abstract bool EndsAtAnyHit { get; }

    /// <summary>True where visited nodes and tested triangles are counted.</summary>
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

/// <summary>The search for any hit.</summary>
internal readonly struct AnySearch : ISearch
{
    public static bool EndsAtAnyHit => true;

    public static bool Counts => false;
}
