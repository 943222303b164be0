namespace RayTracer.Session;

/// <summary>The contents of a folder, for a dialog.</summary>
/// <param name="Path">The folder's whole path.</param>
/// <param name="Parent">The folder that it is in; null where there is none.</param>
/// <param name="Folders">The names of the folders within, without hidden ones.</param>
/// <param name="Files">The scenes, models and bundles within; or what scenes may name.</param>
public sealed record FolderListing(string Path, string? Parent, IReadOnlyList<string> Folders, IReadOnlyList<ListedFile> Files)
{
    // A dialog of more would be of no use to anybody.
    private const int Most = 5000;

    /// <summary>Lists a folder.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="isFor">Which files, by their names.</param>
    /// <exception cref="SessionException">It cannot be listed.</exception>
    public static FolderListing Of(string folder, Func<string, bool> isFor)
    {
        try
        {
            DirectoryInfo directory = new(folder);
            IEnumerable<FileSystemInfo> entries = directory.EnumerateFileSystemInfos().Where(e => !e.Name.StartsWith('.') && !e.Attributes.HasFlag(FileAttributes.Hidden)).Take(Most);
            FileSystemInfo[] all = [.. entries.OrderBy(e => e.Name, StringComparer.OrdinalIgnoreCase)];
            return new(
                directory.FullName, directory.Parent?.FullName, [.. all.OfType<DirectoryInfo>().Select(d => d.Name)],
                [.. all.OfType<FileInfo>().Where(f => isFor(f.Name)).Select(f => new ListedFile(f.Name, f.Exists ? f.Length : 0, f.LastWriteTimeUtc))]);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new SessionException($"the folder {folder} cannot be listed: {e.Message.TrimEnd('.')}", e);
        }
    }
}

/// <summary>A file in a dialog.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Size">Its length in bytes.</param>
/// <param name="Time">When it was written.</param>
public sealed record ListedFile(string Name, long Size, DateTime Time);
