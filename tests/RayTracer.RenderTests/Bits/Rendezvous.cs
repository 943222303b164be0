using System.Collections.Concurrent;
using RayTracer.Rendering;

namespace RayTracer.RenderTests.Bits;

/// <summary>
/// Keeps every rendering thread at its first tile until all have one: otherwise, in a small picture, the first thread may take
/// all the tiles, and what the others do wrong would not be seen.
/// </summary>
/// <param name="threads">How many threads there are; each must have a tile.</param>
internal sealed class Rendezvous(int threads) : IProgress<RenderProgress>, IDisposable
{
    private readonly ConcurrentDictionary<int, bool> _seen = new();
    private readonly CountdownEvent _missing = new(threads);

    /// <summary>How many threads came.</summary>
    public int Threads => _seen.Count;

    /// <inheritdoc/>
    public void Report(RenderProgress value)
    {
        if (_seen.TryAdd(Environment.CurrentManagedThreadId, true))
        {
            _missing.Signal();

            // A thread that never comes fails the test by the count, not by hanging.
            _missing.Wait(TimeSpan.FromSeconds(30));
        }
    }

    /// <inheritdoc/>
    public void Dispose() => _missing.Dispose();
}
