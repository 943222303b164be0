using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Tests.Description;

public class SpellingTests
{
    [Theory]
    [InlineData("diffuse", "diffuse", 0)]
    [InlineData("", "abc", 3)]
    [InlineData("diffus", "diffuse", 1)]
    [InlineData("raduis", "radius", 1)]
    [InlineData("kitten", "sitting", 3)]
    public void Distance_counts_edits_and_swaps(string a, string b, int expected)
    {
        Assert.Equal(expected, EditDistance.Between(a, b));
        Assert.Equal(expected, EditDistance.Between(b, a));
    }

    [Theory]
    [InlineData("colour", "color")]
    [InlineData("spp", "samplesPerPixel")]
    [InlineData("LOOKAT", "lookAt")]
    [InlineData("postion", "position")]
    [InlineData("teapot", null)]
    public void Nearest_finds_what_was_meant(string word, string? expected) =>
        Assert.Equal(expected, Spelling.Nearest(word, ["position", "lookAt", "color", "samplesPerPixel"]));
}
