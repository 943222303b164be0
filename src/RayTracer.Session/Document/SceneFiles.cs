using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// Opens and saves documents. What is not saved is not lost without a word: opening is refused unless the caller says that changes may
/// go, and a file is not overwritten that is another one, or that somebody else has changed.
/// </summary>
public sealed class SceneFiles
{
    private readonly SceneDocument _document;
    private readonly UserFolders _folders;
    private readonly Recovery _recovery;
    private readonly Gallery _gallery;
    private readonly RecentFiles _recent;
    private readonly Lock _lock = new();
    private FileStamp _stamp;
    private Before? _before;
    private int _turn;
    private int _cancelled = -1;

    /// <summary>The files of a session.</summary>
    /// <param name="document">The document that they are opened into.</param>
    /// <param name="folders">The user's folders.</param>
    /// <param name="recovery">The texts that were not saved.</param>
    /// <param name="gallery">The shipped scenes.</param>
    public SceneFiles(SceneDocument document, UserFolders folders, Recovery recovery, Gallery gallery)
    {
        (_document, _folders, _recovery, _gallery) = (document, folders, recovery, gallery);
        _recent = new(folders);
        Uploads = new(folders);
    }

    /// <summary>The files that were dropped onto the window.</summary>
    public Uploads Uploads { get; }

    /// <summary>The whole paths of what was opened or saved lately and is still there, newest first.</summary>
    public IReadOnlyList<string> Recent => _recent.All;

    /// <summary>
    /// Raised after a document was opened: with what a film or image says about its rendering, and the film that is resumed; null for
    /// other files.
    /// </summary>
    internal event Action<RenderJob?, FilmStart?>? Opened;

    /// <summary>Returns whether a file can be opened, by its name.</summary>
    public static bool CanOpen(string name) => IsScene(name) || IsImage(name);

    private static bool IsScene(string name) =>
        Path.GetExtension(name).ToLowerInvariant() is ".json" or ".zip" || FilmFile.IsNamed(name) || ModelFile.IsModel(name) || SceneFormat.Of(name) is not null;

    // Those that say which scene they show.
    private static bool IsImage(string name) => ImageFormat.Has(name, ImageFeatures.Texts);

    /// <summary>Begins a new scene.</summary>
    /// <param name="discard">True if changes that were not saved may go.</param>
    /// <exception cref="SessionException">There are such.</exception>
    public void New(bool discard = false)
    {
        Guard(discard);
        Show(SceneTextFile.NewScene, new("new scene.json", null, _folders.Home), isSaved: true);
    }

    /// <summary>
    /// Opens a scene file, a scene of Mitsuba or pbrt or a model file as a new scene that shows it, or a bundle; of a film or an image of the
    /// program the scene that it was rendered from, as it was rendered. A film is resumed.
    /// </summary>
    /// <param name="path">The file's whole path.</param>
    /// <param name="discard">True if changes that were not saved may go.</param>
    /// <exception cref="SessionException">It cannot be opened, or there are such changes; the document is as it was.</exception>
    public void Open(string path, bool discard = false)
    {
        Guard(discard);
        path = Whole(path);
        OpenFile(path, isOwn: true);
        _recent.Add(path);
    }

    /// <summary>Opens a shipped scene, as one that has no file of its own yet.</summary>
    /// <param name="id">Which, as the gallery calls it.</param>
    /// <param name="discard">True if changes that were not saved may go.</param>
    /// <exception cref="SessionException">There is no such scene, or there are such changes.</exception>
    public void OpenGallery(string id, bool discard = false)
    {
        Guard(discard);
        OpenFile(_gallery.PathOf(id), isOwn: false);
    }

    /// <summary>Opens a text that was not saved, as one with unsaved changes.</summary>
    /// <param name="id">Which, as the recovery calls it.</param>
    /// <param name="discard">True if changes that were not saved may go.</param>
    /// <exception cref="SessionException">There is no such text, or there are such changes.</exception>
    public void OpenRecovered(string id, bool discard = false)
    {
        Guard(discard);
        if (_recovery.ClaimFilm(id) is { } film)
        {
            OpenPicture(film, isOwn: false);
            return;
        }

        RecoveredText text = _recovery.Claim(id);
        lock (_lock)
        {
            // What was known of the file is gone: a save over it must be asked for.
            _stamp = default;
        }

        _document.Open(text.Text, new(text.Name, text.Path, text.Folder) { LineEnd = text.LineEnd }, isSaved: false);
        Opened?.Invoke(null, null);
        _recovery.Flush();
        _recovery.Discard(id);
    }

    /// <summary>
    /// Takes a file that was dropped onto the window, and opens it where it is a scene, a model or a bundle; what else a scene may name is
    /// kept beside it.
    /// </summary>
    /// <param name="name">Its name.</param>
    /// <param name="content">Its content.</param>
    /// <param name="discard">True if changes that were not saved may go.</param>
    /// <param name="cancellation">Ends the transfer.</param>
    /// <returns>The file's path, and whether it was opened.</returns>
    /// <exception cref="SessionException">It is too large, or cannot be opened, or there are such changes.</exception>
    public async Task<(string Path, bool IsOpened)> Upload(string name, Stream content, bool discard = false, CancellationToken cancellation = default)
    {
        bool opens = IsScene(name);
        if (opens)
        {
            Guard(discard);
        }

        string path = await Uploads.Add(name, content, cancellation).ConfigureAwait(false);
        if (opens)
        {
            Guard(discard);
            OpenFile(path, isOwn: false);
        }

        return (path, opens);
    }

    /// <summary>Saves the document.</summary>
    /// <param name="path">The file's whole path; null for that which it has.</param>
    /// <param name="overwrite">True if another file, or one that somebody else has changed, may be overwritten.</param>
    /// <returns>The file's path.</returns>
    /// <exception cref="SessionException">It cannot be written, or there is such a file.</exception>
    public string Save(string? path = null, bool overwrite = false)
    {
        lock (_lock)
        {
            DocumentPlace place = _document.Place;
            string target = path is null ? place.Path ?? throw new SessionException("the scene has no file yet: choose where to save it") : Named(Whole(path));
            CheckTarget(target, place, overwrite);
            DocumentPlace moved = DocumentPlace.Of(target) with { LineEnd = place.LineEnd };
            if (moved.Folder != place.Folder && _document.Read.Root is not null)
            {
                // The names of files in the text are meant from where it was.
                _document.Change("file names", null, text => FileNames.Move(text, place.Folder, moved.Folder));
            }

            (string text, int point) = _document.TextToSave();
            SceneTextFile.Write(target, text, place.LineEnd);
            _stamp = FileStamp.Of(target);
            _document.MarkSaved(point, moved);
            _recent.Add(target);
            return target;
        }
    }

    /// <summary>The contents of a folder, for a dialog.</summary>
    /// <param name="path">The folder; null for the user's own.</param>
    /// <param name="isNamed">True if pictures, models and grids are looked for, which a scene may name, instead of what can be opened.</param>
    /// <exception cref="SessionException">It cannot be listed.</exception>
    public FolderListing List(string? path = null, bool isNamed = false) =>
        FolderListing.Of(string.IsNullOrEmpty(path) ? _folders.Home : Whole(path), isNamed ? FileNames.IsNamed : CanOpen);

    private void OpenFile(string path, bool isOwn)
    {
        if (Path.GetExtension(path).Equals(".zip", StringComparison.OrdinalIgnoreCase))
        {
            OpenFile(SceneBundle.Extract(path, Uploads.NewFolder()), isOwn: false);
            return;
        }

        if (FilmFile.IsNamed(path) || IsImage(path))
        {
            OpenPicture(path, isOwn: true);
            return;
        }

        string folder = Path.GetDirectoryName(path)!;
        if (ModelFile.IsModel(path))
        {
            Show(SceneTextFile.ReadModel(path), new(Path.GetFileNameWithoutExtension(path) + ".json", null, folder), isSaved: true);
            return;
        }

        if (SceneFormat.Of(path) is { } format)
        {
            Show(SceneTextFile.ReadForeign(format, path), new(Path.GetFileNameWithoutExtension(path) + ".json", null, folder), isSaved: true);
            return;
        }

        FileStamp stamp = FileStamp.Of(path);
        (string text, string lineEnd) = SceneTextFile.Read(path);
        Show(text, new(Path.GetFileName(path), isOwn ? path : null, folder) { LineEnd = lineEnd }, isSaved: true);
        lock (_lock)
        {
            _stamp = stamp;
        }
    }

    // The scene beside a film of the recovery is nobody's file: it is saved elsewhere.
    private void OpenPicture(string path, bool isOwn)
    {
        FilmStart? start = CarriedFilm.Is(path) ? FilmStart.Read(path) : null;
        RenderJob origin = start is null ? JobOrigin.OfImage(path).Job : JobOrigin.Of(start.Header, path);
        origin = origin with { Scene = Path.GetFullPath(origin.Scene) };
        if (!File.Exists(origin.Scene))
        {
            throw new SessionException($"the scene of {Path.GetFileName(path)} is neither at {origin.Scene} nor beside it");
        }

        bool isChanged = OriginText.IsChanged(origin);
        FileStamp stamp = isChanged ? default : FileStamp.Of(origin.Scene);
        string lineEnd = isChanged ? "\n" : SceneTextFile.Read(origin.Scene).LineEnd;
        string text = OriginText.Of(origin);
        string name = Path.ChangeExtension(Path.GetFileName(origin.Scene), ".json");
        bool isFile = !isChanged && (isOwn || Path.GetDirectoryName(origin.Scene) != Path.GetDirectoryName(path));
        DocumentPlace place = new(name, isFile ? origin.Scene : null, Path.GetDirectoryName(origin.Scene)!) { LineEnd = lineEnd };
        lock (_lock)
        {
            _stamp = stamp;
        }

        Show(text, place, isSaved: true, origin, start);
    }

    /// <summary>
    /// Ends opening: a file that is still read is not opened, and of one whose scene is still built the document before it comes back, as far
    /// as its text; its steps of undo are gone.
    /// </summary>
    public void CancelOpening()
    {
        Before? before;
        lock (_lock)
        {
            _cancelled = _turn;
            before = _document.Content.LastGood is null ? _before : null;
            _stamp = before?.Stamp ?? _stamp;
            _before = null;
        }

        if (before is not null)
        {
            _document.Open(before.Text, before.Place, !before.IsDirty);
            Opened?.Invoke(null, null);
            _recovery.Flush();
        }
    }

    private void Show(string text, DocumentPlace place, bool isSaved, RenderJob? origin = null, FilmStart? start = null)
    {
        lock (_lock)
        {
            if (_cancelled == _turn)
            {
                throw new SessionException("opening was cancelled");
            }

            _before = new(_document.Text, _document.Place, _document.IsDirty, _stamp);
        }

        // A picture was rendered from the scene as it was written, or at a frame whose values are in the text.
        _document.Open(text, place, isSaved, origin is null ? 0 : null);
        Opened?.Invoke(origin, start);
        _recovery.Flush();
    }

    private void Guard(bool discard)
    {
        if (!discard && _document.IsDirty)
        {
            throw new SessionException($"{_document.Place.Name} has unsaved changes", SessionFault.Unsaved);
        }

        lock (_lock)
        {
            _turn++;
        }
    }

    private void CheckTarget(string target, DocumentPlace place, bool overwrite)
    {
        if (overwrite || !File.Exists(target))
        {
            return;
        }

        if (target != place.Path)
        {
            throw new SessionException($"the file {target} exists already", SessionFault.Exists);
        }

        if (FileStamp.Of(target) != _stamp)
        {
            throw new SessionException($"{target} has been changed elsewhere since it was opened here", SessionFault.ChangedOnDisk);
        }
    }

    private sealed record Before(string Text, DocumentPlace Place, bool IsDirty, FileStamp Stamp);

    private static string Whole(string path) => Path.IsPathFullyQualified(path) && !path.Contains('\0', StringComparison.Ordinal)
        ? Path.GetFullPath(path) : throw new SessionException("the file needs an absolute path");

    private static string Named(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".json" => path,
        "" => path + ".json",
        _ => throw new SessionException("scenes are saved as .json files"),
    };
}
