namespace RayTracer.Session;

/// <summary>A clear substance and its refractive index.</summary>
/// <param name="Name">The substance.</param>
/// <param name="Value">Its index with respect to vacuum.</param>
public sealed record RefractiveIndex(string Name, double Value)
{
    /// <summary>The report's table 4.1, by name; of garnet, whose index varies, both ends.</summary>
    public static IReadOnlyList<RefractiveIndex> All { get; } =
    [
        new("amber", 1.54), new("cubic zirconia", 2.15), new("diamond", 2.417), new("emerald", 1.57), new("fused quartz", 1.46), new("garnet (lowest)", 1.73),
        new("garnet (highest)", 1.89), new("glass", 1.5), new("ice", 1.309), new("ruby", 1.77), new("sapphire", 1.77), new("sodium chloride", 1.53), new("water", 1.333),
    ];
}
