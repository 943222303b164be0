using RayTracer.Rendering;

namespace RayTracer.RenderTests.Bits;

/// <summary>
/// A tile of each large picture of the gallery, of few samples, has the film hash that lies beside the pictures: the gallery's commands
/// still give the pictures that it shows. Covers <see cref="RTracer"/> and <see cref="Film"/>.
/// </summary>
[Trait("Category", "Pinned")]
public class GalleryTileTests
{
    private static readonly string s_list = ProjectFolder.PathOf("docs", "pictures", "gallery", "hashes.txt");

    [Fact]
    public void Tiles_of_the_gallerys_pictures_have_the_committed_hashes()
    {
        string[] lines = [.. BitScenes.In("gallery").Select(name => $"{name} {HashOf(name)}")];
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllLines(s_list, lines);
            return;
        }

        Assert.True(File.ReadAllLines(s_list).SequenceEqual(lines), $"""
            The pictures of docs/gallery.md are not what its commands give now:
            {string.Join('\n', lines.Except(File.ReadAllLines(s_list)))}
            If the change has its reason in hashes.txt, run this test with RAYTRACER_UPDATE=1, and render again what looks different.
            """);
    }

    // From the middle of the picture, in its own size.
    private static string HashOf(string name)
    {
        Scene scene = SceneRuns.Load(ProjectFolder.PathOf("scenes", name + ".json"));
        Tile crop = new((scene.Render.Width / 2) - 16, (scene.Render.Height / 2) - 16, 32, 32);
        return new RTracer(scene, new RenderOptions { Crop = crop, Samples = new(0, 2) }).Render().Film.ComputeHash();
    }
}
