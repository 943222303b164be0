namespace RayTracer.RenderTests.Bits;

/// <summary>
/// The committed hashes, <c>hashes.txt</c>: first a log of why they changed, one line "# N. reason" for each change, then one
/// line for each scene: its name, the number of the change that it is from, and its film's hash.
/// </summary>
internal sealed class HashList
{
    private readonly SortedDictionary<string, (int Change, string Hash)> _hashes = new(StringComparer.Ordinal);
    private readonly List<string> _reasons = [];
    private readonly List<string> _head = [];

    /// <summary>Reads the list.</summary>
    public HashList(IEnumerable<string> lines)
    {
        foreach (string line in lines.Where(l => l.Length > 0))
        {
            if (line.StartsWith("# ", StringComparison.Ordinal) && line.Split(". ", 2) is [var number, var reason] && number == $"# {_reasons.Count + 1}")
            {
                _reasons.Add(reason);
            }
            else if (line.StartsWith('#'))
            {
                _head.Add(line);
            }
            else
            {
                string[] words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
                _hashes.Add(words[0], (int.Parse(words[1]), words[2]));
            }
        }
    }

    /// <summary>Where the committed list lies.</summary>
    public static string Path => ProjectFolder.PathOf("tests", "RayTracer.RenderTests", "Bits", "hashes.txt");

    /// <summary>Names of the scenes.</summary>
    public IReadOnlyCollection<string> Scenes => _hashes.Keys;

    /// <summary>Reads the committed list.</summary>
    public static HashList Read() => new(File.ReadLines(Path));

    /// <summary>A scene's hash; empty if it has none.</summary>
    public string HashOf(string scene) => _hashes.TryGetValue(scene, out var entry) ? entry.Hash : "";

    /// <summary>The list's lines with other hashes, where any changed, and the reason.</summary>
    /// <param name="hashes">Hashes of all scenes.</param>
    /// <param name="reason">Why they changed, in one line.</param>
    /// <exception cref="ArgumentException">A hash changed, and there is no reason.</exception>
    public IEnumerable<string> Updated(IReadOnlyDictionary<string, string> hashes, string? reason)
    {
        bool changed = !hashes.OrderBy(h => h.Key, StringComparer.Ordinal).Select(h => (h.Key, h.Value)).SequenceEqual(_hashes.Select(h => (h.Key, h.Value.Hash)));
        if (changed && string.IsNullOrWhiteSpace(reason))
        {
            throw new ArgumentException("Say in RAYTRACER_REASON, in one line, why the pictures changed.", nameof(reason));
        }

        string[] reasons = changed ? [.. _reasons, reason!.Trim()] : [.. _reasons];
        return [
            .. _head, .. reasons.Select((r, i) => $"# {i + 1}. {r}"), "",
            .. hashes.OrderBy(h => h.Key, StringComparer.Ordinal).Select(h => $"{h.Key,-30} {(HashOf(h.Key) == h.Value ? _hashes[h.Key].Change : reasons.Length),3} {h.Value}"),
        ];
    }
}
