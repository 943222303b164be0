using System.CommandLine;
using System.CommandLine.Parsing;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>Options of jobs (<see cref="JobOptions"/>) as those of a command.</summary>
internal sealed class JobOptionSet
{
    private static readonly RenderJob s_none = new() { Scene = "" };
    private readonly (JobOption Option, Option Symbol)[] _options;

    /// <summary>Makes the options.</summary>
    public JobOptionSet(IEnumerable<JobOption> options) => _options = [.. options.Select(o => (o, SymbolOf(o)))];

    /// <summary>Makes the options, and gives a command them.</summary>
    public JobOptionSet(Command command, IEnumerable<JobOption> options)
        : this(options) => Array.ForEach(_options, o => command.Options.Add(o.Symbol));

    /// <summary>The options as those of a command.</summary>
    public IEnumerable<Option> Symbols => _options.Select(o => o.Symbol);

    /// <summary>Returns one of them as that of a command.</summary>
    public Option Symbol(JobOption option) => _options.First(o => o.Option == option).Symbol;

    /// <summary>Returns whether an option was given.</summary>
    public bool Has(ParseResult result, string name) => Values(result, _options.First(o => o.Option.Name == name).Symbol).Any();

    /// <summary>A job with the values that were given; options go before settings.</summary>
    public RenderJob Put(ParseResult result, RenderJob job) => _options.OrderByDescending(o => o.Option.IsRepeated)
        .Aggregate(job, (all, o) => Values(result, o.Symbol).Aggregate(all, o.Option.Put));

    /// <summary>The job of no scene with the values that were given.</summary>
    public RenderJob Given(ParseResult result) => Put(result, s_none);

    /// <summary>The options that were given, as words of a command line.</summary>
    public IEnumerable<string> Words(ParseResult result) =>
        _options.SelectMany(
            o => Values(result, o.Symbol).SelectMany(v => o.Option.Form is null ? [o.Option.Name] : new[] { o.Option.Name, v }));

    /// <summary>Warns of options that were given, but are for formats of which there is no file.</summary>
    /// <param name="result">The words that were given.</param>
    /// <param name="files">The files to write.</param>
    /// <param name="streams">Takes the warnings.</param>
    /// <param name="isSeen">True if exposure and tone map are seen elsewhere too.</param>
    public void WarnOfUnused(ParseResult result, IReadOnlyList<string> files, Streams streams, bool isSeen)
    {
        foreach ((JobOption option, Option symbol) in _options.Where(
            o => o.Option.Feature is not null && !(isSeen && o.Option.Feature == ImageFeatures.Display)))
        {
            WritingOptions.WarnOfUnused(result, symbol, option.Feature!.Value, files, streams);
        }
    }

    private static IEnumerable<string> Values(ParseResult result, Option symbol) =>
        result.GetResult(symbol) is not { Implicit: false } given ? []
        : symbol is Option<bool> flag ? (result.GetValue(flag) ? ["true"] : [])
        : symbol is Option<string[]> ? given.Tokens.Select(t => t.Value) : [given.Tokens[^1].Value];

    private static Option SymbolOf(JobOption option)
    {
        Option symbol = option.Form is null ? new Option<bool>(option.Name)
            : option.IsRepeated ? new Option<string[]>(option.Name) : new Option<string?>(option.Name);
        symbol.Description = option.Description;
        symbol.HelpName = option.Form;
        if (option.Form is not null)
        {
            symbol.Validators.Add(result => Check(option, result));
        }

        return symbol;
    }

    private static void Check(JobOption option, OptionResult result)
    {
        foreach (string word in result.Tokens.Select(t => t.Value).Where(w => w.Length > 0).TakeLast(option.IsRepeated ? int.MaxValue : 1))
        {
            try
            {
                option.Put(s_none, word);
            }
            catch (FormatException e)
            {
                result.AddError($"{option.Name} {word}: {e.Message}");
            }
        }
    }
}
