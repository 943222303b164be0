namespace RayTracer.Session;

/// <summary>A frame for as long as it is looked at: its memory is used again after it was disposed of.</summary>
public sealed class FrameLease : IDisposable
{
    private readonly Action _giveBack;
    private bool _isOver;

    internal FrameLease(long version, FrameInfo info, LinearPicture picture, Action giveBack)
    {
        Version = version;
        Info = info;
        Picture = picture;
        _giveBack = giveBack;
    }

    /// <summary>Grows with each frame, and each change of how it is seen.</summary>
    public long Version { get; }

    /// <summary>What is known about the frame.</summary>
    public FrameInfo Info { get; }

    /// <summary>The frame.</summary>
    public LinearPicture Picture { get; }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (!Interlocked.Exchange(ref _isOver, true))
        {
            _giveBack();
        }
    }
}
