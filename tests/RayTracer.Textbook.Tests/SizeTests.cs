namespace RayTracer.Textbook.Tests;

/// <summary>The edition is read in a day: it stays as small as docs/textbook.md says.</summary>
public sealed class SizeTests
{
    [Fact]
    public void Without_trees_and_rasterizer_it_has_at_most_four_thousand_lines()
    {
        string folder = ProjectFolder.PathOf("src", "RayTracer.Textbook");
        string[] own = [.. Directory.GetDirectories(folder).Where(d => char.IsDigit(Path.GetFileName(d)[0]) && !d.EndsWith("4-Trees", StringComparison.Ordinal) && !d.EndsWith("12-Rasterizer", StringComparison.Ordinal))];
        Assert.True(own.Length >= 10);
        Assert.InRange(own.SelectMany(d => Directory.GetFiles(d, "*.cs", SearchOption.AllDirectories)).Sum(f => File.ReadLines(f).Count()), 3000, 4000);
    }
}
