using System.IO.Compression;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using RayTracer.Imaging;

namespace RayTracer.Labs;

/// <summary>The one file that a student hands in: the sources, and whose they are.</summary>
internal static class HandIn
{
    private const int MostFiles = 200;
    private const int MostBytes = 4 << 20;

    /// <summary>Writes it beside the sources.</summary>
    /// <param name="folder">The student's folder.</param>
    /// <returns>The file.</returns>
    public static string Write(LabFolder folder)
    {
        string path = Path.Combine(folder.Path, $"lab{folder.Card.Lab}-{Slug(folder.Card.Name)}.zip");
        (string Name, byte[] Content)[] sources = [.. folder.Sources.Select(s => (Path.GetRelativePath(folder.Path, s).Replace('\\', '/'), File.ReadAllBytes(s)))];
        CheckSize(sources.Length, sources.Sum(s => (long)s.Content.Length), folder.Path);
        AtomicFile.Write(path, stream =>
        {
            using ZipArchive zip = new(stream, ZipArchiveMode.Create, leaveOpen: true);
            byte[] card = JsonSerializer.SerializeToUtf8Bytes(folder.Card with { Hash = Hash(sources) });
            foreach ((string name, byte[] content) in sources.Prepend((LabFolder.CardName, card)))
            {
                ZipArchiveEntry entry = zip.CreateEntry(name);
                using Stream target = entry.Open();
                target.Write(content);
            }
        });
        return path;
    }

    /// <summary>Unpacks a hand-in, a file or a folder: its sources alone, under names of this program's choice.</summary>
    /// <param name="path">The zip, or the folder that a student worked in.</param>
    /// <param name="target">An empty folder.</param>
    /// <returns>The folder, and whether the sources are those that were handed in.</returns>
    /// <exception cref="LabException">It is no hand-in, or too large.</exception>
    public static (LabFolder Folder, bool IsAsHandedIn) Unpack(string path, string target)
    {
        (LabCard card, (string Name, byte[] Content)[] sources) = Directory.Exists(path) ? Sort(FromFolder(path), path) : Read(File.ReadAllBytes(path), path);
        for (int i = 0; i < sources.Length; i++)
        {
            // The name alone, in a folder with a number: two folders may have files of the same name.
            string name = new([.. sources[i].Name.Split('/', '\\')[^1].Where(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '_' or '-')]);
            DirectoryInfo folder = Directory.CreateDirectory(Path.Combine(target, $"{i}"));
            File.WriteAllBytes(Path.Combine(folder.FullName, name[Math.Max(0, name.Length - 60)..]), sources[i].Content);
        }

        return (new(target, card), card.Hash is null || card.Hash == Hash(sources));
    }

    /// <summary>Reads the zip of a hand-in: whose it is, and its sources, with the paths that they have in it.</summary>
    /// <param name="file">The zip.</param>
    /// <param name="path">What messages call it.</param>
    /// <exception cref="LabException">It is no hand-in, or too large.</exception>
    public static (LabCard Card, (string Name, byte[] Content)[] Sources) Read(byte[] file, string path)
    {
        try
        {
            using ZipArchive zip = new(new MemoryStream(file));
            ZipArchiveEntry[] entries = [.. zip.Entries.Where(e => IsWanted(e.FullName)).Take(MostFiles + 2)];
            CheckSize(entries.Length, entries.Sum(e => e.Length), path);
            return Sort([.. entries.Select(e => (e.FullName, Unzip(e, path)))], path);
        }
        catch (Exception e) when (e is InvalidDataException or NotSupportedException or ArgumentException)
        {
            throw new LabException($"'{path}' is no zip that can be read: {e.Message.ReplaceLineEndings(" ")}");
        }
    }

    private static (LabCard Card, (string Name, byte[] Content)[] Sources) Sort((string Name, byte[] Content)[] files, string path)
    {
        byte[] text = files.FirstOrDefault(f => f.Name == LabFolder.CardName).Content ?? throw new LabException($"'{path}' is no hand-in: it has no {LabFolder.CardName}");
        LabCard card = LabCard.Read(Encoding.UTF8.GetString(text).TrimStart('\uFEFF'), $"{path}/{LabFolder.CardName}");
        return (card, [.. files.Where(f => LabFolder.IsSource(f.Name)).OrderBy(f => f.Name, StringComparer.Ordinal)]);
    }

    private static (string Name, byte[] Content)[] FromFolder(string path)
    {
        // A link may lead out of the folder.
        EnumerationOptions options = new() { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint };
        FileInfo[] files = [.. new DirectoryInfo(path).EnumerateFiles("*", options).Where(f => IsWanted(Path.GetRelativePath(path, f.FullName))).Take(MostFiles + 2)];
        CheckSize(files.Length, files.Sum(f => f.Length), path);
        return [.. files.Select(f => (Path.GetRelativePath(path, f.FullName).Replace('\\', '/'), File.ReadAllBytes(f.FullName)))];
    }

    // What it is unpacked to is counted: what the zip says of its length need not be true.
    private static byte[] Unzip(ZipArchiveEntry entry, string path)
    {
        using Stream stream = entry.Open();
        using MemoryStream content = new();
        byte[] buffer = new byte[1 << 14];
        while (stream.Read(buffer) is > 0 and int count)
        {
            content.Write(buffer, 0, count);
            CheckSize(1, content.Length, path);
        }

        return content.ToArray();
    }

    private static bool IsWanted(string name) => name == LabFolder.CardName || LabFolder.IsSource(name);

    private static void CheckSize(int files, long bytes, string path)
    {
        if (files > MostFiles + 1 || bytes > MostBytes)
        {
            throw new LabException($"'{path}' is too large for a hand-in: at most {MostFiles} files, {MostBytes >> 20} MiB together");
        }
    }

    private static string Hash(IEnumerable<(string Name, byte[] Content)> sources)
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach ((string name, byte[] content) in sources.OrderBy(s => s.Name, StringComparer.Ordinal))
        {
            hash.AppendData(Encoding.UTF8.GetBytes($"{name}\0{content.Length}\0"));
            hash.AppendData(content);
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    private static string Slug(string name)
    {
        string letters = string.Concat(name.ToLowerInvariant().Select(c => char.IsLetterOrDigit(c) ? c : '-')).Trim('-');
        return letters.Length > 0 ? letters : "hand-in";
    }
}
