using System.Collections.Concurrent;
using RayTracer.Import;
using RayTracer.Jobs;

namespace RayTracer.Session;

/// <summary>
/// All that a user works with, whatever shows it: plain data, methods that never wait for the renderer, and one counter of changes.
/// </summary>
public sealed class StudioSession : IDisposable
{
    private readonly DocumentSession _document;
    private readonly ConcurrentDictionary<Type, object> _parts = new();

    /// <summary>Starts a session with a new scene.</summary>
    /// <param name="folders">The user's folders; null for those of the process's user.</param>
    /// <param name="scenes">The folder of the shipped scenes; null for the one that comes with the program.</param>
    /// <param name="time">The clock; null for the system's.</param>
    public StudioSession(UserFolders? folders = null, string? scenes = null, TimeProvider? time = null)
    {
        Importers.Register();
        folders ??= UserFolders.OfUser();
        _document = new(folders, scenes, time);
        Jobs = new(Notices);
        View = new(Document);
        Edits = new(Document, Selection, Notices, View);
        Camera = new(Document, View);
        Bookmarks = new(Document, View, folders);
        Snapshots = new(View, time ?? TimeProvider.System);
        Handles = new(Edits, View);
        LightHandles = new(Document, View);
        Pictures = new(Document, View, Jobs);
        Films = new(Document, View, Pictures, folders, time ?? TimeProvider.System);
        Background = new(Document, View, Jobs, folders);
        Lights = new(Document, View, Jobs);
        Mixer = new(Document, View);
        Timeline = new(Document, View);
        Scenes = scenes ?? ScenesFolder.Find();
        Notices.Changed += (_, _) => Changes.Advance();
        Jobs.Changed += (_, _) => Changes.Advance();
        Document.Changed += Changes.Advance;
        Timeline.Changed += Changes.Advance;
        Selection.Changed += Changes.Advance;
        Recovery.Changed += Changes.Advance;
        View.Changed += Changes.Advance;
        Snapshots.Changed += Changes.Advance;
        Bookmarks.Changed += Changes.Advance;
        View.Refused += message => Notices.Post("error", message.TrimEnd('.'));
        Files.Opened += Begin;
        View.Loop.Failed += message => Notices.Post("error", message.TrimEnd('.'));
    }

    /// <summary>Counts the changes of all that the user sees but the picture.</summary>
    public ChangeCounter Changes { get; } = new();

    /// <summary>The messages for the user.</summary>
    public NoticeBoard Notices { get; } = new();

    /// <summary>The jobs beside the user's work.</summary>
    public JobList Jobs { get; }

    /// <summary>The scene's text.</summary>
    public SceneDocument Document => _document.Document;

    /// <summary>Changes its things.</summary>
    public SceneEdits Edits { get; }

    /// <summary>The selection.</summary>
    public Selection Selection => _document.Selection;

    /// <summary>Opens and saves.</summary>
    public SceneFiles Files => _document.Files;

    /// <summary>Texts of sessions that ended without saving them.</summary>
    public Recovery Recovery => _document.Recovery;

    /// <summary>The shipped scenes.</summary>
    public Gallery Gallery => _document.Gallery;

    /// <summary>The picture.</summary>
    public PictureView View { get; }

    /// <summary>Moves the camera.</summary>
    public CameraController Camera { get; }

    /// <summary>Views to return to.</summary>
    public ViewBookmarks Bookmarks { get; }

    /// <summary>Earlier pictures.</summary>
    public SnapshotList Snapshots { get; }

    /// <summary>Moves, turns and scales things by their handles.</summary>
    public HandleDrags Handles { get; }

    /// <summary>Turns, widens and enlarges lights by their handles.</summary>
    public LightDrags LightHandles { get; }

    /// <summary>Writes pictures.</summary>
    public PictureSaver Pictures { get; }

    /// <summary>Keeps films that would be lost.</summary>
    internal FilmKeeper Films { get; set; }

    /// <summary>Renders into files beside the user's work.</summary>
    public BackgroundRenders Background { get; }

    /// <summary>Balances the lights of rendered pictures.</summary>
    public Relighting Lights { get; }

    /// <summary>Balances the lights of the picture.</summary>
    public LightMixer Mixer { get; }

    /// <summary>The animation: its frame that is shown, and its keys.</summary>
    public Timeline Timeline { get; }

    /// <summary>The folder of the scenes that come with the program; null where there is none.</summary>
    public string? Scenes { get; }

    /// <summary>A part of the session that is made when it is first asked for.</summary>
    public T Part<T>()
        where T : class, ISessionPart<T> => (T)_parts.GetOrAdd(typeof(T), _ => T.Of(this));

    // A film or image is shown as it was rendered.
    private void Begin(RenderJob? origin, FilmStart? start)
    {
        if (origin is null)
        {
            View.Begin();
            return;
        }

        View.Begin(start, start?.Header.Total ?? origin.GivenSamples, start is null ? origin.Crop : start.Header.Crop, origin.Edition);
    }

    /// <summary>Ends all work, and keeps what is not saved.</summary>
    public void Dispose()
    {
        foreach (IDisposable part in _parts.Values.OfType<IDisposable>())
        {
            part.Dispose();
        }

        Jobs.Dispose();
        Films.Dispose();
        Timeline.Dispose();
        View.Dispose();
        _document.Dispose();
    }
}

/// <summary>A part of a session that exists only where it is asked for, such as a tab's.</summary>
/// <typeparam name="T">The part.</typeparam>
public interface ISessionPart<T>
{
    /// <summary>Makes the part of a session.</summary>
    static abstract T Of(StudioSession session);
}
