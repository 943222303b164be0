using System.Text;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>
/// Parses JSON (RFC 8259) with <c>//</c> and <c>/* */</c> comments and trailing commas. It ends at the first error of
/// syntax; duplicate keys are reported and parsing continues.
/// </summary>
public sealed class JsonParser
{
    /// <summary>The maximum depth of nested objects and arrays.</summary>
    public const int MaximumDepth = 64;

    private readonly SourceText _source;
    private readonly string _text;
    private readonly ICollection<Diagnostic> _diagnostics;
    private int _at;
    private bool _failed;

    private JsonParser(SourceText source, ICollection<Diagnostic> diagnostics)
    {
        _source = source;
        _text = source.Text;
        _diagnostics = diagnostics;
    }

    /// <summary>Parses a text that holds one value.</summary>
    /// <param name="source">The text.</param>
    /// <param name="diagnostics">Takes what is wrong.</param>
    /// <returns>The value; null after an error of syntax.</returns>
    public static JsonNode? Parse(SourceText source, ICollection<Diagnostic> diagnostics)
    {
        JsonParser parser = new(source, diagnostics);
        if (!parser.SkipBlanks())
        {
            return null;
        }

        if (parser._at == parser._text.Length)
        {
            return parser.Fail<JsonNode>(0, "the file is empty");
        }

        JsonNode? root = parser.Value(1);
        if (root is null || !parser.SkipBlanks())
        {
            return null;
        }

        return parser._at == parser._text.Length ? root : parser.Fail<JsonNode>(parser._at, $"expected the end of the file, but found {parser.Found()}");
    }

    private T? Fail<T>(int offset, string message)
        where T : class
    {
        _diagnostics.Add(_source.Error(offset, message) with { Rule = DiagnosticRule.Syntax });
        _failed = true;
        return null;
    }

    private char Peek(int ahead = 0) => _at + ahead < _text.Length ? _text[_at + ahead] : '\0';

    // Skips white space and comments; false where a comment has no end.
    private bool SkipBlanks()
    {
        while (_at < _text.Length)
        {
            if (Peek() is ' ' or '\t' or '\n' or '\r')
            {
                _at++;
            }
            else if (Peek() == '/' && Peek(1) == '/')
            {
                int end = _text.AsSpan(_at).IndexOfAny('\n', '\r');
                _at = end < 0 ? _text.Length : _at + end;
            }
            else if (Peek() == '/' && Peek(1) == '*')
            {
                int end = _text.IndexOf("*/", _at + 2, StringComparison.Ordinal);
                if (end < 0)
                {
                    Fail<JsonNode>(_at, "the comment that starts here has no end \"*/\"");
                    return false;
                }

                _at = end + 2;
            }
            else
            {
                break;
            }
        }

        return true;
    }

    private JsonNode? Value(int depth)
    {
        int start = _at;
        return Peek() switch
        {
            '{' or '[' when depth > MaximumDepth => Fail<JsonNode>(start, $"nested more than {MaximumDepth} deep"),
            '{' => Object(depth),
            '[' => Array(depth),
            '"' => String() is { } text ? new(JsonKind.String, start, _at, text) : null,
            '-' or '+' or '.' or (>= '0' and <= '9') => Number(),
            _ => Word(),
        };
    }

    private JsonNode? Object(int depth)
    {
        int start = _at++;
        List<JsonMember> members = [];
        Dictionary<string, int> keys = new(StringComparer.Ordinal);
        while (SkipBlanks() && Peek() != '}')
        {
            int keyStart = _at;
            if (Peek() != '"')
            {
                return Fail<JsonNode>(_at, $"expected a key in double quotes or \"}}\", but found {Found()}");
            }

            string? key = String();
            int keyEnd = _at;
            if (key is null || !SkipBlanks())
            {
                return null;
            }

            if (Peek() != ':')
            {
                return Fail<JsonNode>(_at, $"expected \":\" after the key {Quotation.Of(key)}, but found {Found()}");
            }

            _at++;
            if (!SkipBlanks() || Value(depth + 1) is not { } value)
            {
                return null;
            }

            if (!keys.TryAdd(key, keyStart))
            {
                int first = _source.Position(keys[key]).Line;
                _diagnostics.Add(_source.Error(keyStart, $"the key {Quotation.Of(key)} appears twice, first on line {first}") with { Rule = DiagnosticRule.Syntax });
            }

            members.Add(new(key, keyStart, keyEnd, value));
            if (!Separator('}', $"the value of {Quotation.Of(key)}"))
            {
                break;
            }
        }

        return Close('}') ? new(JsonKind.Object, start, _at) { Members = members } : null;
    }

    private JsonNode? Array(int depth)
    {
        int start = _at++;
        List<JsonNode> items = [];
        while (SkipBlanks() && Peek() != ']')
        {
            if (Value(depth + 1) is not { } item)
            {
                return null;
            }

            items.Add(item);
            if (!Separator(']', "a value"))
            {
                break;
            }
        }

        return Close(']') ? new(JsonKind.Array, start, _at) { Items = items } : null;
    }

    // Whether a comma was there, after which another element or the end may follow.
    private bool Separator(char close, string after)
    {
        if (!SkipBlanks())
        {
            return false;
        }

        if (Peek() == ',')
        {
            _at++;
            return true;
        }

        if (Peek() != close)
        {
            Fail<JsonNode>(_at, $"expected \",\" or \"{close}\" after {after}, but found {Found()}");
        }

        return false;
    }

    private bool Close(char close)
    {
        if (_failed)
        {
            return false;
        }

        _at++;
        return true;
    }

    private string? String()
    {
        int start = _at++;
        StringBuilder text = new();
        while (true)
        {
            int run = _text.AsSpan(_at).IndexOfAny("\"\\\n\r");
            if (run < 0 || _text[_at + run] is '\n' or '\r')
            {
                return Fail<string>(start, "the string that starts here has no end: expected a double quote on the same line");
            }

            ReadOnlySpan<char> characters = _text.AsSpan(_at, run);
            int control = characters.IndexOfAnyInRange('\0', '\u001F');
            if (control >= 0)
            {
                return Fail<string>(_at + control, $"the control character U+{(int)characters[control]:X4} must be written \"\\u{(int)characters[control]:X4}\" in a string");
            }

            text.Append(characters);
            _at += run;
            if (_text[_at++] == '"')
            {
                return text.ToString();
            }

            if (Escape() is not { } escaped)
            {
                return null;
            }

            text.Append(escaped);
        }
    }

    private char? Escape()
    {
        const string Letters = "\"\\/bfnrt";
        const string Meanings = "\"\\/\b\f\n\r\t";
        int start = _at - 1;
        char letter = Peek();
        int known = Letters.AsSpan().IndexOf(letter);
        if (known >= 0)
        {
            _at++;
            return Meanings[known];
        }

        if (letter != 'u')
        {
            Fail<string>(start, "unknown escape in a string: a backslash itself is written \"\\\\\"");
            return null;
        }

        string digits = _text.Substring(_at + 1, Math.Min(4, _text.Length - _at - 1));
        if (digits.Length < 4 || !digits.All(char.IsAsciiHexDigit))
        {
            Fail<string>(start, "\"\\u\" needs four hexadecimal digits after it");
            return null;
        }

        _at += 5;
        return (char)Convert.ToInt32(digits, 16);
    }

    private JsonNode? Number()
    {
        int start = _at;
        while (char.IsAsciiLetterOrDigit(Peek()) || Peek() is '.' or '+' or '-')
        {
            _at++;
        }

        string text = _text[start.._at];
        return IsNumber(text)
            ? new(JsonKind.Number, start, _at, text)
            : Fail<JsonNode>(start, $"{Quotation.Of(text)} is not a number as JSON writes it, such as 10, -0.5 or 2e-3");
    }

    // RFC 8259, section 6: no plus sign, no leading zeros, digits on both sides of the point.
    internal static bool IsNumber(string text)
    {
        int at = text is ['-', ..] ? 1 : 0;
        int whole = Digits(text, ref at);
        bool good = whole > 0 && (whole == 1 || text[at - whole] != '0');
        if (at < text.Length && text[at] == '.')
        {
            at++;
            good &= Digits(text, ref at) > 0;
        }

        if (at < text.Length && text[at] is 'e' or 'E')
        {
            at++;
            at += at < text.Length && text[at] is '+' or '-' ? 1 : 0;
            good &= Digits(text, ref at) > 0;
        }

        return good && at == text.Length;
    }

    private static int Digits(string text, ref int at)
    {
        int start = at;
        while (at < text.Length && char.IsAsciiDigit(text[at]))
        {
            at++;
        }

        return at - start;
    }

    private JsonNode? Word()
    {
        int start = _at;
        string word = WordHere();
        _at += word.Length;
        return word switch
        {
            "true" or "false" => new(JsonKind.Boolean, start, _at, word),
            "null" => new(JsonKind.Null, start, _at, word),
            "" => Fail<JsonNode>(start, $"expected a value, but found {Found()}"),
            _ => Fail<JsonNode>(start, $"unknown word {Quotation.Of(word)}{(Spelling.DidYouMean(word, ["true", "false", "null"]) is { Length: > 0 } hint ? hint : ": a string needs double quotes")}"),
        };
    }

    private string WordHere()
    {
        int end = _at;
        while (end < _text.Length && (char.IsLetterOrDigit(_text[end]) || _text[end] is '_' or '$'))
        {
            end++;
        }

        return _text[_at..end];
    }

    // How messages call what stands here.
    private string Found()
    {
        if (_at == _text.Length)
        {
            return "the end of the file";
        }

        if (Peek() == '"')
        {
            return "a string";
        }

        if (Peek() == '\'')
        {
            return "a single quote";
        }

        string word = WordHere();
        return Quotation.Of(word.Length > 0 ? word : _text.Substring(_at, char.IsSurrogatePair(_text, _at) ? 2 : 1));
    }
}
