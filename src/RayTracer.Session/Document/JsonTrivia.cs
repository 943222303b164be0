using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>The trivia between the values of a JSON text: white space, comments, commas. Only for texts that have been parsed.</summary>
internal static class JsonTrivia
{
    /// <summary>The next offset at which there is neither white space nor a comment.</summary>
    public static int SkipBlanks(string text, int at)
    {
        while (at < text.Length && (IsSpace(text[at]) || text[at] is '\n' or '\r' or '/'))
        {
            at = text[at] == '/' ? EndOfComment(text, at) : at + 1;
        }

        return at;
    }

    /// <summary>The comma behind a value; −1 where there is none.</summary>
    public static int Comma(string text, int end)
    {
        int at = SkipBlanks(text, end);
        return at < text.Length && text[at] == ',' ? at : -1;
    }

    /// <summary>The offset behind white space and comments that end with the line; the given offset where anything else follows.</summary>
    public static int BehindComments(string text, int at)
    {
        int end = at;
        for (int i = at; i < text.Length; i++)
        {
            if (text[i] is '\n' or '\r')
            {
                return end;
            }

            if (text[i] == '/')
            {
                int close = EndOfComment(text, i);
                if (text.AsSpan(i, close - i).Contains('\n'))
                {
                    return at;
                }

                end = close;
                i = close - 1;
            }
            else if (!IsSpace(text[i]))
            {
                return at;
            }
        }

        return end;
    }

    /// <summary>The offset at which a line begins.</summary>
    public static int LineStart(string text, int at) => text.LastIndexOf('\n', Math.Max(at - 1, 0), Math.Max(at, 0)) + 1;

    /// <summary>The white space at the beginning of a line.</summary>
    public static string Indent(string text, int at)
    {
        int start = LineStart(text, at);
        int end = start;
        while (end < text.Length && IsSpace(text[end]))
        {
            end++;
        }

        return text[start..end];
    }

    /// <summary>The indentation of one level: that of the first member on a separate line.</summary>
    public static string IndentUnit(JsonText text)
    {
        foreach (JsonMember member in text.Root.Members)
        {
            string indent = Indent(text.Text, member.Start);
            if (indent.Length > 0 && LineStart(text.Text, member.Start) + indent.Length == member.Start)
            {
                return indent;
            }
        }

        return "  ";
    }

    public static bool IsSpace(char c) => c is ' ' or '\t';

    private static int EndOfComment(string text, int at)
    {
        int end = text[at + 1] == '/' ? text.AsSpan(at).IndexOfAny('\n', '\r') : text.AsSpan(at + 2).IndexOf("*/") + 4;
        return end < 0 ? text.Length : at + end;
    }
}
