using System.Globalization;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Reads parameters: a declaration of type and name, and values, one or several in brackets.</summary>
/// <param name="log">Takes what is wrong.</param>
internal sealed class PbrtValues(ImportLog log)
{
    // With the older names of types.
    private static readonly Dictionary<string, string> s_types = """
        integer integer, float float, point2 point2, vector2 vector2, point3 point3, vector3 vector3, normal3 normal3, point point3, vector vector3,
        normal normal3, spectrum spectrum, rgb rgb, color rgb, blackbody blackbody, bool bool, string string, texture texture
        """.Split([',', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
        .Select(entry => entry.Split(' ')).ToDictionary(words => words[0], words => words[1]);

    private readonly List<float> _numbers = [];
    private readonly List<string> _words = [];

    /// <summary>The parameter of a declaration whose values come next; null after an error.</summary>
    public PbrtParameter? Read(PbrtToken declaration, PbrtText text)
    {
        string[] words = declaration.Text.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
        bool isDeclared = words.Length == 2 && s_types.ContainsKey(words[0]);
        if (!isDeclared)
        {
            string found = $"expected a type and a name, as in \"float radius\", but found {Quotation.Of(declaration.Text)}";
            log.Error(declaration.Place, found + (words.Length == 2 ? ImportLog.Hint(words[0], s_types.Keys) : ""));
        }

        string type = isDeclared ? s_types[words[0]] : "";
        bool isRead = ReadValues(declaration, text);
        return isDeclared && isRead && IsOf(type, declaration) ? new(type, words[1], declaration.Place, _numbers, _words) : null;
    }

    private bool ReadValues(PbrtToken declaration, PbrtText text)
    {
        if (text.Peek()?.Is("[") != true)
        {
            return text.Peek() is { } only && !only.Is("]") ? Take(text.Next()!.Value)
                : log.Fail<bool>(declaration.Place, $"{Quotation.Of(declaration.Text)} has no value");
        }

        PbrtToken open = text.Next()!.Value;
        bool isRead = true;
        while (text.Next() is { } token)
        {
            if (token.Is("]"))
            {
                return isRead;
            }

            isRead = isRead && Take(token);
        }

        return log.Fail<bool>(open.Place, "the bracket is not closed");
    }

    private bool Take(PbrtToken token)
    {
        if (token.IsQuoted || token.Text is "true" or "false")
        {
            _words.Add(token.Text);
            return true;
        }

        if (float.TryParse(token.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out float number) && float.IsFinite(number))
        {
            if (_numbers.Count % 65536 == 0 && SceneBudget.Open?.Take("a list of numbers", 65536L * 4, 65536) is { } complaint)
            {
                return log.Fail<bool>(token.Place, complaint);
            }

            _numbers.Add(number);
            return true;
        }

        return log.Fail<bool>(token.Place, $"expected a number, true, false or a text in quotation marks, but found {Quotation.Of(token.Text)}");
    }

    private bool IsOf(string type, PbrtToken declaration)
    {
        bool wantsWords = type is "bool" or "string" or "texture";
        bool isRight = type == "spectrum" ? _numbers.Count == 0 || _words.Count == 0 : wantsWords ? _numbers.Count == 0 : _words.Count == 0;
        if (isRight && _numbers.Count + _words.Count > 0)
        {
            return true;
        }

        string expected = wantsWords ? type == "bool" ? "true or false" : "texts in quotation marks" : "numbers";
        return log.Fail<bool>(declaration.Place, $"expected {expected} for {Quotation.Of(declaration.Text)}");
    }
}
