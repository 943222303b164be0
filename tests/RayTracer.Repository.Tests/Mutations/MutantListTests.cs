using RayTracer.Mutations;

namespace RayTracer.Repository.Tests.Mutations;

/// <summary>The list of mutants fits the source. It is left out where mutants are tried: it would see each of them in the text.</summary>
[Trait("Category", "Pinned")]
public class MutantListTests
{
    private static readonly string[] s_areas = ["sampling", "pdf", "material", "light", "geometry", "texture", "camera", "depth", "film", "threading", "bvh", "instance", "motion", "mesh", "import", "layers", "transport", "medium", "pairs", "light paths", "guiding", "matte", "course"];
    private static readonly IReadOnlyList<Mutant> s_mutants =
        Mutant.ReadAll(File.ReadLines(ProjectFolder.PathOf("tests", "RayTracer.Mutations", "mutants.txt")));

    [Fact]
    public void Every_mutant_still_applies_to_the_source() =>
        Assert.All(s_mutants, m => Assert.NotEqual(m.Before, m.Apply(File.ReadAllText(ProjectFolder.PathOf(m.File.Split('/'))))));

    [Fact]
    public void Every_part_of_the_program_has_mutants()
    {
        Assert.True(s_mutants.Count >= 40);
        Assert.Equal(s_areas.Order(), s_mutants.Select(m => m.Area).Distinct().Order());
        Assert.All(s_areas, area => Assert.True(s_mutants.Count(m => m.Area == area) >= 3, area));
        Assert.Equal(s_mutants.Count, s_mutants.DistinctBy(m => (m.Area, m.Name)).Count());
    }

    [Theory]
    [InlineData("a b a", "a")]
    [InlineData("b", "a")]
    public void Text_that_is_not_there_once_is_an_error(string source, string before)
    {
        Mutant mutant = new("film", "test", "file", [], before, "c");
        Assert.Contains("exactly once", Assert.Throws<FormatException>(() => mutant.Apply(source)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("## no-area\nfile f\ntests T\n-a\n+b")]
    [InlineData("## film: no-lines\nfile f\ntests T")]
    [InlineData("## film: no-file\ntests T\n-a\n+b")]
    public void An_incomplete_entry_is_an_error(string entry) =>
        Assert.Throws<FormatException>(() => Mutant.ReadAll(entry.Split('\n')));
}
