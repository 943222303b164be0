using RayTracer.Rendering;

namespace RayTracer.RenderTests.Bits;

/// <summary>
/// The very bits of small pictures of all scenes. Whoever changes a picture changes <c>hashes.txt</c> in the same commit and
/// says there why.
/// </summary>
[Trait("Category", "Pinned")]
public class HashTests
{
    private static readonly bool s_update = Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1";

    [Fact]
    public void Films_have_the_committed_hashes()
    {
        Dictionary<string, string> hashes = BitScenes.All.ToDictionary(name => name, name => new RTracer(BitScenes.Load(name)).Render().Film.ComputeHash());
        HashList committed = HashList.Read();
        if (s_update)
        {
            File.WriteAllLines(HashList.Path, committed.Updated(hashes, Environment.GetEnvironmentVariable("RAYTRACER_REASON")));
            return;
        }

        string[] changed = [.. hashes.Where(h => committed.HashOf(h.Key) != h.Value).Select(h => $"{h.Key}: {h.Value}, committed: {committed.HashOf(h.Key)}")];
        Assert.True(changed.Length == 0, $"""
            The bits of these pictures changed:
            {string.Join('\n', changed)}
            If that is meant, run this test with RAYTRACER_UPDATE=1 RAYTRACER_REASON="why, in one line", and commit hashes.txt with the change.
            """);
        Assert.Equal(hashes.Keys.Order(StringComparer.Ordinal), committed.Scenes);
    }

    // Streams go from one rendering to the next: whatever they hold, nobody may read it.
    [Theory]
    [InlineData(0xFF)]
    [InlineData(0x3F)]
    public unsafe void What_is_left_in_streams_does_not_change_pictures(byte left)
    {
        HashList committed = HashList.Read();
        foreach (string name in BitScenes.All)
        {
            PathStream[] streams = [.. Enumerable.Range(0, 4 * Environment.ProcessorCount).Select(_ => PathStream.Take(new RenderOptions().StreamSize))];
            foreach (PathStream stream in streams)
            {
                // The columns lie behind each other; the last has room for a register more.
                new Span<byte>(stream.OriginX, (int)((byte*)(stream.Passed + stream.Capacity) - (byte*)stream.OriginX)).Fill(left);
                stream.GiveBack();
            }

            Assert.Equal((name, committed.HashOf(name)), (name, new RTracer(BitScenes.Load(name)).Render().Film.ComputeHash()));
        }
    }

    [Fact]
    public void A_hash_does_not_change_without_a_reason()
    {
        HashList list = new(["# Head.", "# 1. Because.", "", "a  1 00", "b  1 11"]);
        Assert.Throws<ArgumentException>(() => list.Updated(new Dictionary<string, string> { ["a"] = "00", ["b"] = "22" }, " "));
        Assert.Equal(
            ["# Head.", "# 1. Because.", "# 2. A fault.", "", $"{"a",-30}   1 00", $"{"b",-30}   2 22"],
            list.Updated(new Dictionary<string, string> { ["b"] = "22", ["a"] = "00" }, "A fault."));
        Assert.Equal(3, list.Updated(new Dictionary<string, string> { ["a"] = "00", ["b"] = "11" }, null).Count(l => l.Length > 0 && !l.StartsWith('b')));
    }
}
