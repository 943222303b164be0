using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Builds the newest text of a document, one build at a time, in the background. Building never throws.</summary>
/// <param name="built">Called after each build that counts, by the thread that built.</param>
internal sealed class SceneBuilds(Action built) : IDisposable
{
    private readonly Lock _lock = new();
    private readonly ChangeCounter _published = new();
    private DocumentContent _content = Nothing;
    private IReadOnlyList<PlacedDiagnostic> _diagnostics = [];
    private Order? _wanted;
    private Order? _built;
    private bool _isBuilding;
    private bool _isDisposed;
    private int _epoch;
    private FileCache _files = new();
    private string? _reading;

    /// <summary>The newest content.</summary>
    public DocumentContent Content => _lock.Read(() => _content);

    /// <summary>The number of the document that is built: grows whenever another one is opened.</summary>
    public int Document => _lock.Read(() => _epoch);

    /// <summary>The name of the file that is read just now; null where none is.</summary>
    public string? Reading => Volatile.Read(ref _reading);

    /// <summary>The number of files read in all builds.</summary>
    public int FilesRead => _files.Reads;

    private static DocumentContent Nothing
    {
        get
        {
            SceneReadResult read = SceneReader.ReadText("{}", "");
            return new(0, "", read, new(null, null, []), null);
        }
    }

    /// <summary>The diagnostics of a content with the parts of the text that they are about.</summary>
    public IReadOnlyList<PlacedDiagnostic> DiagnosticsOf(DocumentContent content) => _lock.Read(() =>
        ReferenceEquals(content, _content) ? _diagnostics : PlacedDiagnostic.Of(content.Read, content.Load.Diagnostics));

    /// <summary>Asks for a text to be built, instead of all that were asked for and not begun.</summary>
    /// <param name="revision">The text's revision.</param>
    /// <param name="text">The text.</param>
    /// <param name="read">The result of reading it.</param>
    /// <param name="folder">The folder from which files are looked for.</param>
    /// <param name="frame">The frame of the animation; null for the scene as it is written.</param>
    /// <param name="hidden">The pointers of things that are left out.</param>
    public void Want(int revision, string text, Lazy<SceneReadResult> read, string folder, int? frame, IReadOnlyList<string> hidden)
    {
        lock (_lock)
        {
            if (_isDisposed || revision < (_wanted?.Revision ?? 1) || (revision == _wanted?.Revision && frame == _wanted.Frame && hidden.SequenceEqual(_wanted.Hidden)))
            {
                return;
            }

            _wanted = new(revision, text, read, folder, frame, hidden, _epoch);
            if (!_isBuilding)
            {
                _isBuilding = true;
                int epoch = _epoch;
                _ = Task.Run(() => BuildAll(epoch));
            }
        }
    }

    /// <summary>Gives up what is being built: it is of a document that is no longer open. The last good scene goes with it.</summary>
    public void Abandon()
    {
        lock (_lock)
        {
            // Nobody waits for the build of the last document, which may be reading a large file: the next one has its own thread and files.
            _epoch++;
            _isBuilding = false;
            _files = new();
            _reading = null;
            _content = _content with { LastGood = null };
        }
    }

    /// <summary>The first content of a revision or a later one.</summary>
    public async Task<DocumentContent> WhenBuilt(int revision, CancellationToken cancellation)
    {
        while (true)
        {
            // The version first: what is published meanwhile is not waited for.
            long version = _published.Version;
            if (Content is var content && content.Revision >= revision)
            {
                return content;
            }

            await _published.WaitBeyond(version, cancellation).ConfigureAwait(false);
            cancellation.ThrowIfCancellationRequested();
        }
    }

    public void Dispose()
    {
        lock (_lock)
        {
            _isDisposed = true;
            _epoch++;
        }
    }

    private void BuildAll(int epoch)
    {
        while (true)
        {
            Order order;
            GoodScene? lastGood;
            lock (_lock)
            {
                if (_epoch != epoch)
                {
                    return;
                }

                if (_isDisposed || _wanted is null || _wanted == _built)
                {
                    _isBuilding = false;
                    return;
                }

                (order, lastGood, _built) = (_wanted, _content.LastGood, _wanted);
            }

            DocumentContent content = Build(order, lastGood);
            if (Publish(content, order))
            {
                built();
            }
        }
    }

    // A build that an edit has overtaken still counts, or nothing would be seen of a drag as long as it lasts.
    private bool Publish(DocumentContent content, Order order)
    {
        IReadOnlyList<PlacedDiagnostic> diagnostics = PlacedDiagnostic.Of(content.Read, content.Load.Diagnostics);
        lock (_lock)
        {
            if (order.Epoch != _epoch)
            {
                return false;
            }

            (_content, _diagnostics) = (content, diagnostics);
        }

        _published.Advance();
        return true;
    }

    private DocumentContent Build(Order order, GoodScene? lastGood)
    {
        SceneReadResult read = order.Read.Value;
        SceneReadResult shown = order.Hidden.Count == 0 ? FrameTimes.Read(read, order.Frame) : SceneReader.ReadText(order.Text, read.Source?.FileName ?? "", frame: order.Frame);
        SceneDescription? seen = order.Hidden.Count == 0 || shown.Description is not { } all ? shown.Description : HiddenThings.Without(shown, all, order.Hidden);
        SceneLoadResult load;
        FileCache files = _files;
        files.BeginBuild();
        try
        {
            load = SceneLoader.Build(shown, order.Folder, FrameTimes.Opened(shown, order.Frame, seen), readPicture: (path, raw) => InTime(order, path, () => files.ReadPicture(path, raw)),
                readModel: path => InTime(order, path, () => files.ReadModel(path)));
        }
        catch (Exception e) when (e is not StackOverflowException)
        {
            load = new(null, null, [.. read.Diagnostics, new(read.Source?.FileName ?? "", 0, 0, Severity.Error, $"the scene cannot be built: {e.Message.TrimEnd('.')}")]);
        }

        int? frame = read.Description is not { Animation.Count: > 0 } && !FrameTimes.IsMoving(read) ? null : order.Frame;
        GoodScene? good = load.Scene is { } scene ? new(order.Revision, order.Text, shown, scene) { Load = load, Document = order.Epoch, Frame = frame, Hidden = order.Hidden, Description = seen! } : lastGood;
        return new(order.Revision, order.Text, read, load, good);
    }

    // Files take longest: none is read for a document that is no longer open.
    private T InTime<T>(Order order, string path, Func<T> read)
    {
        if (!Note(order, Path.GetFileName(path)))
        {
            throw new OperationCanceledException();
        }

        if (Content.LastGood is null)
        {
            built();
        }

        try
        {
            return read();
        }
        finally
        {
            Note(order, null);
        }
    }

    // False where the order's document is no longer open.
    private bool Note(Order order, string? reading)
    {
        lock (_lock)
        {
            bool isOpen = order.Epoch == _epoch;
            _reading = isOpen ? reading : _reading;
            return isOpen;
        }
    }

    private sealed record Order(int Revision, string Text, Lazy<SceneReadResult> Read, string Folder, int? Frame, IReadOnlyList<string> Hidden, int Epoch);
}

/// <summary>A document as it was at one moment: its text, and what the text came to.</summary>
/// <param name="Revision">Grows with every change of the text.</param>
/// <param name="Text">The scene file's text.</param>
/// <param name="Read">The result of reading it: nodes with their places, records, diagnostics.</param>
/// <param name="Load">The scene built from it, and all diagnostics.</param>
/// <param name="LastGood">The newest content, this or an earlier one, from which a scene could be built; null before there was one.</param>
public sealed record DocumentContent(int Revision, string Text, SceneReadResult Read, SceneLoadResult Load, GoodScene? LastGood);

/// <summary>A scene that can be shown, and where it came from.</summary>
/// <param name="Revision">The document's revision.</param>
/// <param name="Text">The text then.</param>
/// <param name="Read">The result of reading it, at the frame.</param>
/// <param name="Scene">The scene.</param>
public sealed record GoodScene(int Revision, string Text, SceneReadResult Read, Scene Scene)
{
    /// <summary>The result of building it, by which files that it names are read again; null where it was not built from a text.</summary>
    public SceneLoadResult? Load { get; init; }

    /// <summary>The number of the document that it is of: grows whenever another one is opened.</summary>
    public int Document { get; init; }

    /// <summary>The frame of the animation that it is; null where nothing is animated, and for the scene as it is written.</summary>
    public int? Frame { get; init; }

    /// <summary>The pointers of the things that are left out.</summary>
    public IReadOnlyList<string> Hidden { get; init; } = [];

    /// <summary>The scene without them.</summary>
    public SceneDescription Description { get; init; } = Read.Description!;
}
