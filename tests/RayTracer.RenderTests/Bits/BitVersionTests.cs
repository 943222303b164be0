using RayTracer.Jobs;

namespace RayTracer.RenderTests.Bits;

/// <summary><see cref="BitVersions"/> and <c>hashes.txt</c> go together.</summary>
public class BitVersionTests
{
    // Changes since films were first written by which no picture became another: there are new scenes only.
    private static readonly int[] s_newScenes = [14, 16, 19, 20, 24, 25];
    private const int First = 13;

    [Fact]
    public void Each_change_of_bits_is_the_version_of_a_kind_of_things()
    {
        int changes = File.ReadLines(HashList.Path).Count(l => l.StartsWith("# ", StringComparison.Ordinal) && l.Split(". ")[0][2..].All(char.IsAsciiDigit));
        Assert.Equal(Enumerable.Range(First + 1, changes - First).Except(s_newScenes), BitVersions.All.Select(v => v.Version).Distinct().Order());
    }
}
