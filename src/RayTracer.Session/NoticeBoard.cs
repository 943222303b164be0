namespace RayTracer.Session;

/// <summary>The newest message for the user.</summary>
public sealed class NoticeBoard
{
    private readonly Lock _lock = new();

    /// <summary>Raised after each change.</summary>
    public event EventHandler? Changed;

    /// <summary>The newest notice; null before there was one.</summary>
    public Notice? Newest { get; private set; }

    /// <summary>Shows a message.</summary>
    /// <param name="kind">"info" or "error".</param>
    /// <param name="text">A sentence, without a final stop.</param>
    public void Post(string kind, string text)
    {
        lock (_lock)
        {
            Newest = new((Newest?.Id ?? 0) + 1, kind, text);
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }
}

/// <summary>A message that the user sees once.</summary>
/// <param name="Id">Grows with each notice.</param>
/// <param name="Kind">"info" or "error".</param>
/// <param name="Text">A sentence, without a final stop.</param>
public sealed record Notice(int Id, string Kind, string Text);
