using RayTracer.Textbook;

namespace RayTracer.Jobs;

/// <summary>A sampler of the textbook edition that notes which sample of which pixel begins.</summary>
/// <param name="inner">The source of its numbers.</param>
/// <param name="note">Takes column, row and number of the sample.</param>
internal sealed class NotedSampler(ISampler inner, Action<int, int, int> note) : ISampler
{
    /// <inheritdoc/>
    public void Begin(int x, int y, int sample)
    {
        note(x, y, sample);
        inner.Begin(x, y, sample);
    }

    /// <inheritdoc/>
    public double Next() => inner.Next();

    /// <inheritdoc/>
    public (double U, double V) Next2() => inner.Next2();
}
