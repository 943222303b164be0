using System.IO.Compression;
using System.Text;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>A word of a scene: a directive, a number, a bracket, or what stands in quotation marks.</summary>
/// <param name="Text">The word; of a text in quotation marks what is within.</param>
/// <param name="IsQuoted">True where it stands in quotation marks.</param>
/// <param name="Place">The place of its first character.</param>
internal readonly record struct PbrtToken(string Text, bool IsQuoted, SourcePlace Place)
{
    /// <summary>True for a bracket of this kind.</summary>
    public bool Is(string bracket) => !IsQuoted && Text == bracket;
}

/// <summary>Reads the words of a file, one after the other.</summary>
/// <param name="text">The file's text.</param>
/// <param name="file">The file's path, as diagnostics call it.</param>
/// <param name="log">Takes what is wrong.</param>
internal sealed class PbrtText(string text, string file, ImportLog log)
{
    private int _at;
    private int _line = 1;
    private int _lineStart;
    private PbrtToken? _next;

    /// <summary>The place of the end of what has been read.</summary>
    public SourcePlace Place => new(file, _line, _at - _lineStart + 1);

    /// <summary>Opens a file, which may be compressed (.gz); null, after an error, where it cannot be read.</summary>
    /// <param name="path">The file's path.</param>
    /// <param name="place">The place of what names it.</param>
    /// <param name="words">The beginning of the message.</param>
    /// <param name="log">Takes what is wrong.</param>
    public static PbrtText? Open(string path, SourcePlace place, string words, ImportLog log)
    {
        try
        {
            if (FileSearch.Complaint(path) is { } complaint)
            {
                return log.Fail<PbrtText>(place, words + complaint);
            }

            using FileStream stream = File.OpenRead(path);
            using Stream content = path.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? new GZipStream(stream, CompressionMode.Decompress) : stream;
            byte[] bytes = Bytes(content);
            return bytes.Length > SceneReader.MaximumBytes ? log.Fail<PbrtText>(place, $"{words}larger than {SceneReader.MaximumBytes >> 20} MiB")
                : SceneBudget.Open?.Take("the text", 2L * bytes.Length, bytes.Length) is { } tooMuch ? log.Fail<PbrtText>(place, words + tooMuch)
                : new(Encoding.UTF8.GetString(bytes), path, log);
        }
        catch (Exception e) when (e is IOException or InvalidDataException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            return log.Fail<PbrtText>(place, $"{words}cannot be read: {e.Message.TrimEnd('.')}");
        }
    }

    /// <summary>The next word, which stays the next one; null at the end.</summary>
    public PbrtToken? Peek() => _next ??= Read();

    /// <summary>The next word; null at the end.</summary>
    public PbrtToken? Next()
    {
        PbrtToken? token = Peek();
        _next = null;
        return token;
    }

    private static byte[] Bytes(Stream content)
    {
        using MemoryStream all = new();
        byte[] part = new byte[1 << 16];
        for (int count; all.Length <= SceneReader.MaximumBytes && (count = content.Read(part)) > 0;)
        {
            all.Write(part, 0, count);
        }

        return all.ToArray();
    }

    private PbrtToken? Read()
    {
        SkipSpace();
        if (_at == text.Length)
        {
            return null;
        }

        SourcePlace place = Place;
        char first = text[_at];
        if (first == '"')
        {
            return Quoted(place);
        }

        int start = _at++;
        if (first is not ('[' or ']'))
        {
            while (_at < text.Length && !char.IsWhiteSpace(text[_at]) && text[_at] is not ('"' or '[' or ']' or '#'))
            {
                _at++;
            }
        }

        return new(text[start.._at], false, place);
    }

    private void SkipSpace()
    {
        for (; _at < text.Length; _at++)
        {
            if (text[_at] == '\n')
            {
                (_line, _lineStart) = (_line + 1, _at + 1);
            }
            else if (text[_at] == '#')
            {
                int end = text.IndexOf('\n', _at);
                _at = (end < 0 ? text.Length : end) - 1;
            }
            else if (!char.IsWhiteSpace(text[_at]) && text[_at] != '\uFEFF')
            {
                return;
            }
        }
    }

    private PbrtToken? Quoted(SourcePlace place)
    {
        StringBuilder word = new();
        for (_at++; _at < text.Length && text[_at] is not ('"' or '\n'); _at++)
        {
            char c = text[_at];
            if (c == '\\' && _at + 1 < text.Length && "nrtbf\\'\"".IndexOf(text[_at + 1], StringComparison.Ordinal) is var known and >= 0)
            {
                c = "\n\r\t\b\f\\'\""[known];
                _at++;
            }

            word.Append(c);
        }

        if (_at == text.Length || text[_at] == '\n')
        {
            log.Error(place, "the quotation mark is not closed on its line");
        }
        else
        {
            _at++;
        }

        return new(word.ToString(), true, place);
    }
}
