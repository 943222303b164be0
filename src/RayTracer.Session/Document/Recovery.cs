using System.Text.Json;

namespace RayTracer.Session;

/// <summary>
/// Keeps a document's text while it is not saved, at most a moment after each change, so that it is found again after a crash. Every session has a
/// separate file, which it holds a lock for; only what no living session holds is offered.
/// </summary>
public sealed class Recovery : IDisposable
{
    private static readonly TimeSpan s_delay = TimeSpan.FromSeconds(1);

    private readonly Lock _lock = new();
    private readonly SceneDocument _document;
    private readonly UserFolders _folders;
    private readonly TimeProvider _time;
    private readonly ITimer _timer;
    private readonly string _id = Guid.NewGuid().ToString("N");
    private IReadOnlyList<RecoveryEntry> _entries;
    private FolderLock? _hold;
    private int _seen;
    private bool _isWaiting;
    private bool _isDisposed;

    /// <summary>Looks for texts of sessions that have ended, and begins to keep that of a document.</summary>
    /// <param name="document">The document.</param>
    /// <param name="folders">The user's folders.</param>
    /// <param name="time">The clock.</param>
    public Recovery(SceneDocument document, UserFolders folders, TimeProvider? time = null)
    {
        (_document, _folders, _time) = (document, folders, time ?? TimeProvider.System);
        _timer = _time.CreateTimer(_ => Flush(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        _entries = Find();
        _seen = document.Revision;
        _document.Changed += Watch;
    }

    /// <summary>Raised when other texts are offered.</summary>
    public event Action? Changed;

    /// <summary>The texts of sessions that have ended without saving them, newest first.</summary>
    public IReadOnlyList<RecoveryEntry> Entries => _lock.Read(() => _entries);

    private string OwnFile => FileOf(_id);

    /// <summary>Forgets a text.</summary>
    /// <param name="id">Which.</param>
    /// <exception cref="SessionException">There is no such text.</exception>
    public void Discard(string id)
    {
        string? film = KeptFilm.FileOf(_folders, id);
        using (film is null ? Hold(id) : null)
        {
            try
            {
                if (film is null)
                {
                    File.Delete(FileOf(id));
                }
                else
                {
                    Directory.Delete(Path.GetDirectoryName(film)!, recursive: true);
                }
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                throw new SessionException($"the recovered text cannot be deleted: {e.Message.TrimEnd('.')}", e);
            }
        }

        Refresh();
    }

    /// <summary>Looks for texts of sessions that have ended meanwhile.</summary>
    public void Refresh()
    {
        lock (_lock)
        {
            _entries = Find();
        }

        Changed?.Invoke();
    }

    /// <summary>Keeps the document's text now if it is not saved, and forgets the one kept if it is.</summary>
    public void Flush()
    {
        lock (_lock)
        {
            _isWaiting = false;
            if (_isDisposed)
            {
                return;
            }

            try
            {
                if (_document.IsDirty)
                {
                    Keep();
                }
                else
                {
                    Forget();
                }
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                // A full disk must not stop the work; the next change tries again.
            }
        }
    }

    /// <summary>Keeps what is not saved, and lets go of it, so that a later session finds it.</summary>
    public void Dispose()
    {
        _document.Changed -= Watch;
        _timer.Dispose();
        Flush();
        lock (_lock)
        {
            _isDisposed = true;
            _hold?.Dispose();
        }
    }

    /// <summary>Reads a text that was kept.</summary>
    /// <exception cref="SessionException">There is no such text.</exception>
    internal RecoveredText Claim(string id)
    {
        using (Hold(id))
        {
            return Read(FileOf(id)) ?? throw Missing();
        }
    }

    /// <summary>Returns the file of a film that was kept, and offers it no longer; null where the identifier is a text's.</summary>
    internal string? ClaimFilm(string id)
    {
        string? film = KeptFilm.FileOf(_folders, id);
        if (film is not null)
        {
            lock (_lock)
            {
                _entries = [.. _entries.Where(e => e.Id != id)];
            }

            Changed?.Invoke();
        }

        return film;
    }

    private static SessionException Missing() => new("that unsaved text no longer exists");

    private static RecoveredText? Read(string path)
    {
        try
        {
            return JsonSerializer.Deserialize<RecoveredText>(File.ReadAllBytes(path)) is { Name: not null, Folder: not null, LineEnd: not null, Text: not null } text ? text : null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException)
        {
            return null;
        }
    }

    private string FileOf(string id) => Path.Combine(_folders.Recovery, id + ".json");

    private string LockOf(string id) => Path.Combine(_folders.Recovery, id + ".lock");

    private FolderLock Hold(string id)
    {
        bool isId = id.Length == 32 && id.All(char.IsAsciiHexDigit);
        return isId && id != _id && File.Exists(FileOf(id)) && FolderLock.TryTake(LockOf(id)) is { } hold ? hold : throw Missing();
    }

    private void Watch()
    {
        bool isDirty = _document.IsDirty;
        lock (_lock)
        {
            int revision = _document.Revision;
            if (revision == _seen && isDirty)
            {
                return;
            }

            _seen = revision;
            if (isDirty && !_isDisposed)
            {
                // From the first change on: who types without a pause has the text kept, too.
                if (!_isWaiting)
                {
                    _timer.Change(s_delay, Timeout.InfiniteTimeSpan);
                }

                _isWaiting = true;
                return;
            }
        }

        Flush();
    }

    private void Keep()
    {
        DocumentPlace place = _document.Place;
        RecoveredText text = new(place.Name, place.Path, place.Folder, place.LineEnd, _time.GetUtcNow().UtcDateTime, _document.Text);
        _hold ??= FolderLock.TryTake(LockOf(_id));
        PrivateFile.Write(OwnFile, JsonSerializer.SerializeToUtf8Bytes(text));
    }

    private void Forget()
    {
        if (_hold is not null)
        {
            File.Delete(OwnFile);
            _hold.Dispose();
            _hold = null;
        }
    }

    private IReadOnlyList<RecoveryEntry> Find()
    {
        List<RecoveryEntry> found = [];
        try
        {
            foreach (string file in Directory.EnumerateFiles(_folders.Recovery, "*.json"))
            {
                string id = Path.GetFileNameWithoutExtension(file);
                if (id == _id)
                {
                    continue;
                }

                using FolderLock? hold = FolderLock.TryTake(LockOf(id));
                if (hold is not null && Read(file) is { } text)
                {
                    found.Add(new(id, text.Name, text.Time));
                }
            }

            found.AddRange(KeptFilm.Find(_folders));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Nothing can be kept there either.
        }

        return [.. found.OrderByDescending(e => e.Time)];
    }
}

/// <summary>A text that was not saved.</summary>
/// <param name="Name">The name that the document had.</param>
/// <param name="Path">Its file; null where it had none.</param>
/// <param name="Folder">The folder from which the files that it names are looked for.</param>
/// <param name="LineEnd">The characters that end a line of its file.</param>
/// <param name="Time">When it was kept.</param>
/// <param name="Text">The text.</param>
public sealed record RecoveredText(string Name, string? Path, string Folder, string LineEnd, DateTime Time, string Text);

/// <summary>A text that was not saved when a session ended.</summary>
/// <param name="Id">The identifier by which it is requested.</param>
/// <param name="Name">The name that the document had.</param>
/// <param name="Time">When it was kept.</param>
/// <param name="IsFilm">True for the film of a picture that was not written to a file.</param>
public sealed record RecoveryEntry(string Id, string Name, DateTime Time, bool IsFilm = false);
