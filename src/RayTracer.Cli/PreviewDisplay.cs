using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>The picture itself as progress, drawn again and again in the same place of a terminal, with a line below it.</summary>
/// <param name="error">The terminal.</param>
/// <param name="graphics">The kind of pictures that it shows.</param>
/// <param name="size">Its size.</param>
/// <param name="looks">Exposure and tone map.</param>
internal sealed class PreviewDisplay(TextWriter error, TerminalGraphics graphics, TerminalSize size, ImageWriteOptions looks) : ProgressDisplay
{
    private const int Interval = 100;
    private const int LinesBelow = 2;
    private static readonly TimeSpan s_pause = TimeSpan.FromMilliseconds(250);

    private readonly Lock _lock = new();
    private long _drawn;
    private string? _picture;
    private int _lines;

    /// <summary>Takes the film as it is, unless one was taken just now. Called by the thread that renders.</summary>
    /// <param name="film">The film.</param>
    /// <param name="isLast">True if it is the last one, which is always taken.</param>
    public void Offer(Film film, bool isLast)
    {
        if (!isLast && _drawn != 0 && Stopwatch.GetElapsedTime(_drawn) < s_pause)
        {
            return;
        }

        _drawn = Stopwatch.GetTimestamp();
        string picture = TerminalPicture.Draw(looks.Shown(film), Columns(film), graphics);
        lock (_lock)
        {
            _picture = picture;
        }
    }

    private protected override void Show()
    {
        const string HideCursor = "\e[?25l";
        const string ShowCursor = "\e[?25h";
        error.Write(HideCursor + (IsGraphic ? "\e[2J" : ""));
        while (!Wait(Interval))
        {
            Paint($"{100 * Fraction:F0} %{Pace}");
        }

        Paint("");
        error.Write(ShowCursor);
        error.Flush();
    }

    private bool IsGraphic => graphics is TerminalGraphics.Sixel or TerminalGraphics.Kitty;

    // So that the picture and the line below it fit. Pixels are about twice as high as wide in letters, and eight or more go in a column
    // where it is a real picture.
    private int Columns(Film film)
    {
        long rows = Math.Max(1, size.Rows - LinesBelow);
        long fitting = Math.Max(1, 2 * rows * film.Width / film.Height);
        return (int)Math.Min(size.Columns, fitting);
    }

    private void Paint(string line)
    {
        const string EraseLine = "\e[K";
        string? picture;
        lock (_lock)
        {
            (picture, _picture) = (_picture, null);
        }

        if (picture is null)
        {
            error.Write($"\r{line}{EraseLine}");
        }
        else if (IsGraphic)
        {
            // How many lines such a picture takes only the terminal knows: it gets the top of the screen.
            string forget = graphics == TerminalGraphics.Kitty ? "\e_Ga=d,q=2\e\\" : "";
            error.Write($"{forget}\e[H{picture}{line}{EraseLine}");
        }
        else
        {
            string up = _lines > 0 ? $"\e[{_lines}A" : "";
            error.Write($"\r{up}{picture}{line}{EraseLine}");
            _lines = picture.Count(c => c == '\n');
        }

        error.Flush();
    }
}
