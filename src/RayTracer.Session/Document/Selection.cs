using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>The selected thing of a document. A thing that no longer exists is not selected.</summary>
/// <param name="document">The document.</param>
public sealed class Selection(SceneDocument document)
{
    private readonly Lock _lock = new();
    private string? _pointer;

    /// <summary>Another thing is selected.</summary>
    public event Action? Changed;

    /// <summary>The pointer of the selected thing; null where there is none.</summary>
    public string? Pointer
    {
        get
        {
            lock (_lock)
            {
                // While the text cannot be parsed, nobody knows.
                return _pointer is null || document.Read.Root is not { } root || JsonPointer.Find(root, _pointer) is not null ? _pointer : null;
            }
        }
    }

    /// <summary>Selects a thing.</summary>
    /// <param name="pointer">Its pointer; null selects nothing.</param>
    /// <exception cref="SessionException">There is no such thing.</exception>
    public void Select(string? pointer)
    {
        if (pointer is not null && document.Read.Root is { } root && JsonPointer.Find(root, pointer) is null)
        {
            throw new SessionException($"there is nothing at {JsonLayout.Quote(pointer)}");
        }

        lock (_lock)
        {
            if (_pointer == pointer)
            {
                return;
            }

            _pointer = pointer;
        }

        Changed?.Invoke();
    }
}
