using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>Figures between the markers of docs/measure.sh say when and on which machine they were measured; <see cref="CommandsTests"/> sees to the commands.</summary>
public sealed partial class FiguresTests
{
    [Theory]
    [InlineData("docs/report.md")]
    [InlineData("docs/how-fast-is-it.md")]
    public void Measured_figures_have_a_command_a_day_and_a_machine(string page)
    {
        string text = File.ReadAllText(ProjectFolder.PathOf(page)).ReplaceLineEndings("\n");
        var blocks = Block().Matches(text).Select(m => (Command: m.Groups["command"].Value, Figures: m.Groups["figures"].Value)).ToArray();
        Assert.Equal(Regex.Count(text, "<!-- (measured: |end of measured)"), 2 * blocks.Length);
        Assert.All(blocks, b => Assert.Contains("\n| ", b.Figures, StringComparison.Ordinal));

        // One block of each command has the machine.
        Assert.All(blocks.GroupBy(b => b.Command), of => Assert.Contains(of, b => Machine().IsMatch(b.Figures)));
    }

    [GeneratedRegex(@"<!-- measured: (?<command>[^|\n]+?)( \| [^\n]+)? -->\n(?<figures>.*?)\n<!-- end of measured -->", RegexOptions.Singleline | RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Block();

    [GeneratedRegex(@"Date\W+20\d\d-\d\d-\d\d.*Processor\W+\w+.*Load", RegexOptions.Singleline | RegexOptions.IgnoreCase | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Machine();
}
