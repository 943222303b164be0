using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>
/// Keeps the film of a picture that has taken long, from time to time and when the session ends, unless the user has written it to a file.
/// So hours of rendering are not lost with a window, a session or a process.
/// </summary>
internal sealed class FilmKeeper : IDisposable
{
    private const double WorthSeconds = 20;

    // A film is large: once it is kept, so much of its rendering may be lost.
    private const double MostLostSeconds = 120;
    private static readonly TimeSpan s_every = TimeSpan.FromSeconds(10);
    private readonly SemaphoreSlim _one = new(1);
    private readonly SceneDocument _document;
    private readonly PictureView _view;
    private readonly PictureSaver _saver;
    private readonly UserFolders _folders;
    private readonly double _worth;
    private readonly ITimer _timer;
    private KeptFilm? _kept;
    private (long Picture, int Samples) _last;
    private double _lastSeconds;

    /// <summary>Begins to watch.</summary>
    /// <param name="document">The document.</param>
    /// <param name="view">The picture.</param>
    /// <param name="saver">Writes films.</param>
    /// <param name="folders">The user's folders.</param>
    /// <param name="time">The clock.</param>
    /// <param name="worth">From how many seconds of rendering on a film is worth keeping; null for what users get.</param>
    public FilmKeeper(SceneDocument document, PictureView view, PictureSaver saver, UserFolders folders, TimeProvider time, double? worth = null)
    {
        (_document, _view, _saver, _folders, _worth) = (document, view, saver, folders, worth ?? WorthSeconds);
        _timer = time.CreateTimer(_ => _ = IsDue ? Keep() : Task.CompletedTask, null, s_every, s_every);
    }

    /// <summary>Whether there is so much new to keep that it is worth writing: a picture that has none kept, much work since then, or the end of it.</summary>
    internal bool IsDue => _view.Shown?.Picture != _last.Picture || _view.Loop.Status.Status == "done" || _view.Loop.Status.Seconds - _lastSeconds >= MostLostSeconds;

    /// <summary>Keeps the film as it is now, if that is worth it.</summary>
    public async Task Keep()
    {
        await _one.WaitAsync().ConfigureAwait(false);
        try
        {
            await KeepNewest().ConfigureAwait(false);
        }
        catch (Exception e) when (Complaint.Of(e) is not null || e is OperationCanceledException)
        {
            // A full disk, or a picture that changes just now, must not stop the work; the next time tries again.
        }
        finally
        {
            _one.Release();
        }
    }

    /// <summary>Keeps the film, and lets go of it.</summary>
    public void Dispose()
    {
        _timer.Dispose();
        Keep().GetAwaiter().GetResult();
        _kept?.Dispose();
    }

    private async Task KeepNewest()
    {
        (long Picture, int Samples) now = (_view.Shown?.Picture ?? -1, _view.Loop.Status.Samples);
        if (_kept is not null && now.Picture != _last.Picture)
        {
            // It is another picture: what was kept of the last one was of a text that is no longer wanted.
            _kept.Delete();
            _kept.Dispose();
            _kept = null;
        }

        bool isWritten = _saver.Written.Picture == now.Picture && _saver.Written.Samples >= now.Samples;
        if (isWritten && _kept is not null)
        {
            _kept.Delete();
            _kept.Dispose();
            _kept = null;
        }

        if (isWritten || now == _last || now.Samples == 0 || _view.Loop.Status.Seconds < _worth)
        {
            return;
        }

        _kept ??= new(_folders, _document.Place.Name);
        await _saver.WriteFilm(_kept.Path).ConfigureAwait(false);
        (_last, _lastSeconds) = (now, _view.Loop.Status.Seconds);
    }
}
