using System.Globalization;
using System.Text;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>The page about the tests says what the tests do.</summary>
public class TestingPageTests
{
    private const string Begin = "<!-- families: written by the tests where RAYTRACER_UPDATE is 1 -->\n";
    private const string End = "<!-- end of families -->\n";
    private static readonly string s_path = ProjectFolder.PathOf("docs", "testing.md");

    [Fact]
    public void The_table_of_families_is_the_error_budget()
    {
        string page = File.ReadAllText(s_path).ReplaceLineEndings("\n");
        int begin = page.IndexOf(Begin, StringComparison.Ordinal) + Begin.Length;
        int end = page.IndexOf(End, StringComparison.Ordinal);
        Assert.InRange(begin, Begin.Length, end);
        RepositoryFolder.AssertHolds(s_path, page[..begin] + Table() + page[end..]);
    }

    [Fact]
    public void Each_family_is_described()
    {
        string page = File.ReadAllText(s_path);
        Assert.All(ErrorBudget.Families, f => Assert.Contains($"\n- **{f.Name}**: ", page, StringComparison.Ordinal));
    }

    private static string Table()
    {
        StringBuilder table = new("| family | null hypothesis | share | p-values, at most | level of one |\n|---|---|---|---|---|\n");
        foreach (TestFamily f in ErrorBudget.Families)
        {
            table.Append(CultureInfo.InvariantCulture, $"| {f.Name} | {f.NullHypothesis} | {Power(f.Alpha)} | {f.Tests} | {Power(f.Level)} |\n");
        }

        return table.Append(CultureInfo.InvariantCulture, $"| all | | {Power(ErrorBudget.Families.Sum(f => f.Alpha))}, at most {Power(ErrorBudget.Whole)} | {ErrorBudget.Families.Sum(f => f.Tests)} | |\n").ToString();
    }

    private static string Power(double value) => value.ToString("0.0#e-0", CultureInfo.InvariantCulture);
}
