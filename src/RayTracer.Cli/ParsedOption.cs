using System.CommandLine;
using System.CommandLine.Parsing;

namespace RayTracer.Cli;

/// <summary>
/// An option whose value is read from one word by a function. (The parser's own options of each type of value are compiled
/// anew for it, which takes longer than a small picture.)
/// </summary>
/// <typeparam name="T">A type with null for an option that is not given.</typeparam>
internal sealed class ParsedOption<T>
{
    private readonly Func<string, T> _parse;

    /// <summary>Makes an option.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="form">What its value looks like.</param>
    /// <param name="description">What it means.</param>
    /// <param name="parse">Reads the value; throws <see cref="FormatException"/> with what was expected.</param>
    public ParsedOption(string name, string form, string description, Func<string, T> parse)
    {
        _parse = parse;
        Symbol = new(name) { Description = description, HelpName = form };
        Symbol.Validators.Add(Check);
    }

    /// <summary>What a command is given.</summary>
    public Option<string?> Symbol { get; }

    /// <summary>The value.</summary>
    public T? Value(ParseResult result) => result.GetValue(Symbol) is { } word ? _parse(word) : default;

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
            result.AddError($"{Symbol.Name} {word}: {e.Message}");
        }
    }
}
