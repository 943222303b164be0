using System.Globalization;
using System.Text;

namespace RayTracer.Cli;

/// <summary>The manual page raytracer(1), in the language of man(7).</summary>
internal static class ManualPage
{
    private static readonly (string Name, string Meaning)[] s_environment =
    [
        ("NO_COLOR", "If set, no colours are written."),
        ("TERM, TERM_PROGRAM, KITTY_WINDOW_ID", "Indicate how the terminal shows pictures."),
        ("DOTNET_MaxVectorTBitWidth", "The vector width; the program itself sets it to 512 where the processor supports that. Pictures have the same bits either way."),
    ];

    /// <summary>The page.</summary>
    public static string Write(IReadOnlyList<VerbHelp> verbs)
    {
        StringBuilder page = new();
        page.Append(CultureInfo.InvariantCulture, $".TH RAYTRACER 1 \"\" \"{CommandLine.Version}\" \"User Commands\"\n.ad l\n");
        page.Append(".SH NAME\nraytracer \\- a Monte Carlo ray tracer\n.SH SYNOPSIS\n");
        foreach (VerbHelp verb in verbs)
        {
            page.Append(CultureInfo.InvariantCulture, $".B raytracer {Text(verb.Name)}\n{Text(verb.Synopsis)}\n.br\n");
        }

        page.Append(".SH DESCRIPTION\nRenders scenes that are described in JSON files, reads and writes images, and helps with both. Results go to standard output; errors, warnings and progress to standard error.\n.SH VERBS\n");
        foreach (VerbHelp verb in verbs)
        {
            Add(page, verb);
        }

        page.Append(".SH EXIT STATUS\n").Append(Text(ExitStatus.Help.ReplaceLineEndings(" ").Replace("Exit status: ", "", StringComparison.Ordinal))).Append("\n.SH ENVIRONMENT\n");
        foreach ((string name, string meaning) in s_environment)
        {
            page.Append(CultureInfo.InvariantCulture, $".TP\n.B {Text(name)}\n{Text(meaning)}\n");
        }

        return page.ToString();
    }

    private static void Add(StringBuilder page, VerbHelp verb)
    {
        page.Append(CultureInfo.InvariantCulture, $".SS {Text(verb.Name)}\n{Text(verb.Summary)}\n");
        foreach ((string name, string summary) in verb.Arguments)
        {
            page.Append(CultureInfo.InvariantCulture, $".TP\n.I {Text(name)}\n{Text(summary)}\n");
        }

        page.Append(CultureInfo.InvariantCulture, $".TP\nExample\n.B {Text(verb.Example)}\n");

        // Lists of words may be longer than a line: it may end after each comma.
        foreach (OptionHelp option in verb.Options)
        {
            string names = string.Join(", ", option.Names.Select(n => $"\\fB{Text(n)}\\fR"));
            page.Append(CultureInfo.InvariantCulture, $".TP\n{names}{(option.Form is { } form ? $" \\fI{Text(form).Replace(",", ",\\:", StringComparison.Ordinal)}\\fR" : "")}\n{Text(option.Summary)}\n");
        }
    }

    // Signs that the language has for itself, and those that a terminal may not have, by their numbers.
    private static string Text(string text)
    {
        StringBuilder escaped = new(text.StartsWith('.') || text.StartsWith('\'') ? "\\&" : "");
        foreach (Rune rune in text.EnumerateRunes())
        {
            escaped.Append(rune.Value switch
            {
                '\\' => "\\e",
                '-' => "\\-",
                '\n' => " ",
                '…' => "...",
                > 126 => string.Create(CultureInfo.InvariantCulture, $"\\[u{rune.Value:X4}]"),
                _ => rune.ToString(),
            });
        }

        return escaped.ToString();
    }
}
