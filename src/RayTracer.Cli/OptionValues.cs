using System.Globalization;
using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>Makes options whose wrong values get messages that name the option and what was expected.</summary>
internal static class OptionValues
{
    /// <summary>A whole number within a range.</summary>
    public static ParsedOption<long?> Integer(string name, string description, long minimum, long maximum) => new(name, "N", description, word =>
        !long.TryParse(word, out long value) ? throw new FormatException($"expected a whole number, not {Quotation.Of(word)}")
        : value < minimum || value > maximum ? throw new FormatException($"must be from {minimum} to {maximum}, but is {value}")
        : value);

    /// <summary>A number within a range.</summary>
    public static ParsedOption<double?> Number(string name, string description, double minimum, double maximum) => new(name, "X", description, word =>
        !double.TryParse(word, NumberStyles.Float, null, out double value) ? throw new FormatException($"expected a number, not {Quotation.Of(word)}")
        : value >= minimum && value <= maximum ? value
        : throw new FormatException($"must be from {minimum} to {maximum}, but is {word}"));

    /// <summary>A fraction above 0 and below 1, given as such or in per cent.</summary>
    public static ParsedOption<double?> Fraction(string name, string description) => new(name, "X%", description, word =>
    {
        bool isPercent = word.EndsWith('%');
        return !double.TryParse(isPercent ? word[..^1] : word, NumberStyles.Float, null, out double value) ? throw new FormatException($"expected a number, as in 1% or 0.01, not {Quotation.Of(word)}")
            : (isPercent ? value / 100 : value) is > 0 and < 1 and double fraction ? fraction
            : throw new FormatException($"must be above 0 and below 100%, but is {word}");
    });

    /// <summary>A whole number that replaces a parameter of <see cref="RenderDescription"/>, with that parameter's range and meaning.</summary>
    /// <param name="name">The option's name.</param>
    /// <param name="property">The name of the property.</param>
    public static ParsedOption<long?> Parameter(string name, string property)
    {
        RecordParameter parameter = RecordType.Of(typeof(RenderDescription)).Parameters.First(p => p.PropertyName == property);
        return new(name, "N", $"{parameter.Summary} Overrides the scene's.", word =>
            !long.TryParse(word, out long value) ? throw new FormatException($"expected a whole number, not {Quotation.Of(word)}")
            : parameter.RangeComplaint(value) is { } complaint ? throw new FormatException(complaint)
            : value);
    }

    /// <summary>One name of an enumeration.</summary>
    public static ParsedOption<TEnum?> Choice<TEnum>(string name, string description)
        where TEnum : struct, Enum =>
        Choice<TEnum?>(name, description, [.. NamedValues.Of(typeof(TEnum))!.Names], [.. Enum.GetValues<TEnum>()]);

    /// <summary>One name of an open set.</summary>
    public static ParsedOption<T?> Choice<T>(Registry<T> known, string name, string description)
        where T : NamedValue => Choice<T?>(name, description, [.. known.Names], [.. known.All]);

    /// <summary>One of some words, each of which stands for a value; small and capital letters are the same.</summary>
    public static ParsedOption<T> Choice<T>(string name, string description, string[] words, T[] values) => new(name, string.Join('|', words), description, word =>
        Array.FindIndex(words, w => w.Equals(word, StringComparison.OrdinalIgnoreCase)) is >= 0 and int i ? values[i]
        : throw new FormatException($"unknown value {Quotation.Of(word)}{Spelling.DidYouMean(word, words)}, expected one of {string.Join(", ", words)}"));

    /// <summary>Some of the values of an enumeration, with commas between their words.</summary>
    public static ParsedOption<TEnum[]?> Words<TEnum>(string name, string description, Func<TEnum, string> word, TEnum[] values)
    {
        string[] words = [.. values.Select(word)];
        return new(name, string.Join(',', words), description, list => [.. list.Split(',').Select(part => Array.IndexOf(words, part) is >= 0 and int i ? values[i]
            : throw new FormatException($"unknown image {Quotation.Of(part)}{Spelling.DidYouMean(part, words)}, expected some of {string.Join(", ", words)}"))]);
    }

    /// <summary>Frames of an animation.</summary>
    public static ParsedOption<FrameRange?> Frames() => new(
        "--frames", "N|A..B|A..B:STEP",
        "Renders these frames of the animation, both ends included, each to its own file: -o frame-####.png. Frames that already exist are kept.", FrameRange.Parse);

    /// <summary>Whole numbers with commas between them, none negative.</summary>
    public static ParsedOption<int[]?> Integers(string name, string form, string description) => new(name, form, description, word =>
    {
        string[] parts = word.Split(',');
        int[] values = new int[parts.Length];
        bool good = parts.Length == form.Split(',').Length;
        for (int i = 0; i < parts.Length && good; i++)
        {
            good = int.TryParse(parts[i], NumberStyles.None, null, out values[i]);
        }

        return good ? values : throw new FormatException($"expected {form}, whole numbers not below 0, not {Quotation.Of(word)}");
    });
}
