using System.Diagnostics;

namespace RayTracer.Session;

/// <summary>Plays frames over and over in the view, in their own time: where the view is slower, it shows fewer of them.</summary>
internal sealed class Playback : IDisposable
{
    // Nobody may be looking, and what cannot be seen does not come.
    private static readonly TimeSpan Patience = TimeSpan.FromMilliseconds(500);
    private readonly CancellationTokenSource _end = new();
    private readonly SceneDocument _document;
    private readonly PictureView _view;
    private readonly int _frames;
    private readonly double _rate;
    private volatile bool _isOver;

    /// <summary>Begins at the frame that is shown.</summary>
    /// <param name="document">The document.</param>
    /// <param name="view">Shows it.</param>
    /// <param name="frames">The number of frames.</param>
    /// <param name="rate">The frames a second.</param>
    /// <param name="ended">Called when it ends by itself, because another text is to be shown.</param>
    public Playback(SceneDocument document, PictureView view, int frames, double rate, Action ended)
    {
        (_document, _view, _frames, _rate) = (document, view, frames, rate);
        _ = Run(ended);
    }

    /// <summary>True if it has ended.</summary>
    public bool IsOver => _isOver;

    /// <inheritdoc/>
    public void Dispose()
    {
        _isOver = true;
        _end.Cancel();
    }

    private async Task Run(Action ended)
    {
        DocumentPlace place = _document.Place;
        int first = (_document.Frame ?? 0) % _frames;
        long start = Stopwatch.GetTimestamp();
        try
        {
            while (!_isOver && _document.Place == place)
            {
                double passed = Stopwatch.GetElapsedTime(start).TotalSeconds * _rate;
                int frame = (first + (int)(passed % _frames)) % _frames;
                if (frame == _document.Frame)
                {
                    await Task.Delay(TimeSpan.FromSeconds((1 - (passed % 1)) / _rate), _end.Token).ConfigureAwait(false);
                    continue;
                }

                await Show(frame).ConfigureAwait(false);
            }
        }
        catch (OperationCanceledException)
        {
            // Somebody has ended it.
        }

        _isOver = true;
        ended();
    }

    private async Task Show(int frame)
    {
        using CancellationTokenSource late = CancellationTokenSource.CreateLinkedTokenSource(_end.Token);
        late.CancelAfter(Patience);
        _document.ShowFrame(frame);
        try
        {
            while (_view.Shown?.Good.Frame != frame)
            {
                await Task.Delay(1, late.Token).ConfigureAwait(false);
            }

            await _view.Frames.Changes.WaitBeyond(_view.Frames.Changes.Version, late.Token).ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (!_end.IsCancellationRequested)
        {
            // The next frame may be quicker.
        }
    }
}
