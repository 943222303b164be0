using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.RenderTests.Bits;

/// <summary>
/// A part of each large picture of the gallery, of few samples, has the film hash that lies beside the pictures: the gallery's commands
/// still give the pictures that it shows. Covers <see cref="RTracer"/> and <see cref="Film"/>.
/// </summary>
[Trait("Category", "Pinned")]
public class GalleryTileTests
{
    private static readonly string s_list = ProjectFolder.PathOf("docs", "pictures", "gallery", "hashes.txt");

    // From the middle of each picture, in its size.
    [Fact]
    public void Tiles_of_the_gallerys_pictures_have_the_committed_hashes() =>
        AssertHashes("tile", render => new((render.Width / 2) - 16, (render.Height / 2) - 16, 32, 32));

    // From side to side, through what stands in front.
    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public void Strips_of_the_gallerys_pictures_have_the_committed_hashes() =>
        AssertHashes("strip", render => new(0, render.Height * 2 / 3, render.Width, 32));

    private static void AssertHashes(string kind, Func<RenderDescription, Tile> part)
    {
        string[] lines = [.. BitScenes.In("gallery").Select(name => $"{kind} {name} {HashOf(name, part)}")];
        string[] known = File.ReadAllLines(s_list);
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllLines(s_list, known.Where(l => !l.StartsWith(kind, StringComparison.Ordinal)).Concat(lines).Order(StringComparer.Ordinal));
            return;
        }

        Assert.True(known.Where(l => l.StartsWith(kind, StringComparison.Ordinal)).SequenceEqual(lines), $"""
            The pictures of docs/gallery.md are not what its commands give now:
            {string.Join('\n', lines.Except(known))}
            If the change has its reason in hashes.txt, run this test with RAYTRACER_UPDATE=1, and render again what looks different.
            """);
    }

    private static string HashOf(string name, Func<RenderDescription, Tile> part)
    {
        Scene scene = SceneRuns.Load(ProjectFolder.PathOf("scenes", name + ".json"));
        return new RTracer(scene, new RenderOptions { Crop = part(scene.Render), Samples = new(0, 2) }).Render().Film.ComputeHash();
    }
}
