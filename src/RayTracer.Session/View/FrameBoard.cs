using System.Diagnostics;

namespace RayTracer.Session;

/// <summary>
/// Where the newest frame hangs. The renderer puts frames up only as fast as somebody looks, and never waits for a viewer; a frame that
/// nobody took is gone when the next one comes. Three pictures are enough for all time: one is looked at, one hangs, one is made.
/// </summary>
public sealed class FrameBoard
{
    // Between two frames, the page is busy with the first.
    private static readonly TimeSpan Attention = TimeSpan.FromSeconds(1);
    private readonly Lock _lock = new();
    private readonly Stack<LinearPicture> _free = new();
    private SharedFrame? _newest;
    private long _lastWatched = -Stopwatch.Frequency * 3600;

    /// <summary>The number of the document that the frames show.</summary>
    public int Document { get; private set; }

    /// <summary>Raised when somebody begins to wait for a frame.</summary>
    public event Action? Wanted;

    /// <summary>Counts frames, and changes of how they are seen.</summary>
    public ChangeCounter Changes { get; } = new();

    /// <summary>Returns whether somebody is looking, or was a moment ago.</summary>
    public bool IsWatched => Changes.Waiting > 0 || Stopwatch.GetElapsedTime(Volatile.Read(ref _lastWatched)) < Attention;

    /// <summary>From now on frames show a document; one of another document is taken down.</summary>
    public void Begin(int document)
    {
        lock (_lock)
        {
            if (document != Document)
            {
                Release(_newest);
                (_newest, Document) = (null, document);
            }
        }
    }

    /// <summary>Puts a frame up.</summary>
    /// <param name="info">The facts about the frame.</param>
    /// <param name="draw">Draws it.</param>
    public void Publish(FrameInfo info, Action<LinearPicture> draw)
    {
        LinearPicture picture;
        lock (_lock)
        {
            picture = _free.TryPop(out LinearPicture? free) ? free : new();
        }

        draw(picture);
        lock (_lock)
        {
            SharedFrame? before = _newest;
            _newest = new(info, picture);
            Release(before);
        }

        Changes.Advance();
    }

    /// <summary>Waits for a frame.</summary>
    /// <param name="version">The version that is known already.</param>
    /// <param name="cancellation">Ends the waiting.</param>
    /// <returns>True if there is one.</returns>
    public async Task<bool> Wait(long version, CancellationToken cancellation)
    {
        bool isNew;
        bool isThere;
        do
        {
            Task<bool> wait = Changes.WaitBeyond(version, cancellation);
            if (!wait.IsCompleted)
            {
                Wanted?.Invoke();
            }

            isNew = await wait.ConfigureAwait(false);

            // The version first: a frame that is put up meanwhile is found at once, and one that was taken down is not waited for.
            version = Changes.Version;
            isThere = _lock.Read(() => _newest is not null);
        }
        while (isNew && !isThere);

        Volatile.Write(ref _lastWatched, Stopwatch.GetTimestamp());
        return isNew;
    }

    /// <summary>The newest frame; null before there was one.</summary>
    public FrameLease? Borrow()
    {
        lock (_lock)
        {
            if (_newest is not { } frame)
            {
                return null;
            }

            frame.Users++;
            return new(Changes.Version, frame.Info, frame.Picture, () => Return(frame)) { Document = Document };
        }
    }

    /// <summary>The newest frame is seen in another way.</summary>
    public void Refresh()
    {
        lock (_lock)
        {
            if (_newest is null)
            {
                return;
            }
        }

        Changes.Advance();
    }

    private void Return(SharedFrame frame)
    {
        lock (_lock)
        {
            Release(frame);
        }
    }

    private void Release(SharedFrame? frame)
    {
        const int enough = 3;
        if (frame is not null && --frame.Users == 0 && _free.Count < enough)
        {
            _free.Push(frame.Picture);
        }
    }

    // The board itself is a user.
    private sealed class SharedFrame(FrameInfo info, LinearPicture picture)
    {
        public FrameInfo Info => info;

        public LinearPicture Picture => picture;

        public int Users { get; set; } = 1;
    }
}

/// <summary>The properties of a frame.</summary>
/// <param name="PictureWidth">Width of the whole picture; a preview has fewer pixels.</param>
/// <param name="PictureHeight">Height of the whole picture.</param>
/// <param name="Samples">Samples in each pixel; 0 in a preview.</param>
/// <param name="IsPreview">True if there is less in it than a sample of each pixel.</param>
/// <param name="IsLast">True if nothing more will be added to it.</param>
/// <param name="IsLight">True if it shows light, so that exposure and tone map apply; maps have their colours already.</param>
public sealed record FrameInfo(int PictureWidth, int PictureHeight, int Samples, bool IsPreview, bool IsLast, bool IsLight);

/// <summary>A frame for as long as it is looked at: its memory is used again after it was disposed of.</summary>
public sealed class FrameLease : IDisposable
{
    private readonly Action _release;
    private bool _isOver;

    internal FrameLease(long version, FrameInfo info, LinearPicture picture, Action release)
    {
        Version = version;
        Info = info;
        Picture = picture;
        _release = release;
    }

    /// <summary>Grows with each frame, and each change of how it is seen.</summary>
    public long Version { get; }

    /// <summary>The number of the document that it shows.</summary>
    public int Document { get; init; }

    /// <summary>The properties of the frame.</summary>
    public FrameInfo Info { get; }

    /// <summary>The frame.</summary>
    public LinearPicture Picture { get; }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (!Interlocked.Exchange(ref _isOver, true))
        {
            _release();
        }
    }
}
