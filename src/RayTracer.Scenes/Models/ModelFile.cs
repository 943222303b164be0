using System.Collections.Concurrent;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>The formats of model files, by their extensions; RayTracer.Import registers those that it reads.</summary>
public static class ModelFile
{
    private static readonly ConcurrentDictionary<string, Func<string, ImportedModel>> Readers = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>The extensions of the formats that are read, with their dots.</summary>
    public static IReadOnlyCollection<string> Extensions => [.. Readers.Keys.Order(StringComparer.Ordinal)];

    /// <summary>Adds a format, before the first scene is read.</summary>
    /// <param name="extension">The extension, with its dot; upper and lower case are the same.</param>
    /// <param name="read">Reads the file of a path; throws <see cref="ModelException"/> where something is wrong with it.</param>
    public static void Register(string extension, Func<string, ImportedModel> read) => Readers[extension] = read;

    /// <summary>True where a path has the extension of a format that is read.</summary>
    public static bool IsModel(string path) => Readers.ContainsKey(Path.GetExtension(path));

    /// <summary>Reads a model.</summary>
    /// <param name="path">The file's path; files that it names are looked for from its folder.</param>
    /// <exception cref="ModelException">It is of no format that is read, or something is wrong with it.</exception>
    /// <exception cref="IOException">It cannot be opened.</exception>
    public static ImportedModel Read(string path)
    {
        string extension = Path.GetExtension(path);
        return Readers.TryGetValue(extension, out Func<string, ImportedModel>? read) ? read(path) : throw new ModelException(
            $"{(extension.Length > 0 ? Quotation.Of(extension) : "a file without an extension")} is not a model format that can be read:  "
            + (Extensions.Count > 0 ? string.Join(", ", Extensions) : "programs register the formats of RayTracer.Import by Importers.Register()"));
    }
}

/// <summary>The notes about a model besides errors: things that were ignored, changed or made up. Each is reported once.</summary>
internal sealed class ModelNotes
{
    // Nobody reads more, and a hostile file could make millions.
    private const int Most = 100;

    private readonly List<string> _notes = [];
    private readonly Dictionary<string, int> _counts = new(StringComparer.Ordinal);

    /// <summary>The notes in the order in which they first came up, with how often where it was more than once.</summary>
    public IReadOnlyList<string> All => [.. _notes.Select(n => _counts[n] > 1 ? $"{n} ({_counts[n]} times)" : n)];

    /// <summary>Takes a note where a condition holds.</summary>
    public void AddIf(bool condition, string note)
    {
        if (condition)
        {
            Add(note);
        }
    }

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
