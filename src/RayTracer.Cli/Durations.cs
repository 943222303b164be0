using System.Globalization;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>Reads lengths of time: 90, 90s, 10m, 1.5h, 2d.</summary>
internal static class Durations
{
    private const double Longest = 1e7;

    /// <summary>An option whose value is a length of time.</summary>
    public static ParsedOption<TimeSpan?> Option(string name, string description) => new(name, "TIME", description, word => Parse(word));

    private static TimeSpan Parse(string word)
    {
        double unit = word is [.., var last] ? last switch { 'm' => 60, 'h' => 3600, 'd' => 86400, _ => 1 } : 1;
        string number = word is [.., 's' or 'm' or 'h' or 'd'] ? word[..^1] : word;
        return !double.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) ? throw new FormatException($"expected a time, as in 90s, 10m or 1.5h, not {Quotation.Of(word)}")
            : value * unit is > 0 and < Longest and double seconds ? TimeSpan.FromSeconds(seconds)
            : throw new FormatException($"must be above 0 and below {Longest / 86400:F0} days, but is {word}");
    }
}
