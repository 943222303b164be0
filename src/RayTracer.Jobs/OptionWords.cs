using System.Globalization;
using RayTracer.Description;

namespace RayTracer.Jobs;

/// <summary>Reads the values of options; what is wrong is a <see cref="FormatException"/> that says what was expected.</summary>
public static class OptionWords
{
    private const double LongestSeconds = 1e7;

    private static readonly (string Name, double Seconds)[] s_units =
        [("s", 1), ("sec", 1), ("m", 60), ("min", 60), ("h", 3600), ("d", 86400)];

    /// <summary>Reads a whole number within a range.</summary>
    public static long Integer(string word, long minimum, long maximum) =>
        !long.TryParse(word, out long value) ? throw new FormatException($"expected a whole number, not {Quotation.Of(word)}")
        : value < minimum || value > maximum ? throw new FormatException($"must be from {minimum} to {maximum}, but is {value}")
        : value;

    /// <summary>Reads a number within a range.</summary>
    public static double Number(string word, double minimum, double maximum) =>
        !double.TryParse(word, NumberStyles.Float, null, out double value)
            ? throw new FormatException($"expected a number, not {Quotation.Of(word)}")
        : value >= minimum && value <= maximum ? value
        : throw new FormatException($"must be from {minimum} to {maximum}, but is {word}");

    /// <summary>Reads an exposure: stops, or a word.</summary>
    public static Exposure Exposure(string word) => Description.Exposure.Named(word.ToLowerInvariant()) ?? (float)Number(word, -Description.Exposure.Limit, Description.Exposure.Limit);

    /// <summary>Reads a share, such as 50%.</summary>
    public static double Percentage(string word) => word.EndsWith('%') ? Number(word[..^1], 0.1, 10_000) / 100
        : throw new FormatException($"expected a percentage, as in 50%, not {Quotation.Of(word)}");

    /// <summary>Reads a fraction above 0 and below 1, given as such or in per cent.</summary>
    public static double Fraction(string word)
    {
        bool isPercent = word.EndsWith('%');
        return !double.TryParse(isPercent ? word[..^1] : word, NumberStyles.Float, null, out double value)
                ? throw new FormatException($"expected a number, as in 1% or 0.01, not {Quotation.Of(word)}")
            : (isPercent ? value / 100 : value) is > 0 and < 1 and double fraction ? fraction
            : throw new FormatException($"must be above 0 and below 100%, but is {word}{(!isPercent && value is >= 1 and < 100 ? $" ({word}%?)" : "")}");
    }

    /// <summary>Reads one of some words, however they are capitalised, each of which stands for a value.</summary>
    public static T Choice<T>(string word, IReadOnlyList<string> words, IReadOnlyList<T> values)
    {
        for (int i = 0; i < words.Count; i++)
        {
            if (words[i].Equals(word, StringComparison.OrdinalIgnoreCase))
            {
                return values[i];
            }
        }

        throw new FormatException(
            $"unknown value {Quotation.Of(word)}{Spelling.DidYouMean(word, words)}, expected one of {string.Join(", ", words)}");
    }

    /// <summary>The words of an enumeration, in small letters.</summary>
    public static string[] Of<T>()
        where T : struct, Enum => [.. Enum.GetNames<T>().Select(w => w.ToLowerInvariant())];

    /// <summary>Reads whole numbers with commas between them, none negative.</summary>
    /// <param name="word">The word.</param>
    /// <param name="form">A letter for each of them, with commas between.</param>
    public static int[] Integers(string word, string form)
    {
        string[] parts = word.Split(',');
        int[] values = new int[parts.Length];
        bool good = parts.Length == form.Split(',').Length;
        for (int i = 0; i < parts.Length && good; i++)
        {
            good = int.TryParse(parts[i], NumberStyles.None, null, out values[i]);
        }

        return good ? values : throw new FormatException($"expected {form}, whole numbers not below 0, not {Quotation.Of(word)}");
    }

    /// <summary>Reads a range of samples with its last one: 0..63.</summary>
    public static Rendering.SampleRange Samples(string word) =>
        word.Split("..") is [var first, var last] && int.TryParse(first, out int from) && int.TryParse(last, out int to) && from >= 0
            && to >= from && to < int.MaxValue
            ? new(from, to + 1)
            : throw new FormatException("expected the first and the last sample, as in 0..63");

    /// <summary>Reads a part, from 1: 3/16.</summary>
    public static (int Number, int Count) Part(string word) =>
        word.Split('/') is [var first, var last] && int.TryParse(first, out int number) && int.TryParse(last, out int count) && number >= 1
            && count >= number
            ? (number, count)
            : throw new FormatException("expected which part of how many, from 1, as in 3/16");

    /// <summary>Reads a length of time: 90s, 1h30m.</summary>
    /// <param name="word">The word.</param>
    /// <param name="allowsZero">True if there may be none.</param>
    public static TimeSpan Duration(string word, bool allowsZero = false) =>
        Seconds(word) is not { } seconds
            ? throw new FormatException($"expected a time, as in 90s, 10m, 1.5h or 1h30m, not {Quotation.Of(word)}")
        : seconds < LongestSeconds && (allowsZero ? seconds >= 0 : seconds > 0) ? TimeSpan.FromSeconds(seconds)
        : throw new FormatException(
            $"must {(allowsZero ? "not be below" : "be above")} 0 and below {LongestSeconds / 86400:F0} days, but is {word}");

    // Numbers with their units; a number alone is of seconds.
    private static double? Seconds(string word)
    {
        if (double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double plain))
        {
            return plain;
        }

        double sum = 0;
        for (ReadOnlySpan<char> rest = word; !rest.IsEmpty;)
        {
            int letters = rest.IndexOfAnyInRange('a', 'z');
            int next = letters < 0 ? rest.Length : letters + int.Max(rest[letters..].IndexOfAnyExceptInRange('a', 'z'), 0);
            next = next == letters ? rest.Length : next;
            string unit = letters < 0 ? "" : rest[letters..next].ToString();
            double seconds = s_units.FirstOrDefault(u => u.Name == unit).Seconds;
            if (seconds == 0
                || !double.TryParse(rest[..letters], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double value))
            {
                return null;
            }

            sum += value * seconds;
            rest = rest[next..];
        }

        return word.Length > 0 ? sum : null;
    }
}
