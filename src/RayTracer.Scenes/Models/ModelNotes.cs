namespace RayTracer.Scenes;

/// <summary>The notes about a model besides errors: things that were ignored, changed or made up. Each is reported once.</summary>
internal sealed class ModelNotes
{
    // Nobody reads more, and a hostile file could make millions.
    private const int Most = 100;

    private readonly List<string> _notes = [];
    private readonly Dictionary<string, int> _counts = new(StringComparer.Ordinal);

    /// <summary>The notes in the order in which they first came up, with how often where it was more than once.</summary>
    public IReadOnlyList<string> All => [.. _notes.Select(n => _counts[n] > 1 ? $"{n} ({_counts[n]} times)" : n)];

    /// <summary>Takes a note: a clause without a final stop.</summary>
    public void Add(string note)
    {
        if (_counts.TryGetValue(note, out int count))
        {
            _counts[note] = count + 1;
        }
        else if (_notes.Count < Most)
        {
            _notes.Add(note);
            _counts.Add(note, 1);
        }
    }
}
