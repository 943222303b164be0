using System.CommandLine;
using System.CommandLine.Parsing;

namespace RayTracer.Cli;

/// <summary>
/// An option whose value is read from one word by a function. (The parser's own options of each type of value are compiled
/// for it, which takes longer than a small picture.)
/// </summary>
/// <typeparam name="T">A type with null for an option that is not given.</typeparam>
internal sealed class ParsedOption<T> : Option<string?>
{
    private readonly Func<string, T> _parse;

    /// <summary>Makes an option.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="form">The form of its value.</param>
    /// <param name="description">Its meaning.</param>
    /// <param name="parse">Reads the value; throws <see cref="FormatException"/> with what was expected.</param>
    public ParsedOption(string name, string form, string description, Func<string, T> parse)
        : base(name)
    {
        _parse = parse;
        (Description, HelpName) = (description, form);
        Validators.Add(Check);
    }

    /// <summary>The value.</summary>
    public T? Value(ParseResult result) => result.GetValue(this) is { } word ? _parse(word) : default;

    private void Check(OptionResult result)
    {
        if (result.Tokens is not [.., { Value: var word }])
        {
            return;
        }

        try
        {
            _parse(word);
        }
        catch (FormatException e)
        {
            result.AddError($"{Name} {word}: {e.Message}");
        }
    }
}
