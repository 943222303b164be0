namespace RayTracer.Rendering;

/// <summary>Adds up, for somebody who watches, what several threads have done.</summary>
/// <param name="total">Paths that there will be.</param>
/// <param name="progress">Told; may be null.</param>
/// <param name="pathsBefore">Paths done before.</param>
/// <param name="raysBefore">Rays traced before.</param>
internal sealed class ProgressSum(long total, IProgress<RenderProgress>? progress, long pathsBefore = 0, long raysBefore = 0)
{
    private long _paths = pathsBefore;
    private long _rays = raysBefore;

    /// <summary>Adds more.</summary>
    public void Add(long paths, long rays)
    {
        long done = Interlocked.Add(ref _paths, paths);
        progress?.Report(new(done, Math.Max(done, total), Interlocked.Add(ref _rays, rays)));
    }
}
