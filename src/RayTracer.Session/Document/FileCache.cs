using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>
/// The pictures and models of a document, each read once and kept while it is used, so that an edit of something else does not read them
/// again. A file that has changed is read again. Not thread-safe.
/// </summary>
internal sealed class FileCache
{
    // A file stays for so many builds that do not use it: while its name is being edited, or a comma is missing.
    private const int Patience = 50;

    private readonly Dictionary<(string Path, string How), Entry> _entries = [];
    private int _build;

    /// <summary>The number of files read.</summary>
    public int Reads { get; private set; }

    public Picture ReadPicture(string path, bool raw) => Get(path, raw ? "raw" : "picture", () => ImageFile.Read(path, raw));

    public ImportedModel ReadModel(string path) => Get(path, "model", () => ModelFile.Read(path));

    /// <summary>Begins a build, and forgets what many builds have not used.</summary>
    public void BeginBuild()
    {
        _build++;
        foreach ((string, string) key in _entries.Where(e => e.Value.LastUse < _build - Patience).Select(e => e.Key).ToArray())
        {
            _entries.Remove(key);
        }
    }

    /// <summary>Forgets all.</summary>
    public void Clear() => _entries.Clear();

    private T Get<T>(string path, string how, Func<T> read)
        where T : class
    {
        FileStamp stamp = FileStamp.Of(path);
        if (!_entries.TryGetValue((path, how), out Entry? entry) || entry.Stamp != stamp)
        {
            entry = new(read(), stamp);
            Reads++;
            _entries[(path, how)] = entry;
        }

        entry.LastUse = _build;
        return (T)entry.Content;
    }

    private sealed class Entry(object content, FileStamp stamp)
    {
        public object Content => content;

        public FileStamp Stamp => stamp;

        public int LastUse { get; set; }
    }
}

/// <summary>The length and time of a file, which show whether it is still the one that was read.</summary>
/// <param name="Length">Its length in bytes.</param>
/// <param name="Written">When it was written.</param>
public readonly record struct FileStamp(long Length, DateTime Written)
{
    /// <summary>The stamp of a file; of none where it does not exist.</summary>
    public static FileStamp Of(string path)
    {
        FileInfo file = new(path);
        return file.Exists ? new(file.Length, file.LastWriteTimeUtc) : default;
    }
}
