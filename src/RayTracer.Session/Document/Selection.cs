using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// The selected things of a document: one whose properties are shown, and others to which is done what is done to it. A thing that no longer exists is
/// not selected.
/// </summary>
/// <param name="document">The document.</param>
public sealed class Selection(SceneDocument document)
{
    private readonly Lock _lock = new();
    private string[] _all = [];

    /// <summary>Other things are selected.</summary>
    public event Action? Changed;

    /// <summary>The pointer of the thing that was selected last; null where there is none.</summary>
    public string? Pointer => All is [.., string last] ? last : null;

    /// <summary>The pointers of all selected things, in the order of their selection.</summary>
    public IReadOnlyList<string> All
    {
        get
        {
            // While the text cannot be parsed, nobody knows.
            string[] all = _lock.Read(() => _all);
            return document.Read.Root is { } root ? [.. all.Where(p => JsonPointer.Find(root, p) is not null)] : all;
        }
    }

    /// <summary>The things that an edit of one changes: all that are selected where it is one of them, without those that are parts of others.</summary>
    public IReadOnlyList<string> With(string pointer) => All is var all && all.Contains(pointer)
        ? [.. all.Where(p => !all.Any(other => other != p && Picking.IsWithin(p, other)))]
        : [pointer];

    /// <summary>Selects a thing.</summary>
    /// <param name="pointer">Its pointer; null selects nothing.</param>
    /// <exception cref="SessionException">There is no such thing.</exception>
    public void Select(string? pointer) => SelectAll(pointer is null ? [] : [pointer]);

    /// <summary>Selects a thing beside those that are selected; or no longer, if it was.</summary>
    /// <param name="pointer">Its pointer.</param>
    /// <exception cref="SessionException">There is no such thing.</exception>
    public void Toggle(string pointer) => SelectAll(All is var all && all.Contains(pointer) ? [.. all.Where(p => p != pointer)] : [.. all, pointer]);

    /// <summary>Selects some things and no others.</summary>
    /// <param name="pointers">Their pointers.</param>
    /// <exception cref="SessionException">There is no such thing.</exception>
    public void SelectAll(params string[] pointers)
    {
        if (document.Read.Root is { } root && Array.Find(pointers, p => JsonPointer.Find(root, p) is null) is { } missing)
        {
            throw new SessionException($"there is nothing at {JsonLayout.Quote(missing)}");
        }

        lock (_lock)
        {
            if (_all.SequenceEqual(pointers))
            {
                return;
            }

            _all = pointers;
        }

        Changed?.Invoke();
    }
}
