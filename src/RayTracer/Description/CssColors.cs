using System.Collections.Frozen;
using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Description;

/// <summary>
/// The colours that a scene file may name: the 148 named colours of CSS Color Module Level 4 (section 6.1), in lower case.
/// </summary>
public static class CssColors
{
    private static readonly FrozenDictionary<string, string> Digits =
        EmbeddedTable.Read(typeof(CssColors), "css-colors.txt").ToFrozenDictionary(row => row[0], row => row[1], StringComparer.Ordinal);

    /// <summary>All names, in alphabetical order.</summary>
    public static IReadOnlyList<string> Names { get; } = [.. Digits.Keys.Order(StringComparer.Ordinal)];

    /// <summary>Finds a colour by its name.</summary>
    /// <param name="name">The name, in lower case.</param>
    /// <returns>The colour, linear; null where there is none of that name.</returns>
    public static Rgb? Find(string name) => Digits.TryGetValue(name, out string? digits) ? FromDigits(digits) : null;

    /// <summary>Reads <c>#rgb</c> or <c>#rrggbb</c>: sRGB codes in hexadecimal digits of either case.</summary>
    /// <param name="text">The text, with its #.</param>
    /// <returns>The colour, linear; null where the text is neither form.</returns>
    public static Rgb? FromHex(string text)
    {
        if (text is not ['#', .. { Length: 3 or 6 } digits] || !digits.All(char.IsAsciiHexDigit))
        {
            return null;
        }

        return FromDigits(digits.Length == 6 ? digits : string.Concat(digits.Select(d => new string(d, 2))));
    }

    /// <summary>Returns the colour of a name, or of <c>#rgb</c> or <c>#rrggbb</c>: what a scene file may have as text.</summary>
    /// <param name="text">The text.</param>
    /// <exception cref="FormatException">It is neither.</exception>
    public static Rgb Parse(string text) => Find(text) ?? FromHex(text) ?? throw new FormatException(text is ['#', ..]
        ? $"{Quotation.Of(text)} is not a colour: expected # and three or six hexadecimal digits"
        : $"unknown colour {Quotation.Of(text)}{Spelling.DidYouMean(text, Names)}");

    private static Rgb FromDigits(string digits) => new(Code(digits[..2]), Code(digits[2..4]), Code(digits[4..]));

    private static float Code(string digits) => SrgbCurve.Decode8(Convert.ToByte(digits, 16));
}
