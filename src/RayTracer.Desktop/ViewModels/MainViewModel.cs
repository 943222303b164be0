using System.Globalization;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The whole window: a session, and all that shows it.</summary>
/// <param name="session">The session.</param>
/// <param name="window">The services that only the system's window has.</param>
internal sealed class MainViewModel(StudioSession session, IWindowServices window) : Observable, IDisposable
{
    private static readonly TimeSpan ShortestPause = TimeSpan.FromMilliseconds(100);
    private readonly CancellationTokenSource _stop = new();
    private DocumentStatus? _document;
    private DocumentSnapshot? _shown;
    private int _noticeId;

    /// <summary>Carries the user's wishes to the session.</summary>
    public SessionDispatcher Dispatcher => field ??= new(session, Messages);

    /// <summary>The rest of the window, as editors of parameters use it.</summary>
    public PanelContext Context => field ??= new(Dispatcher, window) { ShowSource = ShowSource };

    /// <summary>Everything that a menu, a button or a key can do.</summary>
    public CommandTable Commands => field ??= new(this);

    /// <summary>The panes and tabs that are shown.</summary>
    public Layout Layout { get; } = new();

    /// <summary>Short messages.</summary>
    public MessagesViewModel Messages { get; } = new();

    /// <summary>Opens, saves and shares.</summary>
    public FileCommands Files => field ??= new(Dispatcher, window, Ask) { Flush = () => Dispatcher.Idle };

    /// <summary>Adds and changes things.</summary>
    public ThingsViewModel Things => field ??= new(Dispatcher, Context, ShowTab);

    /// <summary>The tree of things.</summary>
    public OutlinerViewModel Outliner => field ??= new(Choose);

    /// <summary>The shipped scenes.</summary>
    public GalleryViewModel Gallery => field ??= new(Dispatcher, id => _ = Files.OpenGallery(id));

    /// <summary>The files that were opened last.</summary>
    public FilesViewModel Recent => field ??= new(() => _ = Files.Open(), path => _ = Files.OpenFile(path));

    /// <summary>The properties.</summary>
    public PropertyPanelViewModel Properties => field ??= new(Context, new(Dispatcher, Context), type => Things.Add("environment", type));

    /// <summary>The text.</summary>
    public SourceViewModel Source => field ??= new(Dispatcher);

    /// <summary>The picture.</summary>
    public ViewportViewModel Viewport => field ??= new(Dispatcher) { Inspect = Inspect, Selected = () => Properties.Open("object") };

    /// <summary>The progress of the rendering.</summary>
    public StatusViewModel Status => field ??= new(Dispatcher);

    /// <summary>Light paths of a pixel.</summary>
    public PathsViewModel Paths => field ??= new(Dispatcher);

    /// <summary>The error against samples.</summary>
    public ConvergenceViewModel Convergence => field ??= new(Dispatcher, () => Layout.ShowsConvergence);

    /// <summary>The report's times.</summary>
    public TimesViewModel Times => field ??= new(Dispatcher);

    /// <summary>The question over the window; null where there is none.</summary>
    public DialogViewModel? Dialog { get; private set => SetProperty(ref field, value); }

    /// <summary>Work of an earlier session that was not saved; null where there is none.</summary>
    public RecoveryViewModel? Recovery { get; private set => SetProperty(ref field, value); }

    /// <summary>The window's title.</summary>
    public string Title =>
        $"{(_document?.IsDirty == true ? "• " : "")}{_document?.Name ?? SessionTexts.Of("untitled")} – {SessionTexts.Of("product")}";

    public string DocumentName => _document?.Name ?? SessionTexts.Of("untitled");

    public bool IsDirty => _document?.IsDirty == true;

    /// <summary>Follows the session, until the window is disposed of.</summary>
    public async Task Run()
    {
        try
        {
            await Task.Run(() => TypeCatalogue.Instance, _stop.Token);
            Things.Load();
            Gallery.Show(session.Gallery.Groups);
            Report(nameof(Things), nameof(Gallery));
            await Task.WhenAll(FollowState(), Viewport.FollowFrames(session.View, _stop.Token), Convergence.Follow(_stop.Token), Gallery.LoadPictures(_stop.Token));
        }
        catch (OperationCanceledException)
        {
            // The window is closed.
        }
    }

    /// <summary>Shows a question.</summary>
    public void Ask(DialogViewModel dialog)
    {
        dialog.Close = () => Dialog = Dialog == dialog ? null : Dialog;
        Dialog = dialog;
    }

    /// <summary>Asks for the selected thing's new name.</summary>
    public void AskForName() =>
        Things.With(pointer => Ask(new RenameViewModel(Properties.Thing?.Title ?? "", name => Things.Rename(pointer, name))));

    /// <summary>Ends following. The session lives on.</summary>
    public void Dispose()
    {
        _stop.Cancel();
        _stop.Dispose();
    }

    private async Task FollowState()
    {
        long version = -1;
        while (await session.Changes.WaitBeyond(version, _stop.Token))
        {
            // Read by a thread of the pool: what is locked for a moment holds nobody up.
            (SessionState state, DocumentSnapshot? shown, IReadOnlyList<string> recent) = await Task.Run(Read, _stop.Token);
            version = state.Version;
            Show(state, shown, recent);
            await Task.Delay(ShortestPause, _stop.Token);
        }

        _stop.Token.ThrowIfCancellationRequested();
    }

    private (SessionState State, DocumentSnapshot? Shown, IReadOnlyList<string> Recent) Read()
    {
        SessionState state = SessionState.Of(session);
        bool isNew = _shown is null || state.Document.Revision != _shown.Revision || state.Selection != _shown.Selection;
        return (state, isNew ? DocumentSnapshot.Of(session) : null, isNew ? session.Files.Recent : []);
    }

    private void Show(SessionState state, DocumentSnapshot? shown, IReadOnlyList<string> recent)
    {
        (_document, Files.Document, Context.Folder) = (state.Document, state.Document, Path.GetDirectoryName(state.Document.Path));
        Status.Show(state);
        Viewport.Show(state);
        Properties.Render.Show(state);
        Source.Show(state.Document);
        if (shown is not null)
        {
            _shown = shown;
            Source.Show(shown);
            Outliner.Show(shown);
            Properties.Show(shown);
            Recent.Show(recent);
            Things.Selected = shown.Selection is { } pointer && SceneThings.IsThing(pointer) ? pointer : null;
        }

        ShowNews(state);
        Commands.Show(state);
        Report(nameof(Title), nameof(DocumentName), nameof(IsDirty));
    }

    private void ShowNews(SessionState state)
    {
        if (state.Notice is { } notice && notice.Id != _noticeId)
        {
            _noticeId = notice.Id;
            Messages.Say(notice.Kind, notice.Text);
        }

        string? kept = state.Recovery is [var newest, ..] ? newest.Id : null;
        if (kept != Recovery?.Id)
        {
            Recovery = state.Recovery is [var first, ..] ? new(first, () => _ = Files.OpenRecovered(first.Id), () => Dispatcher.Do(s => s.Recovery.Discard(first.Id))) : null;
        }
    }

    private void Choose(OutlineRow row)
    {
        Dispatcher.Do(s => s.Selection.Select(row.Tab is null ? row.Pointer : null));
        Properties.Open(row.Tab ?? "object");
    }

    private void ShowTab(string tab)
    {
        Layout.IsRightOpen = true;
        Properties.Open(tab);
    }

    private void ShowSource(TextPlace place)
    {
        Layout.OpenDock("source");
        Source.Place = place;
    }

    private void Inspect(Spot pixel)
    {
        Viewport.Inspected = pixel;
        Layout.OpenDock("paths");
        Paths.Inspect((int)pixel.X, (int)pixel.Y);
    }
}

/// <summary>Work of an earlier session that was not saved.</summary>
internal sealed class RecoveryViewModel(RecoveryEntry entry, Action open, Action discard)
{
    public string Id => entry.Id;

    public string Text =>
        SessionTexts.Of("recovery.text", entry.Name, entry.Time.ToLocalTime().ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture));

    /// <summary>Opens it.</summary>
    public ICommand Open { get; } = new RelayCommand(open);

    /// <summary>Throws it away.</summary>
    public ICommand Discard { get; } = new RelayCommand(discard);
}
