using System.Text;

namespace RayTracer.Description;

/// <summary>Quotes parts of a file in messages.</summary>
internal static class Quotation
{
    private const int Limit = 60;

    /// <summary>A number as it is written, shortened.</summary>
    public static string Short(string number) => number.Length > Limit ? number[..Limit] + "…" : number;

    /// <summary>The text in double quotes on one line: shortened, and what is not printed written as \u….</summary>
    public static string Of(string text)
    {
        StringBuilder quoted = new("\"");
        foreach (char c in text.AsSpan(0, Math.Min(text.Length, Limit)))
        {
            bool isPrinted = !char.IsControl(c) && c is not ('\u2028' or '\u2029' or '\uFEFF');
            quoted.Append(isPrinted ? c.ToString() : $"\\u{(int)c:X4}");
        }

        return quoted.Append(text.Length > Limit ? "…\"" : "\"").ToString();
    }
}
