using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>
/// A folder of the recovery for one film, and for its scene where that is in no file. It is held as long as this lives; what it holds when
/// nobody does is offered to later sessions.
/// </summary>
internal sealed class KeptFilm : IDisposable
{
    // Films are large: only so many are offered.
    private const int Most = 8;
    private readonly string _folder;
    private readonly FolderLock? _hold;

    /// <summary>Reserves a folder.</summary>
    /// <param name="folders">The user's folders.</param>
    /// <param name="name">The name of the document.</param>
    public KeptFilm(UserFolders folders, string name)
    {
        _folder = System.IO.Path.Combine(folders.RecoveredFilms, Guid.NewGuid().ToString("N"));
        _hold = FolderLock.TryTake(_folder + ".lock");
        UserFolders.Make(_folder);
        Path = System.IO.Path.Combine(_folder, System.IO.Path.GetFileNameWithoutExtension(name) + Extension);
    }

    private static string Extension => ".rtfilm";

    /// <summary>The film's file.</summary>
    public string Path { get; }

    /// <summary>Returns the films that no living session holds, newest first.</summary>
    public static IEnumerable<RecoveryEntry> Find(UserFolders folders)
    {
        List<RecoveryEntry> found = [];
        foreach (DirectoryInfo folder in new DirectoryInfo(folders.RecoveredFilms).EnumerateDirectories())
        {
            using FolderLock? hold = FolderLock.TryTake(folder.FullName + ".lock");
            if (hold is not null && folder.EnumerateFiles("*" + Extension).FirstOrDefault() is { } film)
            {
                found.Add(new(folder.Name, System.IO.Path.GetFileNameWithoutExtension(film.Name), film.LastWriteTimeUtc, IsFilm: true));
            }
        }

        found.Sort((a, b) => b.Time.CompareTo(a.Time));
        found.Skip(Most).ToList().ForEach(old => Directory.Delete(System.IO.Path.Combine(folders.RecoveredFilms, old.Id), recursive: true));
        return found.Take(Most);
    }

    /// <summary>Returns the file of a film that was kept; null where there is none.</summary>
    public static string? FileOf(UserFolders folders, string id) =>
        Guid.TryParseExact(id, "N", out _) && new DirectoryInfo(System.IO.Path.Combine(folders.RecoveredFilms, id)) is { Exists: true } folder
            ? folder.EnumerateFiles("*" + Extension).FirstOrDefault()?.FullName : null;

    /// <summary>Forgets the film.</summary>
    public void Delete() => Directory.Delete(_folder, recursive: true);

    /// <summary>Lets go of the film, so that a later session finds it.</summary>
    public void Dispose()
    {
        try
        {
            if (Directory.Exists(_folder) && !File.Exists(Path))
            {
                Delete();
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // An empty folder does no harm.
        }

        _hold?.Dispose();
    }
}
