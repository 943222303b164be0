namespace RayTracer.Rendering;

/// <summary>The options of computing a picture: nothing here changes a bit of it.</summary>
public sealed record RenderOptions
{
    /// <summary>Number of threads, from 0; 0 means one for each core.</summary>
    public int Threads { get; init; }

    /// <summary>Longest edge of a tile in pixels, 1 to 64; 0 chooses one that keeps the streams full and the threads busy.</summary>
    public int TileSize { get; init; }

    /// <summary>Number of paths that a thread follows at a time, 1 to 65,536.</summary>
    public int StreamSize { get; init; } = 4096;

    /// <summary>The part of the picture to render; null is all of it. The film always has the whole picture's size.</summary>
    public Tile? Crop { get; init; }

    /// <summary>The samples to render; null is all that the scene asks for.</summary>
    public SampleRange? Samples { get; init; }

    /// <summary>
    /// Takes layers of light beside the film, of the same samples; null where none are wanted, and then they cost nothing.
    /// </summary>
    public LightPathAovFilm? Layers { get; init; }

    /// <summary>Takes what each way to make paths brings, of the same samples; null where that is not wanted, and then it costs nothing.</summary>
    internal StrategyFilm? Strategies { get; init; }

    /// <summary>
    /// Called after each pass, on the thread that called, while nothing is written to the film: takes the samples of the pass, and returns
    /// how long the next one may take; nothing or less ends the rendering. Null where nobody looks: then threads begin a pass while others
    /// still finish the one before.
    /// </summary>
    public Func<SampleRange, TimeSpan>? AfterPass { get; init; }

    /// <summary>Measures the stages, with one thread; null where nobody looks.</summary>
    internal StageClock? Clock { get; init; }

    /// <summary>How long a pass may take even if it more than doubles the samples.</summary>
    internal TimeSpan ShortestPass { get; init; } = TimeSpan.FromSeconds(1);
}

/// <summary>The progress of a rendering.</summary>
/// <param name="PathsDone">Paths that are in the film.</param>
/// <param name="PathsTotal">Paths that will be.</param>
/// <param name="Rays">Rays traced so far.</param>
public readonly record struct RenderProgress(long PathsDone, long PathsTotal, long Rays)
{
    /// <summary>The pass that is under way, from 1; 0 where there are no passes.</summary>
    public int Pass { get; init; }

    /// <summary>The samples that every pixel has from the passes before.</summary>
    public int SamplesDone { get; init; }

    /// <summary>The part that is done, 0 to 1.</summary>
    public double Fraction => PathsTotal == 0 ? 1 : (double)PathsDone / PathsTotal;
}

/// <summary>A sample whose radiance was not a finite number. It was left out of the film.</summary>
/// <param name="X">Column of the pixel.</param>
/// <param name="Y">Row of the pixel.</param>
/// <param name="Sample">Number of the sample.</param>
/// <param name="Value">The outcome.</param>
public readonly record struct BadSample(int X, int Y, int Sample, Numerics.Rgb Value) : IComparable<BadSample>
{
    /// <summary>Row by row, then by column and sample.</summary>
    public int CompareTo(BadSample other) => (Y, X, Sample).CompareTo((other.Y, other.X, other.Sample));

    /// <summary>Returns whether one comes first.</summary>
    public static bool operator <(BadSample left, BadSample right) => left.CompareTo(right) < 0;

    /// <summary>Returns whether one comes later.</summary>
    public static bool operator >(BadSample left, BadSample right) => left.CompareTo(right) > 0;

    /// <summary>Returns whether one comes first or both are of one sample.</summary>
    public static bool operator <=(BadSample left, BadSample right) => left.CompareTo(right) <= 0;

    /// <summary>Returns whether one comes later or both are of one sample.</summary>
    public static bool operator >=(BadSample left, BadSample right) => left.CompareTo(right) >= 0;
}

/// <summary>The work that was done for a picture.</summary>
public sealed record RenderStatistics
{
    /// <summary>The number of bad samples that are kept by name.</summary>
    public const int MaxBadSamples = 16;

    /// <summary>The samples that every pixel was given: all, unless the rendering ended early.</summary>
    public int SamplesPerPixel { get; init; }

    /// <summary>Light paths followed, without those of a pass that was broken off.</summary>
    public long Paths { get; init; }

    /// <summary>Rays whose nearest hit was looked for.</summary>
    public long ClosestHitRays { get; init; }

    /// <summary>Rays towards lights.</summary>
    public long ShadowRays { get; init; }

    /// <summary>Samples that were not finite and were left out.</summary>
    public long NonFiniteSamples { get; init; }

    /// <summary>Samples that were clamped at <see cref="Film.SampleLimit"/>.</summary>
    public long ClampedSamples { get; init; }

    /// <summary>The first samples that were not finite, in the order of pixels and samples.</summary>
    public IReadOnlyList<BadSample> BadSamples { get; init; } = [];

    /// <summary>True where the rendering was cancelled before its end.</summary>
    public bool Cancelled { get; init; }

    /// <summary>All rays.</summary>
    public long Rays => ClosestHitRays + ShadowRays;

    /// <summary>Returns the work of two renderings of the same scene together.</summary>
    public static RenderStatistics operator +(RenderStatistics a, RenderStatistics b) => new()
    {
        SamplesPerPixel = a.SamplesPerPixel + b.SamplesPerPixel,
        Paths = a.Paths + b.Paths,
        ClosestHitRays = a.ClosestHitRays + b.ClosestHitRays,
        ShadowRays = a.ShadowRays + b.ShadowRays,
        NonFiniteSamples = a.NonFiniteSamples + b.NonFiniteSamples,
        ClampedSamples = a.ClampedSamples + b.ClampedSamples,
        BadSamples = [.. a.BadSamples.Concat(b.BadSamples).Order().Take(MaxBadSamples)],
        Cancelled = a.Cancelled || b.Cancelled,
    };
}
