namespace RayTracer.Session;

/// <summary>
/// Counts changes, and lets others wait for the next one without asking again and again. Waiting never holds up a change.
/// </summary>
public sealed class ChangeCounter
{
    private readonly Lock _lock = new();
    private TaskCompletionSource _next = New();
    private int _waiting;

    /// <summary>Number of changes so far.</summary>
    public long Version { get; private set; }

    /// <summary>The number of waiting callers.</summary>
    public int Waiting => Volatile.Read(ref _waiting);

    /// <summary>Counts a change, and wakes all that wait.</summary>
    public void Advance()
    {
        TaskCompletionSource passed;
        lock (_lock)
        {
            Version++;
            passed = _next;
            _next = New();
        }

        passed.SetResult();
    }

    /// <summary>Waits until there were more changes than a number.</summary>
    /// <param name="version">The number of changes that are known already.</param>
    /// <param name="cancellation">Ends the waiting.</param>
    /// <returns>True if there were; false where the waiting was ended.</returns>
    public async Task<bool> WaitBeyond(long version, CancellationToken cancellation)
    {
        Interlocked.Increment(ref _waiting);
        try
        {
            while (!HasMore(version, out Task next))
            {
                await next.WaitAsync(cancellation).ConfigureAwait(false);
            }

            return true;
        }
        catch (OperationCanceledException)
        {
            return false;
        }
        finally
        {
            Interlocked.Decrement(ref _waiting);
        }
    }

    private static TaskCompletionSource New() => new(TaskCreationOptions.RunContinuationsAsynchronously);

    // Whether there were more changes, or else what to wait for.
    private bool HasMore(long version, out Task next)
    {
        lock (_lock)
        {
            next = _next.Task;
            return Version > version;
        }
    }
}
