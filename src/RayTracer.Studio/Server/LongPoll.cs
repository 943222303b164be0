namespace RayTracer.Studio;

/// <summary>Requests that wait for news: answered at once where there is any, else when there is, or after a time without.</summary>
/// <param name="windows">Counts those who wait.</param>
/// <param name="patience">The longest time to wait.</param>
/// <param name="stopping">Ends all waiting.</param>
internal sealed class LongPoll(WindowWatch windows, TimeSpan patience, CancellationToken stopping)
{
    /// <summary>Waits for news.</summary>
    /// <param name="wait">Waits until there are more changes than a number.</param>
    /// <param name="after">The version that the page knows already.</param>
    /// <param name="aborted">Signalled when the client has gone.</param>
    /// <returns>True if there is any.</returns>
    public async Task<bool> Wait(Func<long, CancellationToken, Task<bool>> wait, long after, CancellationToken aborted)
    {
        using IDisposable visit = windows.Enter();
        using CancellationTokenSource end = CancellationTokenSource.CreateLinkedTokenSource(stopping, aborted);
        end.CancelAfter(patience);
        return await wait(after, end.Token);
    }
}
