namespace RayTracer.Description;

/// <summary>
/// The memory that a scene with all of its files may take. A few bytes can ask for gigabytes: pictures of one colour, groups of instances of
/// groups.
/// </summary>
public sealed class SceneBudget
{
    private const long StandardLimit = 4L << 30;
    private long _used;

    /// <summary>The limit in bytes, for all scenes and pictures that a program reads; at first 4 GiB, or half of the memory there is where that is less.</summary>
    public static long Limit { get; set; } = Math.Min(StandardLimit, GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / 2);

    /// <summary>Counts memory before it is taken.</summary>
    /// <param name="bytes">How much is wanted.</param>
    /// <returns>True if it is within the limit, and was counted.</returns>
    public bool TryUse(long bytes)
    {
        bool fits = bytes <= Limit - _used;
        _used += fits ? bytes : 0;
        return fits;
    }

    /// <summary>The sentence about something that does not fit.</summary>
    /// <param name="what">The thing.</param>
    internal static string Complaint(string what) => $"{what} would take the scene beyond its {Limit >> 20} MiB of memory (--memory sets another limit)";
}
