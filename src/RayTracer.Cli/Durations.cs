using System.Globalization;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>Reads lengths of time: 90, 90s, 10m, 10min, 1.5h, 1h30m, 2d.</summary>
internal static class Durations
{
    private const double Longest = 1e7;

    private static readonly (string Name, double Seconds)[] s_units =
        [("s", 1), ("sec", 1), ("m", 60), ("min", 60), ("h", 3600), ("d", 86400)];

    /// <summary>An option whose value is a length of time.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="description">What it means.</param>
    /// <param name="allowsZero">Whether there may be none.</param>
    public static ParsedOption<TimeSpan?> Option(string name, string description, bool allowsZero = false) => new(name, "TIME", description, word =>
        Seconds(word) is not { } seconds ? throw new FormatException($"expected a time, as in 90s, 10m, 1.5h or 1h30m, not {Quotation.Of(word)}")
        : seconds < Longest && (allowsZero ? seconds >= 0 : seconds > 0) ? TimeSpan.FromSeconds(seconds)
        : throw new FormatException($"must {(allowsZero ? "not be below" : "be above")} 0 and below {Longest / 86400:F0} days, but is {word}"));

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
            if (seconds == 0 || !double.TryParse(rest[..letters], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double value))
            {
                return null;
            }

            sum += value * seconds;
            rest = rest[next..];
        }

        return word.Length > 0 ? sum : null;
    }
}
