using RayTracer.Description;
using RayTracer.Jobs;

namespace RayTracer.RenderTests.Bits;

/// <summary><see cref="BitVersions"/> and <c>hashes.txt</c> go together.</summary>
public class BitVersionTests
{
    // Changes since films were first written by which no picture became another: there are new scenes only.
    private static readonly int[] s_newScenes = [14, 16, 19, 20, 24, 25, 27, 28, 31, 32, 34, 35, 36, 37];
    private const int First = 13;

    [Fact]
    public void Each_change_of_bits_is_the_version_of_a_kind_of_things()
    {
        int changes = File.ReadLines(HashList.Path).Count(l => l.StartsWith("# ", StringComparison.Ordinal) && l.Split(". ")[0][2..].All(char.IsAsciiDigit));
        Assert.Equal(Enumerable.Range(First + 1, changes - First).Except(s_newScenes), BitVersions.All.Select(v => v.Version).Distinct().Order());
    }

    // Direct light alone has other bits by the points of its lights; light paths, only where one of many lights is chosen.
    [Theory]
    [InlineData("path", true)]
    [InlineData("volPath", true)]
    [InlineData("direct", true)]
    [InlineData("report", false)]
    [InlineData("vcm", false)]
    [InlineData("ao", false)]
    public void Integrators_of_other_bits_have_their_number(string integrator, bool isOther)
    {
        SceneDescription scene = new() { Render = new() { Integrator = Integrator.Known.Find(integrator)!, Splitting = 1 } };
        Assert.Equal(isOther, BitVersions.Of(scene).Any(v => v.Version == 26));
    }
}
