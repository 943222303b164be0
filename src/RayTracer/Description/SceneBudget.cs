namespace RayTracer.Description;

/// <summary>
/// The memory that a scene with all of its files may take, and the work that it may cost before it is rendered. A few bytes can ask for
/// gigabytes, or for hours: pictures of one colour, groups of instances of groups, one model in thousands of places.
/// </summary>
public sealed class SceneBudget
{
    /// <summary>The steps that a triangle costs, in each place of its mesh.</summary>
    internal const long StepsPerTriangle = 16;

    /// <summary>The steps that an instance costs.</summary>
    internal const long StepsPerInstance = 100;

    private const long StandardLimit = 4L << 30;
    private static readonly AsyncLocal<SceneBudget?> s_open = new();
    private readonly Lock _lock = new();
    private long _used;
    private long _steps;

    /// <summary>The limit in bytes, for all scenes and pictures that a program reads; at first 4 GiB, or half of the memory there is where that is less.</summary>
    public static long Limit { get; set; } = Math.Min(StandardLimit, GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / 2);

    /// <summary>The limit of work, in steps: one for a pixel of a picture or a byte of a model that is read, more for triangles and instances.</summary>
    public static long WorkLimit { get; set; } = StandardLimit;

    /// <summary>The budget of the scene that is being read where this is called; null where none is.</summary>
    public static SceneBudget? Open => s_open.Value;

    /// <summary>Until the end of the scope, what is read counts against this budget.</summary>
    public IDisposable Begin()
    {
        SceneBudget? outer = s_open.Value;
        s_open.Value = this;
        return new MaterialScope(() => s_open.Value = outer);
    }

    /// <summary>Counts memory and work before they are taken.</summary>
    /// <param name="what">The thing, as the complaint calls it.</param>
    /// <param name="bytes">The memory wanted, in bytes.</param>
    /// <param name="steps">The work wanted, in steps.</param>
    /// <returns>The complaint; null where it is within the limits, and was counted.</returns>
    public string? Take(string what, long bytes, long steps)
    {
        lock (_lock)
        {
            if (bytes > Limit - _used)
            {
                return $"{what} would take the scene beyond its {Limit >> 20} MiB of memory (--memory sets another limit)";
            }

            if (steps > WorkLimit - _steps)
            {
                return $"{what} would take the scene beyond its {WorkLimit:N0} steps of work (--work sets another limit)";
            }

            (_used, _steps) = (_used + bytes, _steps + steps);
            return null;
        }
    }

    /// <summary>Counts the work of reading something whose memory is counted when it is there.</summary>
    /// <inheritdoc cref="Take"/>
    public string? TakeWork(string what, long bytes, long steps)
    {
        string? complaint = Take(what, bytes, steps);
        _used -= complaint is null ? bytes : 0;
        return complaint;
    }
}
