namespace RayTracer.Session;

/// <summary>The jobs beside the user's work, each on a separate thread.</summary>
/// <param name="notices">Shows how each job ended.</param>
public sealed class JobList(NoticeBoard notices) : IDisposable
{
    private readonly Lock _lock = new();
    private readonly SortedDictionary<int, (Job Job, CancellationTokenSource Stop)> _running = [];
    private readonly List<Task> _tasks = [];
    private int _lastId;

    /// <summary>Raised after each change.</summary>
    public event EventHandler? Changed;

    /// <summary>The jobs that are running.</summary>
    public IReadOnlyList<Job> Running => _lock.Read(() => _running.Values.Select(r => r.Job).ToArray());

    /// <summary>Starts a job.</summary>
    /// <param name="text">The action, in a few words.</param>
    /// <param name="work">Does it; returns the message for the user at the end. What it throws is shown too.</param>
    /// <returns>The job's number.</returns>
    public int Start(string text, Func<IProgress<double>, CancellationToken, string> work)
    {
        int id;
        lock (_lock)
        {
            id = ++_lastId;
            CancellationTokenSource stop = new();
            _running.Add(id, (new(id, text, 0), stop));
            _tasks.RemoveAll(t => t.IsCompleted);
            _tasks.Add(Task.Factory.StartNew(() => Run(id, text, work, stop), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default));
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return id;
    }

    /// <summary>Asks a job to end.</summary>
    /// <exception cref="SessionException">It is not running.</exception>
    public void Cancel(int id)
    {
        lock (_lock)
        {
            if (!_running.TryGetValue(id, out (Job Job, CancellationTokenSource Stop) found))
            {
                throw new SessionException($"Job {id} is not running.", SessionFault.Missing);
            }

            found.Stop.Cancel();
        }
    }

    /// <summary>Asks all jobs to end, and waits until they have.</summary>
    public void Dispose()
    {
        Task[] tasks;
        lock (_lock)
        {
            foreach ((_, CancellationTokenSource stop) in _running.Values)
            {
                stop.Cancel();
            }

            tasks = [.. _tasks];
        }

        Task.WaitAll(tasks);
    }

    private void Run(int id, string text, Func<IProgress<double>, CancellationToken, string> work, CancellationTokenSource stop)
    {
        try
        {
            notices.Post("info", work(new Progress(this, id), stop.Token));
        }
        catch (OperationCanceledException)
        {
            notices.Post("info", $"{text}: cancelled");
        }
        catch (Exception e)
        {
            notices.Post("error", $"{text}: {e.Message.TrimEnd('.')}");
        }
        finally
        {
            lock (_lock)
            {
                _running.Remove(id);
            }

            stop.Dispose();
            Changed?.Invoke(this, EventArgs.Empty);
        }
    }

    private void Report(int id, double fraction)
    {
        lock (_lock)
        {
            if (_running.TryGetValue(id, out (Job Job, CancellationTokenSource Stop) found))
            {
                _running[id] = (found.Job with { Fraction = fraction }, found.Stop);
            }
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    private sealed class Progress(JobList list, int id) : IProgress<double>
    {
        public void Report(double value) => list.Report(id, value);
    }
}

/// <summary>Something that takes its time, and can be cancelled.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Text">The work, in a few words.</param>
/// <param name="Fraction">The progress, 0 to 1.</param>
public sealed record Job(int Id, string Text, double Fraction);
