namespace RayTracer.Rendering;

/// <summary>Adds up, for somebody who watches, what several threads have done.</summary>
/// <param name="total">Paths that there will be.</param>
/// <param name="progress">Told; may be null.</param>
/// <param name="pathsBefore">Paths done before.</param>
/// <param name="raysBefore">Rays traced before.</param>
internal sealed class ProgressSum(long total, IProgress<RenderProgress>? progress, long pathsBefore = 0, long raysBefore = 0)
{
    private long _paths = pathsBefore;
    private long _total = total;
    private long _rays = raysBefore;

    /// <summary>Replaces the total; 0 where it is not known.</summary>
    public void Expect(long paths) => Interlocked.Exchange(ref _total, paths);

    /// <summary>Adds more.</summary>
    public void Add(long paths, long rays)
    {
        long done = Interlocked.Add(ref _paths, paths);
        long all = Interlocked.Read(ref _total);
        progress?.Report(new(done, all == 0 ? 0 : Math.Max(done, all), Interlocked.Add(ref _rays, rays)));
    }
}
