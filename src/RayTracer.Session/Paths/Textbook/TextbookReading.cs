using RayTracer.Textbook;

namespace RayTracer.Session;

/// <summary>The picture's scene in the textbook edition, read once for all who look inside: that builds its tree.</summary>
public sealed class TextbookReading : ISessionPart<TextbookReading>
{
    private readonly Lock _lock = new();
    private (long Picture, string? Edition, Renderer? Renderer)? _last;

    /// <inheritdoc/>
    public static TextbookReading Of(StudioSession session) => new();

    /// <summary>As <see cref="ViewportScene.ReadTextbook"/>.</summary>
    internal Renderer? Read(ViewportScene shown)
    {
        lock (_lock)
        {
            if (_last is not { } last || last.Picture != shown.Picture || last.Edition != shown.Settings.Edition)
            {
                _last = last = (shown.Picture, shown.Settings.Edition, shown.ReadTextbook());
            }

            return last.Renderer;
        }
    }
}
