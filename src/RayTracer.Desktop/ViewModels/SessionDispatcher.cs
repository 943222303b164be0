using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>
/// Carries the user's wishes to the session, one after another, on threads of the pool: the window's thread waits for none of them.
/// </summary>
/// <param name="session">The session.</param>
/// <param name="messages">Shows what could not be done.</param>
internal sealed class SessionDispatcher(StudioSession session, MessagesViewModel messages)
{
    private Task _last = Task.CompletedTask;

    /// <summary>The messages for the user.</summary>
    public MessagesViewModel Messages => messages;

    /// <summary>Ends when all is done that was asked for so far.</summary>
    public Task Idle => _last;

    /// <summary>Has the session do something; what it cannot do is reported to the user.</summary>
    public void Do(Action<StudioSession> work) => _ = Attempt(() => Ask(session =>
    {
        work(session);
        return true;
    }));

    /// <summary>Asks the session, after all that was asked for before.</summary>
    public Task<T> Ask<T>(Func<StudioSession, T> question)
    {
        Task before = _last;
        Task<T> answer = Task.Run(async () =>
        {
            await before.ConfigureAwait(false);
            return question(session);
        });
        _last = answer.ContinueWith(_ => { }, CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        return answer;
    }

    /// <summary>Asks the session for what takes its time; nothing else waits for it.</summary>
    public Task<T> Aside<T>(Func<StudioSession, Task<T>> question) => Task.Run(() => question(session));

    /// <summary>Does something, and reports errors to the user; returns whether there were none.</summary>
    public async Task<bool> Attempt(Func<Task> work)
    {
        try
        {
            await work();
            return true;
        }
        catch (OperationCanceledException)
        {
            return false;
        }
        catch (Exception e)
        {
            messages.Say("error", Complaint.Of(e) ?? SessionTexts.Of("messages.pageError", e.Message));
            return false;
        }
    }
}
