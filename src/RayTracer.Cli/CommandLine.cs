using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Parsing;
using System.Numerics;
using System.Reflection;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Import;
using RayTracer.Jobs;
using RayTracer.Labs;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>Finds the verb, runs it, and turns whatever goes wrong into one line and an exit status.</summary>
internal static class CommandLine
{
    // With the format of pictures that are not given one.
    private const string StandardOutput = "-.png";

    /// <summary>The program's name and version.</summary>
    public static string Version { get; } = $"raytracer {typeof(CommandLine).Assembly.GetName().Version!.ToString(3)}";

    // Which commit of the sources it was made from; null where they were in no repository.
    private static string? Commit { get; } =
        typeof(CommandLine).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion.Split('+') is [_, { Length: >= 12 } commit] ? commit[..12] : null;

    // Each verb's options are made only where they are needed: making all of them takes longer than a small picture.
    private static readonly Verb[] Verbs =
    [
        new("render", "Renders a scene into image files.", "render scene.json -o picture.png", RenderVerb.Build),
        new("sweep", "Renders a scene with several values of its settings, as one labelled contact sheet.", "sweep scene.json --set camera.fieldOfView=20,40 -o sheet.png", SweepVerb.Build),
        new("resume", "Resumes a film that was stopped, or adds samples to it.", "resume film.rtfilm --spp 1024 -o picture.png", ResumeVerb.Build),
        new("merge", "Adds up films that hold different samples of one picture.", "merge part1.rtfilm part2.rtfilm -o picture.exr", MergeVerb.Build),
        new("cluster", "Writes the jobs of a cluster that render the parts of a picture, and merge them.", "cluster slurm scene.json --tasks 16 -o picture.exr", ClusterVerb.Build),
        new("verify", "Renders an image or film again from what it says about its origin, and compares.", "verify picture.png", VerifyVerb.Build),
        new("check", "Reports everything that is wrong with scene files.", "check scene.json", CheckVerb.Build),
        new("info", "Reports the contents and memory use of a scene or model, and what a film or image says about itself.", "info picture.exr", InfoVerb.Build),
        new("explain", "Explains a part of the scene format: its meaning, unit, range and default.", "explain camera.fieldOfView", ExplainVerb.Build),
        new("convert", "Converts scenes of other formats to the native one, and images and films to other image formats.", "convert scene.xml scene.json", ConvertVerb.Build),
        new("compare", "Compares two images.", "compare picture.png reference.png --side-by-side both.png", CompareVerb.Build),
        new("compose", "Rebalances the lights of a rendered picture.", "compose layers.exr --light lamp=0.5 -o picture.png", ComposeVerb.Build),
        new("denoise", "Takes noise out of a film or an image.", "denoise noisy.exr -o clean.png", DenoiseVerb.Build),
        new("view", "Shows an image in the terminal.", "view picture.png", ViewVerb.Build),
        new("bench", "Measures how many rays are traced per second, or how fast errors fall by each integrator.", "bench scene.json", BenchVerb.Build),
        new("reproduce", "Renders the pictures and tables of the report that the project follows.", "reproduce report -o folder --quick", ReproduceVerb.Build),
        new("selftest", "Checks the materials, shapes and lights of a plug-in: samples against densities, energy, reciprocity, hits.", "selftest own.dll --output report", SelfTestVerb.Build),
        new("studio", "Opens the Studio, where scenes are edited and viewed, in a browser window.", "studio scene.json", StudioVerb.Build),
        new("lab", "The labs of the course: makes, checks and grades them.", "lab new 1", LabVerb.Build),
        new("schema", "Prints the JSON Schema of scene files.", "schema > raytracer.schema.json", (c, s) => c.SetAction(_ => s.Output.Write(SceneSchema.Generate()))),
        new("completion", "Prints the script that lets a shell complete this command.", "completion bash > raytracer.bash", CompletionVerb.Build),
        new("man", "Prints the manual page of this command, in the language of man(7).", "man > raytracer.1", ManVerb.Build),
        new("reference", "Prints the reference page of the scene format, in Markdown.", "reference > scene-format.md", (c, s) => c.SetAction(
            _ => s.Output.Write(SceneReference.Generate()))),
    ];

    private sealed record Verb(string Name, string Summary, string Example, Action<Command, Streams> Build);

    /// <summary>Runs a command.</summary>
    /// <param name="args">The words after the program's name.</param>
    /// <param name="streams">The streams to write to.</param>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public static int Run(string[] args, Streams streams)
    {
        Importers.Register();
        using InputFiles inputs = InputFiles.Begin();
        args = args is ["help", .. var words] ? [.. words, "--help"] : [.. args.Select((word, i) => IsToOutput(args, i) ? StandardOutput : word)];
        if (args.Where((word, i) => i > 0 && (args[i - 1] is "-o" or "--output") && AtomicFile.IsStandardOutput(word)).Any())
        {
            // The picture alone goes there.
            streams = streams with { Output = TextWriter.Null };
        }

        try
        {
            PluginFile.LoadAll(args);
            ParseResult result = Parse(args, streams);
            string? stray = Stray(result);
            string? empty = EmptyWord(result);
            if ((stray is not null || empty is not null || result.Errors.Count > 0) && result.Action is not HelpPage)
            {
                return WrongUsage(result, stray, empty, streams);
            }

            LimitOptions.Apply(result);
            return result.Invoke(new() { Output = streams.Output, Error = streams.Error, EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = null });
        }
        catch (Exception e)
        {
            return Report(e, streams);
        }
    }

    /// <summary>Parses a command without running it.</summary>
    public static ParseResult Parse(string[] args, Streams streams) => Root(args.FirstOrDefault(), streams).Parse(args, new() { ResponseFileTokenReplacer = null });

    /// <summary>A command as it is typed, without the word --, so that more words can follow.</summary>
    public static string Text(ParseResult result)
    {
        HashSet<string> names = Names(result);
        return Shell.Command(result.Tokens.Where(t => t.Type != TokenType.DoubleDash).Select(
            t => t.Value is ['-', ..] && names.Contains(t.Value) ? $"./{t.Value}" : t.Value));
    }

    /// <summary>All verbs with all of their options.</summary>
    public static IReadOnlyList<VerbHelp> Help(Streams streams) => [.. Verbs.SelectMany(v =>
    {
        Command command = new(v.Name, v.Summary);
        v.Build(command, streams);
        LanesOption.AddTo(command);
        LimitOptions.AddTo(command);
        return VerbHelp.Of(PluginOption.AddTo(command), Synopsis, v.Example);
    })];

    private static Command Root(string? verb, Streams streams)
    {
        Command root = new("raytracer", $"A Monte Carlo ray tracer.\n\n{ExitStatus.Help}");
        Option<bool> version = new("--version", "-v") { Description = "Shows the version, the commit and the number of vector lanes." };
        root.Options.Add(new HelpOption { Action = new HelpPage(streams, command => VerbHelp.Of(command, Synopsis, ExampleOf(command)).First()) });
        root.Options.Add(version);
        root.SetAction(result =>
        {
            if (!result.GetValue(version))
            {
                throw new CommandException(
                    ExitStatus.Usage, $"a verb is expected: {string.Join(", ", Verbs.Select(v => v.Name))} (see raytracer --help)");
            }

            streams.Output.WriteLine($"{Version} ({(Commit is { } commit ? $"commit {commit}, " : "")}{Vector<float>.Count} lanes)");
        });
        foreach ((string name, string summary, _, Action<Command, Streams> build) in Verbs)
        {
            Command command = new(name, summary);
            if (name == verb)
            {
                build(command, streams);
                LanesOption.AddTo(command);
                PluginOption.AddTo(command);
                LimitOptions.AddTo(command);
            }

            root.Subcommands.Add(command);
        }

        return root;
    }

    /// <summary>
    /// Returns a word that has no place; one that looks like an option comes first, even where the parser took it for an argument. After --,
    /// no word is an option.
    /// </summary>
    public static string? Stray(ParseResult result)
    {
        HashSet<string> names = Names(result);
        if (result.CommandResult.Command.Subcommands.Count > 0 && result.UnmatchedTokens is [not ['-', ..] and var verb, ..])
        {
            // Its options are not known either.
            return verb;
        }

        IEnumerable<string> arguments = result.CommandResult.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens)
            .Select(t => t.Value);
        return result.UnmatchedTokens.Concat(arguments)
            .FirstOrDefault(t => t is ['-', _, ..] && !names.Contains(t)) ?? (result.UnmatchedTokens is [var first, ..] ? first : null);
    }

    /// <summary>
    /// The complaint about an empty word, as shells make them of variables that are not set; null where there is none. No verb has a use
    /// for one.
    /// </summary>
    public static string? EmptyWord(ParseResult result)
    {
        foreach (SymbolResult part in result.CommandResult.Children)
        {
            string? name = part switch
            {
                ArgumentResult argument => argument.Argument.Name,
                OptionResult option => $"{option.IdentifierToken?.Value ?? option.Option.Name} {option.Option.HelpName}".TrimEnd(),
                _ => null,
            };
            if (name is not null && part.Tokens.Any(t => t.Value.Length == 0))
            {
                return $"{name}: the word is empty (is a variable of the shell not set?)";
            }
        }

        return null;
    }

    private static HashSet<string> Names(ParseResult result) =>
        [.. result.Tokens.SkipWhile(t => t.Type != TokenType.DoubleDash).Skip(1).Select(t => t.Value)];

    private static int WrongUsage(ParseResult result, string? stray, string? empty, Streams streams)
    {
        Command command = result.CommandResult.Command;
        IEnumerable<string> verbs = command.Subcommands.Where(c => !c.Hidden).Select(c => c.Name);
        bool isRoot = command.Name == "raytracer";
        streams.Fail(stray switch
        {
            null => empty ?? Missing(result) ?? OneLine(result.Errors[0].Message),
            ['-', ..] when !Names(result).Contains(stray) => UnknownOption(stray, command),
            _ when verbs.Any() =>
                $"unknown verb {Quotation.Of(stray)}{Spelling.DidYouMean(stray, verbs)}: expected one of {string.Join(", ", verbs)}",
            _ when OwnComplaint(result) is { } complaint => complaint,
            ['-', ..] => $"unexpected argument {Quotation.Of(stray)}: options must come before the word --",
            _ => $"unexpected argument {Quotation.Of(stray)}",
        });
        streams.Error.WriteLine(isRoot ? "usage: raytracer VERB …, see raytracer --help" : $"usage: {Name(command)} {Synopsis(command)}, see {Name(command)} --help");
        return ExitStatus.Usage;
    }

    // Of what must be there, and is not.
    private static string? Missing(ParseResult result)
    {
        Command command = result.CommandResult.Command;
        Argument? argument = command.Arguments.FirstOrDefault(a => a.Arity.MinimumNumberOfValues > (result.GetResult(a)?.Tokens.Count ?? 0));
        OptionResult? option = result.CommandResult.Children.OfType<OptionResult>().FirstOrDefault(o => o is { Implicit: false, Tokens.Count: 0 } && o.Option.Arity.MinimumNumberOfValues > 0);
        return option is not null ? $"{option.IdentifierToken!.Value} {option.Option.HelpName}: the value is missing".Replace("  ", " ", StringComparison.Ordinal)
            : argument is not null ? $"{argument.Name} is missing: {char.ToLowerInvariant(argument.Description![0])}{argument.Description[1..].TrimEnd('.')}" : null;
    }

    // What an option's value is wrong with, which may be another option that was taken for it.
    private static string? OwnComplaint(ParseResult result) =>
        result.Errors.Select(e => OneLine(e.Message)).FirstOrDefault(m => m.StartsWith("--", StringComparison.Ordinal));

    // With the commands that it is under.
    private static string Name(Symbol command) =>
        command.Parents.FirstOrDefault() is { } above ? $"{Name(above)} {command.Name}" : command.Name;

    private static string UnknownOption(string word, Command command) =>
        $"unknown option {Quotation.Of(word)}{Spelling.DidYouMean(word, command.Options.SelectMany(o => o.Aliases.Prepend(o.Name)))}";

    private static string Synopsis(Command command)
    {
        IEnumerable<string> words = command.Arguments.Select(a => a.Arity switch
        {
            { MinimumNumberOfValues: 2, MaximumNumberOfValues: 2 } => $"{a.Name} {a.Name}",
            { MinimumNumberOfValues: 0, MaximumNumberOfValues: 1 } => $"[{a.Name}]",
            { MinimumNumberOfValues: 0 } => $"[{a.Name}…]",
            { MaximumNumberOfValues: > 1 } => $"{a.Name}…",
            _ => a.Name,
        });
        return command.Subcommands.Count > 0 ? string.Join('|', command.Subcommands.Where(c => !c.Hidden).Select(c => c.Name))
            : string.Join(' ', words.Append("[options]"));
    }

    private static string ExampleOf(Symbol command) => command.Parents.FirstOrDefault() is { Name: not "raytracer" } above
        ? VerbHelp.ExampleBelow(above, command, ExampleOf(above))
        : Verbs.FirstOrDefault(v => v.Name == command.Name)?.Example ?? "render scene.json -o picture.png";

    private static bool IsToOutput(string[] args, int i) => i > 0 && args[i] == "-" && (args[i - 1] is "-o" or "--output");

    private static int Report(Exception e, Streams streams)
    {
        switch (e)
        {
            case CommandException command:
                streams.Fail(command.Message);
                return command.Status;
            case JobException { Fault: JobFault.Request }:
                streams.Fail(OneLine(e.Message).TrimEnd('.'));
                return ExitStatus.Usage;
            case JobException { Fault: JobFault.Plugin }:
                streams.Fail(e.Message);
                return ExitStatus.InputOutput;
            case JobException or PluginException or ImageWriteException or PictureException or LabException or IOException or UnauthorizedAccessException:
                streams.Fail(OneLine(e.Message).TrimEnd('.'));
                return ExitStatus.InputOutput;
            case OutOfMemoryException or { InnerException: OutOfMemoryException }:
                streams.Fail("there is not enough memory");
                return ExitStatus.InputOutput;
            default:
                streams.Fail($"internal error: {OneLine(e.Message)} ({Details(e)})");
                return ExitStatus.Internal;
        }
    }

    private static string Details(Exception e)
    {
        string path = Path.Combine(Path.GetTempPath(), $"raytracer-error-{Guid.NewGuid():N}.txt");
        try
        {
            File.WriteAllText(path, $"{Version}\n{Environment.OSVersion}, .NET {Environment.Version}\n{e}\n");
            return $"details in {path}";
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return $"its details could not be written to {path}";
        }
    }

    private static string OneLine(string message) => message.ReplaceLineEndings(" ");
}
