using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>Requests that wait for news: answered at once where there is any, else when there is, or after a time without.</summary>
/// <param name="windows">Counts those who wait.</param>
/// <param name="patience">How long to wait.</param>
/// <param name="stopping">Ends all waiting.</param>
internal sealed class LongPoll(WindowWatch windows, TimeSpan patience, CancellationToken stopping)
{
    /// <summary>Waits for news.</summary>
    /// <param name="changes">What counts the news.</param>
    /// <param name="after">How many whoever asks knows already.</param>
    /// <param name="aborted">Whoever asks has gone.</param>
    /// <returns>Whether there is any.</returns>
    public async Task<bool> Wait(ChangeCounter changes, long after, CancellationToken aborted)
    {
        using IDisposable visit = windows.Enter();
        using CancellationTokenSource end = CancellationTokenSource.CreateLinkedTokenSource(stopping, aborted);
        end.CancelAfter(patience);
        return await changes.WaitBeyond(after, end.Token);
    }
}
