namespace RayTracer.Repository.Tests.Testing;

/// <summary>The message about a file that is out of date.</summary>
public class RepositoryFolderTests
{
    [Theory]
    [InlineData("a\nb\nc", "a\nx\nc", "     2 - x\n     2 + b")]
    [InlineData("a\nb\nc", "a\nc", "     2 + b")]
    [InlineData("a\nc", "a\nb\nc", "     2 - b")]
    [InlineData("a\nb\n", "", "     1 + a\n     2 + b")]
    public void The_first_lines_that_differ_are_shown(string expected, string actual, string difference) =>
        Assert.Equal(difference, RepositoryFolder.FirstDifference(expected, actual));

    [Fact]
    public void Thousands_of_lines_that_differ_make_a_short_message()
    {
        string message = RepositoryFolder.FirstDifference(string.Join('\n', Enumerable.Range(0, 9000)), string.Join('\n', Enumerable.Range(9000, 9000)));
        Assert.Equal(14, message.Split('\n').Length);
        Assert.Contains("     1 - 9000\n", message, StringComparison.Ordinal);
        Assert.EndsWith("     6 + 5\n       + … and 8994 lines more", message, StringComparison.Ordinal);
    }
}
