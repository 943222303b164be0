using System.CommandLine;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>Makes options whose wrong values get messages that name the option and what was expected.</summary>
internal static class OptionValues
{
    /// <summary>Gives a command options.</summary>
    public static void AddOptions(this Command command, params IEnumerable<Option> options) =>
        options.ToList().ForEach(command.Options.Add);

    /// <summary>A whole number within a range.</summary>
    public static ParsedOption<long?> Integer(string name, string description, long minimum, long maximum) =>
        new(name, "N", description, word => OptionWords.Integer(word, minimum, maximum));

    /// <summary>A number within a range.</summary>
    public static ParsedOption<double?> Number(string name, string description, double minimum, double maximum) =>
        new(name, "X", description, word => OptionWords.Number(word, minimum, maximum));

    /// <summary>One word of an enumeration, however it is capitalised.</summary>
    public static ParsedOption<TEnum?> Choice<TEnum>(string name, string description)
        where TEnum : struct, Enum => Choice<TEnum?>(name, description, OptionWords.Of<TEnum>(), [.. Enum.GetValues<TEnum>()]);

    /// <summary>One of some words, each of which stands for a value.</summary>
    public static ParsedOption<T> Choice<T>(string name, string description, string[] words, T[] values) =>
        new(name, string.Join('|', words), description, word => OptionWords.Choice(word, words, values));
}
