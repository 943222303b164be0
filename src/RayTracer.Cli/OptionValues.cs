using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>Makes options whose wrong values get messages that name the option and what was expected.</summary>
internal static class OptionValues
{
    /// <summary>A whole number within a range.</summary>
    public static Option<long?> Integer(string name, string description, long minimum, long maximum) => Make<long?>(name, "N", description, word =>
        !long.TryParse(word, out long value) ? throw new FormatException($"expected a whole number, not {Quotation.Of(word)}")
        : value < minimum || value > maximum ? throw new FormatException($"must be from {minimum} to {maximum}, but is {value}")
        : value);

    /// <summary>A number within a range.</summary>
    public static Option<double?> Number(string name, string description, double minimum, double maximum) => Make<double?>(name, "X", description, word =>
        !double.TryParse(word, NumberStyles.Float, null, out double value) ? throw new FormatException($"expected a number, not {Quotation.Of(word)}")
        : value >= minimum && value <= maximum ? value
        : throw new FormatException($"must be from {minimum} to {maximum}, but is {word}"));

    /// <summary>A whole number that replaces a parameter of <see cref="RenderDescription"/>, with that parameter's range and meaning.</summary>
    /// <param name="name">The option's name.</param>
    /// <param name="property">The name of the property.</param>
    public static Option<long?> Parameter(string name, string property)
    {
        RecordParameter parameter = RecordType.Of(typeof(RenderDescription)).Parameters.First(p => p.PropertyName == property);
        return Make<long?>(name, "N", $"{parameter.Summary} Replaces the scene's.", word =>
            !long.TryParse(word, out long value) ? throw new FormatException($"expected a whole number, not {Quotation.Of(word)}")
            : parameter.RangeComplaint(value) is { } complaint ? throw new FormatException(complaint)
            : value);
    }

    /// <summary>One word of an enumeration, in small letters.</summary>
    public static Option<TEnum?> Choice<TEnum>(string name, string description)
        where TEnum : struct, Enum =>
        Choice<TEnum?>(name, description, [.. Enum.GetNames<TEnum>().Select(w => w.ToLowerInvariant())], [.. Enum.GetValues<TEnum>()]);

    /// <summary>One of some words, each of which stands for a value.</summary>
    public static Option<T> Choice<T>(string name, string description, string[] words, T[] values) => Make(name, string.Join('|', words), description, word =>
        Array.IndexOf(words, word) is >= 0 and int i ? values[i]
        : throw new FormatException($"unknown value {Quotation.Of(word)}{Spelling.DidYouMean(word, words)}, expected one of {string.Join(", ", words)}"));

    /// <summary>Whole numbers with commas between them, none negative.</summary>
    public static Option<int[]?> Integers(string name, string form, string description) => Make<int[]?>(name, form, description, word =>
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

    /// <summary>An option with a value that is read by <paramref name="parse"/>, which throws <see cref="FormatException"/>.</summary>
    private static Option<T> Make<T>(string name, string form, string description, Func<string, T> parse) => new(name)
    {
        Description = description,
        HelpName = form,
        CustomParser = result => Read(result, name, parse),
    };

    private static T? Read<T>(ArgumentResult result, string name, Func<string, T> parse)
    {
        string word = result.Tokens[^1].Value;
        try
        {
            return parse(word);
        }
        catch (FormatException e)
        {
            result.AddError($"{name} {word}: {e.Message}");
            return default;
        }
    }
}
