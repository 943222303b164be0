using System.Text.RegularExpressions;
using RayTracer.Cli;
using RayTracer.Description;

namespace RayTracer.Cli.Tests;

/// <summary>What is made from the commands: shell completion and the manual page.</summary>
public class HelpTests
{
    private static readonly IReadOnlyList<VerbHelp> s_verbs = CommandLine.Help(new(TextWriter.Null, TextWriter.Null));

    [Theory]
    [InlineData("bash")]
    [InlineData("zsh")]
    [InlineData("fish")]
    [InlineData("pwsh")]
    public void A_shell_gets_every_verb_and_option(string shell)
    {
        CliRun run = CliRun.Of("completion", shell);
        Assert.Equal((0, ""), (run.Status, run.Error));
        foreach (VerbHelp verb in s_verbs)
        {
            string[] lines = [.. run.Output.Split('\n').Where(l => Regex.IsMatch(l, $@"\b{verb.Name.Split(' ')[^1]}\b", RegexOptions.None, TimeSpan.FromSeconds(10)))];
            Assert.NotEmpty(lines);
            Assert.All(verb.Options.SelectMany(o => o.Names), name => Assert.Contains(shell == "fish" ? $" -{(name[1] == '-' ? "l " + name[2..] : "s " + name[1..])} " : name, run.Output + " ", StringComparison.Ordinal));
        }

        Assert.DoesNotContain("\r", run.Output, StringComparison.Ordinal);
    }

    [ProgramFact("bash")]
    public void Bash_completes()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["c.bash"], CliRun.Of("completion", "bash").Output);
        string script = $$"""
            source '{{folder["c.bash"]}}'
            t() { COMP_WORDS=(raytracer "$@"); COMP_CWORD=$#; COMPREPLY=(); _raytracer; echo "${COMPREPLY[*]}"; }
            t ren; t render --integ; t render --integrator vol; t render -o ''; t completion p; t check --format s
            t cluster ''; t cluster slurm --pa; t cluster slurm --tonemap re; t render --frames ''; t reproduce ''
            t render --tonemap = a; t render --chroma =
            """;
        string[] words = ["render", "--integrator", "volPath", "", "pwsh", "sarif", "slurm", "--partition", "reinhard", "", "report complexity", "aces agx", "full half"];
        Assert.Equal((0, string.Concat(words.Select(w => w + "\n"))), ProgramFactAttribute.Run("bash", "-c", script));
    }

    [ProgramFact("fish")]
    public void Fish_completes()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["c.fish"], CliRun.Of("completion", "fish").Output);
        string script = $$"""
            source '{{folder["c.fish"]}}'
            for line in 'cluster ' 'cluster slurm --pa' 'render --tonemap=ag' 'reproduce '
                complete -C "raytracer $line" | string replace -r '\t.*' ''
            end
            true
            """;
        Assert.Equal((0, "slurm\n--partition\n--tonemap=agx\ncomplexity\nreport\n"), ProgramFactAttribute.Run("fish", "--no-config", "-c", script));
    }

    [Fact]
    public void Only_words_that_can_be_typed_are_offered()
    {
        IEnumerable<string> words = s_verbs.SelectMany(v => v.Choices.Concat(v.Options.SelectMany(o => o.Choices)));
        // Names of scene files stand as they are written there, and are understood in any case; all else is written in small letters.
        IEnumerable<string> names = Integrator.Known.All.Select(i => i.Name);
        Assert.All(words.Except(names), w => Assert.DoesNotContain(w, char.IsAsciiLetterUpper));
        Assert.Contains(s_verbs, v => v is { Name: "cluster slurm", Options.Count: > 10 });
        Assert.Contains("--tonemap=[", CliRun.Of("completion", "zsh").Output, StringComparison.Ordinal);
    }

    [ProgramFact("zsh")]
    public void Zsh_reads_its_script() => IsRead("zsh", "-n");

    [ProgramFact("fish")]
    public void Fish_reads_its_script() => IsRead("fish", "-n");

    [Fact]
    public void A_shell_that_is_not_known_is_refused()
    {
        CliRun run = CliRun.Of("completion", "bsh");
        Assert.Equal((2, ""), (run.Status, run.Output));
        Assert.Contains("unknown shell \"bsh\" (did you mean \"bash\"?), expected one of bash, zsh, fish, pwsh", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void The_manual_page_has_every_verb_and_option()
    {
        string page = CliRun.Of("man").Output;
        Assert.StartsWith(".TH RAYTRACER 1 ", page, StringComparison.Ordinal);
        Assert.All(s_verbs, verb => Assert.Contains($"\n.SS {verb.Name.Replace("-", "\\-", StringComparison.Ordinal)}\n", page, StringComparison.Ordinal));
        Assert.All(s_verbs.SelectMany(v => v.Options).SelectMany(o => o.Names), name => Assert.Contains($"\\fB{name.Replace("-", "\\-", StringComparison.Ordinal)}\\fR", page, StringComparison.Ordinal));
        Assert.All(page, c => Assert.InRange(c, '\n', '~'));
    }

    [ProgramFact("groff")]
    public void The_manual_page_is_set_without_warnings()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["raytracer.1"], CliRun.Of("man").Output);
        (int status, string output) = ProgramFactAttribute.Run("groff", "-man", "-ww", "-Tutf8", "-z", folder["raytracer.1"]);
        Assert.Equal((0, ""), (status, output));
    }

    [Fact]
    public void The_version_has_the_commit_of_the_sources()
    {
        CliRun run = CliRun.Of("--version");
        Assert.Equal(run, CliRun.Of("-v"));
        Assert.Matches(@"^raytracer \d+\.\d+\.\d+ \((commit [0-9a-f]{12}, )?\d+ lanes\)\s*$", run.Output);
    }

    [Fact]
    public void Help_is_in_groups_whose_first_column_is_narrow_with_an_example_that_is_understood()
    {
        Assert.All(s_verbs.Where(v => !v.HasVerbs), verb =>
        {
            CliRun run = CliRun.Fine([.. verb.Name.Split(' '), "--help"]);
            Assert.Contains($"\nExample: {verb.Example}", run.Output.ReplaceLineEndings("\n"), StringComparison.Ordinal);
            string[] rows = [.. run.Output.ReplaceLineEndings("\n").Split('\n').Where(l => l.StartsWith("  ", StringComparison.Ordinal))];
            Assert.All(rows, r => Assert.Equal("  ", r[28..30]));
            Assert.All(rows, r => Assert.InRange(r.Length, 31, 110));
            Assert.All(verb.Options.SelectMany(o => o.Names), name => Assert.Contains(rows, r => r[..28].Split(' ', ',').Contains(name)));
            Assert.Equal(run.Output, CliRun.Fine(["help", .. verb.Name.Split(' ')]).Output);
        });
        string render = CliRun.Fine("help", "render").Output;
        Assert.Matches(@"(?s)\nScene\s+--width N .*\nAnimations\s+--frames ", render);
        Assert.Contains("One of sobol, jittered, regular, independent.", string.Join(' ', render.Split((char[])[' ', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries)), StringComparison.Ordinal);
    }

    [Fact]
    public void Help_of_the_command_lists_its_verbs_and_statuses()
    {
        string page = CliRun.Fine("help").Output;
        Assert.Equal(page, CliRun.Fine("--help").Output);
        Assert.All(s_verbs.Where(v => !v.Name.Contains(' ', StringComparison.Ordinal)), v => Assert.Contains($"\n  {v.Name} ", page.ReplaceLineEndings("\n"), StringComparison.Ordinal));
        Assert.Contains("-v, --version", page, StringComparison.Ordinal);
        Assert.Contains("Exit status: 0 fine", page, StringComparison.Ordinal);
    }

    private static void IsRead(string shell, string check)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["script"], CliRun.Of("completion", shell).Output);
        Assert.Equal((0, ""), ProgramFactAttribute.Run(shell, check, folder["script"]));
    }
}
