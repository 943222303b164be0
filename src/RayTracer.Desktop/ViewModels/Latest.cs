namespace RayTracer.Desktop.ViewModels;

/// <summary>While something is on its way, only the newest of what follows waits; so that fast movements never lag.</summary>
/// <param name="send">Sends it; reports errors by itself.</param>
/// <param name="merge">Makes one of what waits and what comes; null where the newer one counts.</param>
internal sealed class Latest<T>(Func<T, Task> send, Func<T, T, T>? merge = null)
{
    private readonly Queue<T> _waiting = new();
    private bool _isOnTheWay;

    /// <summary>Sends something, at once or as soon as there is nothing on its way.</summary>
    public async void Push(T item)
    {
        if (_isOnTheWay)
        {
            T newest = _waiting.TryDequeue(out T? before) && merge is not null ? merge(before, item) : item;
            _waiting.Enqueue(newest);
            return;
        }

        _isOnTheWay = true;
        do
        {
            await send(item);
        }
        while (_waiting.TryDequeue(out item!));

        _isOnTheWay = false;
    }
}
