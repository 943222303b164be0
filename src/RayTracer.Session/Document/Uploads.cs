namespace RayTracer.Session;

/// <summary>The folder of a session in which it keeps what was dropped onto its window.</summary>
/// <param name="folders">The user's folders.</param>
public sealed class Uploads(UserFolders folders) : IDisposable
{
    /// <summary>The largest file, in bytes.</summary>
    public const long MaximumBytes = 512L << 20;

    /// <summary>The largest sum of all files of a session, in bytes.</summary>
    public const long MaximumTotal = 4 * MaximumBytes;

    // So long a text that was not saved may be looked for.
    private static readonly TimeSpan s_kept = TimeSpan.FromDays(14);

    private readonly Lock _lock = new();
    private FolderLock? _hold;
    private string? _folder;
    private long _total;
    private int _bundles;

    /// <summary>Keeps a file, in place of one of the same name.</summary>
    /// <param name="name">Its name; folders in it are left out.</param>
    /// <param name="content">Its content.</param>
    /// <param name="cancellation">Ends the transfer; then there is no file.</param>
    /// <returns>Its whole path.</returns>
    /// <exception cref="SessionException">The name is none, the content is too much, or it cannot be written.</exception>
    public async Task<string> Add(string name, Stream content, CancellationToken cancellation = default)
    {
        string bare = Path.GetFileName(name.Replace('\\', '/'));
        if (bare.Length is 0 or > 200 || bare.StartsWith('.') || bare.Any(c => char.IsControl(c) || c is ':' or '*' or '?' or '"' or '<' or '>' or '|'))
        {
            throw new SessionException("the file needs a name that is valid on every system");
        }

        string path = Path.Combine(Folder(), bare);
        string temporary = Path.Combine(Folder(), $".{Guid.NewGuid():N}.tmp");
        try
        {
            FileStream stream = new(temporary, FileMode.CreateNew, FileAccess.Write);
            await using (stream.ConfigureAwait(false))
            {
                long most = Math.Min(MaximumBytes, MaximumTotal - Interlocked.Read(ref _total));
                long length = await Bounded.CopyAsync(content, stream, most, $"{bare} is too large: files of up to {MaximumBytes >> 20} MiB are accepted", cancellation).ConfigureAwait(false);
                Interlocked.Add(ref _total, length);
            }

            File.Move(temporary, path, overwrite: true);
            return path;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new SessionException($"{bare} cannot be kept: {e.Message.TrimEnd('.')}", e);
        }
        finally
        {
            File.Delete(temporary);
        }
    }

    /// <summary>Makes a folder for the files of a bundle.</summary>
    public string NewFolder() => UserFolders.Make(Path.Combine(Folder(), $"bundle {Interlocked.Increment(ref _bundles)}"));

    /// <summary>Lets go of the folder; it is cleared away by a later session.</summary>
    public void Dispose() => _hold?.Dispose();

    private string Folder()
    {
        lock (_lock)
        {
            if (_folder is null)
            {
                ClearOld();
                _folder = UserFolders.Make(Path.Combine(folders.Uploads, Guid.NewGuid().ToString("N")));
                _hold = FolderLock.TryTake(_folder + ".lock");
            }

            return _folder;
        }
    }

    // Of sessions that have ended long ago.
    private void ClearOld()
    {
        foreach (string old in Directory.EnumerateDirectories(folders.Uploads).Where(f => Directory.GetLastWriteTimeUtc(f) < DateTime.UtcNow - s_kept).ToArray())
        {
            using FolderLock? hold = FolderLock.TryTake(old + ".lock");
            if (hold is not null)
            {
                try
                {
                    Directory.Delete(old, recursive: true);
                }
                catch (Exception e) when (e is IOException or UnauthorizedAccessException)
                {
                    // Another time.
                }
            }
        }
    }
}
