using System.Text.Unicode;

namespace RayTracer.Scenes;

/// <summary>
/// The text of a file, and its lines. A line ends with \n, \r\n or \r. Lines and columns count from 1; a column is a
/// UTF-16 unit, as editors count: a tab is one column, a character beyond U+FFFF two.
/// </summary>
public sealed class SourceText
{
    private readonly int[] _lineStarts;
    private readonly List<(int Start, string Name)> _annexes = [];
    private int _end;

    /// <summary>Takes a text; a byte order mark at its beginning is left out.</summary>
    /// <param name="fileName">The name of the file in messages.</param>
    /// <param name="text">The text.</param>
    public SourceText(string fileName, string text)
    {
        FileName = fileName;
        Text = text.StartsWith('\uFEFF') ? text[1..] : text;
        List<int> starts = [0];
        for (int i = 0; i < Text.Length; i++)
        {
            if (Text[i] == '\n' || (Text[i] == '\r' && (i + 1 == Text.Length || Text[i + 1] != '\n')))
            {
                starts.Add(i + 1);
            }
        }

        _lineStarts = [.. starts];
        _end = Text.Length;
    }

    /// <summary>The name of the file in messages.</summary>
    public string FileName { get; }

    /// <summary>The text, without a byte order mark.</summary>
    public string Text { get; }

    /// <summary>Decodes UTF-8.</summary>
    /// <param name="fileName">The name of the file in messages.</param>
    /// <param name="bytes">The file's bytes.</param>
    /// <param name="error">The fault where the bytes are no UTF-8; otherwise null.</param>
    /// <returns>The text up to the first error.</returns>
    public static SourceText Decode(string fileName, ReadOnlySpan<byte> bytes, out Diagnostic? error)
    {
        char[] characters = new char[bytes.Length];
        Utf8.ToUtf16(bytes, characters, out int read, out int written, replaceInvalidSequences: false);
        SourceText source = new(fileName, new string(characters, 0, written));
        error = null;
        if (read < bytes.Length)
        {
            string message = bytes is [0xFF, 0xFE, ..] or [0xFE, 0xFF, ..]
                ? "the file is in UTF-16: save it as UTF-8"
                : $"the file is not UTF-8: its byte 0x{bytes[read]:X2} does not start a character";
            error = source.Error(source.Text.Length, message);
        }

        return source;
    }

    /// <summary>Gives a text of another origin, such as an option of a command, offsets behind those of this one, so that messages can point at its columns.</summary>
    /// <param name="name">Its name in messages.</param>
    /// <param name="length">Its length.</param>
    /// <returns>The offset of its first character.</returns>
    internal int Annex(string name, int length)
    {
        int start = _end + 1;
        _annexes.Add((start, name));
        _end = start + length;
        return start;
    }

    /// <summary>The line and column of an offset, both from 1; in a text of another origin, the line is 0.</summary>
    public (int Line, int Column) Position(int offset)
    {
        if (offset > Text.Length)
        {
            return (0, offset - _annexes.FindLast(a => a.Start <= offset).Start + 1);
        }

        int line = Array.BinarySearch(_lineStarts, offset);
        line = line < 0 ? ~line - 1 : line;
        return (line + 1, offset - _lineStarts[line] + 1);
    }

    /// <summary>The offset of a line and column, both from 1, that are in the text.</summary>
    public int Offset(int line, int column) => _lineStarts[line - 1] + column - 1;

    /// <summary>An error at an offset.</summary>
    public Diagnostic Error(int offset, string message) => At(offset, Severity.Error, message);

    /// <summary>A diagnostic at an offset.</summary>
    public Diagnostic At(int offset, Severity severity, string message)
    {
        (int line, int column) = Position(offset);
        return new(line > 0 ? FileName : _annexes.FindLast(a => a.Start <= offset).Name, line, column, severity, message);
    }
}
