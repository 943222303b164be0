namespace RayTracer.Study;

/// <summary>The numbers of triangles, and the time that anything may take.</summary>
/// <param name="Counts">Numbers of triangles, ascending.</param>
/// <param name="Rays">Rays that are traced in one go.</param>
/// <param name="SecondsEach">A method is not tried with more triangles once building or tracing would take longer than this.</param>
/// <param name="Rounds">The number of measurements of each; the fastest counts.</param>
internal sealed record ComplexityPlan(IReadOnlyList<int> Counts, int Rays, double SecondsEach, int Rounds)
{
    /// <summary>From ten to ten million.</summary>
    public static ComplexityPlan Full { get; } = new(
        [10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000, 1_000_000, 3_000_000, 10_000_000], 1 << 16, 60, 5);

    /// <summary>Up to a hundred thousand: some seconds.</summary>
    public static ComplexityPlan Quick { get; } = new([10, 100, 1000, 10_000, 100_000], 1 << 14, 3, 3);
}

/// <summary>The measurements of a method with some number of triangles.</summary>
/// <param name="Triangles">The number of triangles.</param>
/// <param name="NanosecondsPerRay">Time a ray, on one thread.</param>
/// <param name="BuildSeconds">The time that building took, in seconds.</param>
/// <param name="BytesPerTriangle">Memory beside corners and indices.</param>
internal sealed record ComplexityPoint(int Triangles, double NanosecondsPerRay, double BuildSeconds, double BytesPerTriangle);
