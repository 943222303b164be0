using System.IO.Compression;
using System.Text;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Bundles to share: a zip archive of a scene and all files that it names, with names that hold wherever it is unpacked.</summary>
public static class SceneBundle
{
    /// <summary>The largest sum of all files of a bundle, in bytes.</summary>
    public const long MaximumBytes = 1L << 30;

    private const int MostFiles = 10_000;

    /// <summary>Writes a bundle.</summary>
    /// <param name="output">The destination.</param>
    /// <param name="text">The scene.</param>
    /// <param name="place">The document's name and folder.</param>
    /// <returns>The files that the scene names and the bundle does not have.</returns>
    /// <exception cref="SessionException">A file cannot be read, or there is too much.</exception>
    public static IReadOnlyList<string> Write(Stream output, JsonText text, DocumentPlace place)
    {
        using ZipArchive zip = new(output, ZipArchiveMode.Create, leaveOpen: true);
        List<TextEdit> edits = [];
        List<string> missing = [];
        Dictionary<string, string> names = new(StringComparer.Ordinal);
        HashSet<string> taken = new(StringComparer.OrdinalIgnoreCase);
        long left = MaximumBytes;
        foreach (JsonNode node in FileNames.All(text).Select(v => v.Node!))
        {
            string path = Path.GetFullPath(Path.Combine(place.Folder, node.Text));
            bool isModel = ModelFile.IsModel(path);
            if (!File.Exists(path) || !FileNames.IsNamed(path))
            {
                missing.Add(node.Text);
                continue;
            }

            if (!names.TryGetValue(path, out string? name))
            {
                // A model has a folder of its own, in which it finds the files that it names.
                string folder = isModel ? Free($"files/{Path.GetFileNameWithoutExtension(path)}", "", taken) : "files";
                name = isModel ? $"{folder}/{Path.GetFileName(path)}" : Free($"files/{Path.GetFileNameWithoutExtension(path)}", Path.GetExtension(path), taken);
                names.Add(path, name);
                left = Add(zip, name, path, left);
                foreach (string sidecar in isModel ? ModelSidecars.Of(path) : [])
                {
                    left = Add(zip, $"{folder}/{sidecar}", Path.Combine(Path.GetDirectoryName(path)!, sidecar), left);
                }
            }

            edits.Add(new(node.Start, node.End, JsonLayout.Quote(name)));
        }

        using Stream scene = zip.CreateEntry("scene.json").Open();
        scene.Write(Encoding.UTF8.GetBytes(text.With(edits).Text));
        return missing;
    }

    /// <summary>Unpacks a bundle, or any archive with a scene or model in it.</summary>
    /// <param name="path">The archive.</param>
    /// <param name="folder">The folder to fill, empty at first. After an error it is gone.</param>
    /// <returns>The path of the scene in it.</returns>
    /// <exception cref="SessionException">It is no archive, has no scene, is too large, or names files outside of itself.</exception>
    public static string Extract(string path, string folder)
    {
        try
        {
            using ZipArchive zip = ZipFile.OpenRead(path);
            if (zip.Entries.Count > MostFiles)
            {
                throw new SessionException($"the archive has more than {MostFiles} files");
            }

            long left = MaximumBytes;
            foreach (ZipArchiveEntry entry in zip.Entries.Where(e => e.FullName.Length > 0 && !e.FullName.EndsWith('/')))
            {
                left = Extract(entry, folder, left);
            }

            return SceneIn(folder) ?? throw new SessionException($"there is no scene in {Path.GetFileName(path)}");
        }
        catch (Exception e) when (e is InvalidDataException or IOException or UnauthorizedAccessException or NotSupportedException)
        {
            Delete(folder);
            throw new SessionException($"{Path.GetFileName(path)} cannot be unpacked: {e.Message.TrimEnd('.')}", e);
        }
        catch (SessionException)
        {
            Delete(folder);
            throw;
        }
    }

    private static long Add(ZipArchive zip, string name, string path, long left)
    {
        try
        {
            using FileStream file = File.OpenRead(path);
            using Stream entry = zip.CreateEntry(name).Open();
            return left - Bounded.Copy(file, entry, left, $"the scene's files have more than {MaximumBytes >> 20} MiB");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new SessionException($"{path} cannot be read: {e.Message.TrimEnd('.')}", e);
        }
    }

    private static string Free(string stem, string extension, HashSet<string> taken)
    {
        string name = stem + extension;
        for (int i = 2; !taken.Add(name); i++)
        {
            name = $"{stem}-{i}{extension}";
        }

        return name;
    }

    private static long Extract(ZipArchiveEntry entry, string folder, long left)
    {
        string name = entry.FullName.Replace('\\', '/');
        bool isWithin = !name.StartsWith('/') && !name.Contains(':', StringComparison.Ordinal) && !name.Any(char.IsControl)
            && !name.Split('/').Any(part => part is ".." or "." or "");
        string target = isWithin ? Path.GetFullPath(Path.Combine(folder, name)) : "";
        if (!isWithin || !target.StartsWith(Path.GetFullPath(folder) + Path.DirectorySeparatorChar, StringComparison.Ordinal))
        {
            throw new SessionException($"the archive names a file outside itself: {JsonLayout.Quote(entry.FullName)}");
        }

        Directory.CreateDirectory(Path.GetDirectoryName(target)!);
        using Stream content = entry.Open();
        using FileStream file = new(target, FileMode.CreateNew, FileAccess.Write);
        return left - Bounded.Copy(content, file, left, $"the archive holds more than {MaximumBytes >> 20} MiB");
    }

    // The scene nearest to the top; a model where there is none.
    private static string? SceneIn(string folder) => Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories)
        .Where(f => (Path.GetExtension(f).Equals(".json", StringComparison.OrdinalIgnoreCase) && !f.EndsWith(".schema.json", StringComparison.OrdinalIgnoreCase)) || ModelFile.IsModel(f))
        .OrderBy(f => ModelFile.IsModel(f)).ThenBy(f => f.Count(c => c == Path.DirectorySeparatorChar)).ThenBy(f => Path.GetFileName(f) != "scene.json").ThenBy(f => f, StringComparer.Ordinal)
        .FirstOrDefault();

    private static void Delete(string folder)
    {
        try
        {
            Directory.Delete(folder, recursive: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It is cleared away with the session's other uploads.
        }
    }
}
