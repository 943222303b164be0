using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// A scene's text as it is edited. Each change is one of the text, and can be undone. The scene is built behind the edits: an edit never
/// waits for it, and a text that is no scene leaves the last good one where it is. All members may be called by any thread.
/// </summary>
public sealed class SceneDocument : IDisposable
{
    private readonly Lock _lock = new();
    private readonly UndoHistory _history = new();
    private readonly SceneBuilds _builds;
    private string _text;
    private int _revision = 1;
    private Lazy<SceneReadResult> _read;
    private DocumentPlace _place;
    private int? _frame = 0;
    private bool _isRecording;
    private ThingMarks _hidden = ThingMarks.None;
    private ThingMarks _locked = ThingMarks.None;

    /// <summary>A document that has no file yet.</summary>
    /// <param name="text">Its text.</param>
    /// <param name="place">The document's name, and the folder in which files are looked for.</param>
    public SceneDocument(string text, DocumentPlace place)
    {
        _text = Normal(text);
        _place = place;
        _read = ReadLater(_text, place.Name);
        _history.Reset(isSaved: true);
        _builds = new SceneBuilds(() => Changed?.Invoke());
        Build();
    }

    /// <summary>
    /// The text, its place, what is built of it or whether it is saved has changed. Raised by the thread that changed it, without a lock.
    /// </summary>
    public event Action? Changed;

    /// <summary>The newest text that has been built, and what it came to; a moment behind <see cref="Text"/> after an edit.</summary>
    public DocumentContent Content => _builds.Content;

    /// <summary>The revision of <see cref="Text"/>: grows with every change.</summary>
    public int Revision => Current.Revision;

    /// <summary>The text, with \n at each line's end.</summary>
    public string Text => Current.Text;

    /// <summary>The text and its revision.</summary>
    public (int Revision, string Text) Current => _lock.Read(() => (_revision, _text));

    /// <summary>The result of reading the current text, without building it.</summary>
    public SceneReadResult Read => _lock.Read(() => _read.Value);

    /// <summary>
    /// The newest text that is JSON at least, for views of its content: while somebody types, the text is none at every other
    /// key.
    /// </summary>
    /// <exception cref="SessionException">There was none yet.</exception>
    public (int Revision, JsonNode Root) Readable
    {
        get
        {
            (int revision, SceneReadResult read) = (Revision, Read);
            return read.Root is { } root ? (revision, root)
                : Content.LastGood is { } good ? (good.Revision, good.Read.Root!)
                : throw new SessionException("the text cannot be read yet");
        }
    }

    /// <summary>The document's place.</summary>
    public DocumentPlace Place => _lock.Read(() => _place);

    /// <summary>The frame of the animation that is shown, and at which edits of animated values write keys; null for the scene as it is written.</summary>
    public int? Frame => _lock.Read(() => _frame);

    /// <summary>Whether what hands change in the picture becomes keys at the frame that is shown.</summary>
    public bool IsRecording
    {
        get => _lock.Read(() => _isRecording);

        internal set
        {
            lock (_lock)
            {
                (_isRecording, RecordingComplaint) = (value, null);
            }
        }
    }

    /// <summary>Why the last such change is no key; null where it is.</summary>
    public string? RecordingComplaint { get; private set; }

    /// <summary>The things that are left out of the view.</summary>
    public IReadOnlyList<string> Hidden => _lock.Read(() => _hidden).Pointers;

    /// <summary>The things that cannot be picked or dragged in the picture.</summary>
    public IReadOnlyList<string> Locked => _lock.Read(() => _locked).Pointers;

    /// <summary>Returns whether there are unsaved changes.</summary>
    public bool IsDirty => _lock.Read(() => !_history.IsSaved);

    /// <summary>The status of the document.</summary>
    public DocumentStatus Status
    {
        get
        {
            DocumentContent content = Content;
            lock (_lock)
            {
                return new(
                    _revision, _place.Name, _place.Path, !_history.IsSaved, _history.ToUndo is not null, _history.ToRedo is not null,
                    _history.ToUndo?.Label, _history.ToRedo?.Label, _builds.DiagnosticsOf(content), content.Load.Scene is not null, content.Revision)
                {
                    Document = _builds.Document,
                    HasPicture = content.LastGood is not null,
                    Reading = _builds.Reading,
                };
            }
        }
    }

    /// <summary>The number of pictures and models read in all builds.</summary>
    internal int FilesRead => _builds.FilesRead;

    /// <summary>The content of the text as it is now, as soon as it is built.</summary>
    public Task<DocumentContent> WhenBuilt(CancellationToken cancellation = default) => _builds.WhenBuilt(Revision, cancellation);

    /// <summary>Replaces a part of the text, as an editor does.</summary>
    /// <param name="baseRevision">The revision that the offsets are of.</param>
    /// <param name="from">Offset of the part.</param>
    /// <param name="to">Offset behind it.</param>
    /// <param name="insert">The text that replaces it.</param>
    /// <param name="gesture">The gesture that it is a part of; null where it is to be undone by itself.</param>
    /// <returns>True if the revision was the newest; otherwise nothing has changed.</returns>
    /// <exception cref="SessionException">There is no such part.</exception>
    public bool TryReplace(int baseRevision, int from, int to, string insert, string? gesture)
    {
        lock (_lock)
        {
            if (baseRevision != _revision)
            {
                return false;
            }

            if (from < 0 || to < from || to > _text.Length)
            {
                throw new SessionException($"the text has {_text.Length} characters, but from {from} to {to} was to be replaced");
            }

            if (!TryAccept(string.Concat(_text.AsSpan(0, from), Normal(insert), _text.AsSpan(to)), "typing", gesture))
            {
                return true;
            }
        }

        Build();
        return true;
    }

    /// <summary>Shows another frame of the animation; a scene without one does not change.</summary>
    /// <param name="frame">The frame; null for the scene as it is written.</param>
    /// <exception cref="SessionException">There is no such frame.</exception>
    public void ShowFrame(int? frame)
    {
        if (frame is < 0 or > FrameTimes.Last)
        {
            throw new SessionException($"Frames are numbered from 0 to {FrameTimes.Last}.");
        }

        lock (_lock)
        {
            _frame = frame;
        }

        Build();
    }

    /// <summary>Leaves things out of the view, or shows them again; what is written to files has them all the same.</summary>
    /// <param name="pointers">The things: shapes or lights.</param>
    /// <param name="areHidden">Whether they shall be hidden.</param>
    /// <exception cref="SessionException">There is no such thing, or the text is no JSON at the moment.</exception>
    public void Hide(IEnumerable<string> pointers, bool areHidden)
    {
        lock (_lock)
        {
            _hidden = _hidden.With(JsonText.Of(_read.Value), pointers, areHidden);
        }

        Build();
    }

    /// <summary>Keeps things from being picked or dragged in the picture, or no longer.</summary>
    /// <param name="pointers">The things: shapes or lights.</param>
    /// <param name="areLocked">Whether they shall be locked.</param>
    /// <exception cref="SessionException">There is no such thing, or the text is no JSON at the moment.</exception>
    public void Lock(IEnumerable<string> pointers, bool areLocked)
    {
        lock (_lock)
        {
            _locked = _locked.With(JsonText.Of(_read.Value), pointers, areLocked);
        }

        Changed?.Invoke();
    }

    /// <summary>Returns whether a thing is locked, or one that it is a part of.</summary>
    public bool IsLocked(string? pointer) => _lock.Read(() => _locked).Has(pointer);

    /// <summary>Changes the text as a whole, as panels and gizmos do. A change of an animated value writes a key at the frame that is shown.</summary>
    /// <param name="label">The change in a word or two, for undo.</param>
    /// <param name="gesture">The gesture that it is a part of; null where it is to be undone by itself.</param>
    /// <param name="change">Makes the new text of the present one; what it throws passes through, and nothing has changed.</param>
    /// <returns>The revision after it.</returns>
    /// <exception cref="SessionException">The text is no JSON at the moment.</exception>
    public int Change(string label, string? gesture, Func<JsonText, JsonText> change) => Change(label, gesture, change, isByHand: false);

    /// <summary>As the other, for changes by a hand in the picture, which are recorded as keys while that is wanted.</summary>
    /// <param name="label">The change in a word or two, for undo.</param>
    /// <param name="gesture">The gesture that it is a part of.</param>
    /// <param name="change">Makes the new text of the present one.</param>
    /// <param name="isByHand">Whether it is such a change.</param>
    internal int Change(string label, string? gesture, Func<JsonText, JsonText> change, bool isByHand)
    {
        lock (_lock)
        {
            JsonText text = JsonText.Of(_read.Value);
            if (!TryAccept((isByHand && _isRecording ? Recorded(text, change) : KeyedEdit.Apply(text, _frame, change)).Text, label, gesture))
            {
                return _revision;
            }
        }

        Build();
        return Revision;
    }

    /// <summary>Takes the last step back, if there is one.</summary>
    public void Undo() => Step(undo: true);

    /// <summary>Does the step again that was undone last, if there is one.</summary>
    public void Redo() => Step(undo: false);

    /// <summary>Puts another text in the place of this one, without a way back.</summary>
    /// <param name="text">The text.</param>
    /// <param name="place">The document's name and folder.</param>
    /// <param name="isSaved">True if it is safe to lose: the text of a file.</param>
    /// <param name="frame">The frame to show; null for the scene as it is written.</param>
    public void Open(string text, DocumentPlace place, bool isSaved, int? frame = 0)
    {
        lock (_lock)
        {
            _frame = frame;
            _hidden = _locked = ThingMarks.None;
            (_isRecording, RecordingComplaint) = (false, null);
            _text = Normal(text);
            _place = place;
            _revision++;
            _read = ReadLater(_text, place.Name);
            _history.Reset(isSaved);
            _builds.Abandon();
        }

        Build();
    }

    /// <summary>The text to save, with the point in its history that <see cref="MarkSaved"/> asks for.</summary>
    internal (string Text, int Point) TextToSave() => _lock.Read(() => (_text, _history.Seal()));

    /// <summary>Records that the text of a point in the history is now in a file.</summary>
    internal void MarkSaved(int point, DocumentPlace place)
    {
        lock (_lock)
        {
            bool isMoved = place != _place;
            _history.MarkSaved(point);
            _place = place;
            if (isMoved)
            {
                _revision++;
                _read = ReadLater(_text, place.Name);
            }
        }

        Build();
    }

    /// <summary>Stops building.</summary>
    public void Dispose() => _builds.Dispose();

    private JsonText Recorded(JsonText text, Func<JsonText, JsonText> change)
    {
        if (_frame is { } frame)
        {
            (text, RecordingComplaint) = RecordedEdit.Apply(text, frame, change);
            return text;
        }

        RecordingComplaint = "The scene is shown as it is written: choose a frame to record keys.";
        return change(text);
    }

    private void Step(bool undo)
    {
        lock (_lock)
        {
            if ((undo ? _history.Undo() : _history.Redo()) is not { } change)
            {
                return;
            }

            SetText(change.Apply(_text));
        }

        Build();
    }

    // Whether anything has changed.
    private bool TryAccept(string after, string label, string? gesture)
    {
        if (after == _text)
        {
            return false;
        }

        _history.Add(TextChange.Between(_text, after), _text, label, gesture);
        SetText(after);
        return true;
    }

    private void SetText(string text)
    {
        _text = text;
        _revision++;
        _read = ReadLater(text, _place.Name);
        if (_hidden.Pointers.Count + _locked.Pointers.Count > 0 && _read.Value.Root is not null)
        {
            // While somebody types, they stay what they were.
            JsonText now = JsonText.Of(_read.Value);
            (_hidden, _locked) = (_hidden.In(now), _locked.In(now));
        }
    }

    private void Build()
    {
        lock (_lock)
        {
            _builds.Want(_revision, _text, _read, _place.Folder, _frame, _hidden.Pointers);
        }

        Changed?.Invoke();
    }

    private static Lazy<SceneReadResult> ReadLater(string text, string name) => new(() => SceneReader.ReadText(text, name));

    // One character for each line's end and no byte order mark, so that offsets are those of every editor.
    private static string Normal(string text) => text.ReplaceLineEndings("\n").TrimStart('\uFEFF');
}

/// <summary>The status of a document: all that is shown beside its text.</summary>
/// <param name="Revision">The text's revision.</param>
/// <param name="Name">The document's name.</param>
/// <param name="Path">The whole path of its file; null where it has none yet.</param>
/// <param name="IsDirty">True if there are changes that were not saved.</param>
/// <param name="CanUndo">True if there is a step to undo.</param>
/// <param name="CanRedo">True if there is a step to do again.</param>
/// <param name="UndoLabel">The change that undo takes back, in words; null where there is none.</param>
/// <param name="RedoLabel">The change that redo makes again, in words; null where there is none.</param>
/// <param name="Diagnostics">The faults of the text that was built last.</param>
/// <param name="IsGood">True if a scene could be built from that text.</param>
/// <param name="BuiltRevision">The revision of that text: that of the text itself once it is built.</param>
public sealed record DocumentStatus(
    int Revision, string Name, string? Path, bool IsDirty, bool CanUndo, bool CanRedo, string? UndoLabel, string? RedoLabel,
    IReadOnlyList<PlacedDiagnostic> Diagnostics, bool IsGood, int BuiltRevision)
{
    /// <summary>The number of the document: grows whenever another one is opened.</summary>
    public int Document { get; init; }

    /// <summary>True if a scene could be built since it was opened: there is a valid picture to show.</summary>
    public bool HasPicture { get; init; }

    /// <summary>The name of the file that is read for it just now; null where none is.</summary>
    public string? Reading { get; init; }
}

/// <summary>The place of a document: its name, file and folder.</summary>
/// <param name="Name">The document's name: that of a file without its folder.</param>
/// <param name="Path">The whole path of its file; null where it has none yet.</param>
/// <param name="Folder">The folder from which the files that it names are looked for.</param>
public sealed record DocumentPlace(string Name, string? Path, string Folder)
{
    /// <summary>The line ending of the file; the document itself has \n.</summary>
    public string LineEnd { get; init; } = "\n";

    /// <summary>The place of a file.</summary>
    public static DocumentPlace Of(string path) => new(System.IO.Path.GetFileName(path), path, System.IO.Path.GetDirectoryName(path) ?? "");
}
