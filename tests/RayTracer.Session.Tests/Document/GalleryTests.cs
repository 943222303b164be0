using RayTracer.Imaging;
using RayTracer.Session;
using RayTracer.Textures;

namespace RayTracer.Session.Tests;

/// <summary>The gallery has every shipped scene, with a picture that the program makes.</summary>
public sealed class GalleryTests
{
    [Fact]
    public void Every_shipped_scene_is_in_it_once_with_a_summary()
    {
        using SessionFolder folder = new();
        using Gallery gallery = new(folder.User);
        Assert.Equal(ShippedScenes.Paths, gallery.Groups.SelectMany(g => g.Items).Select(i => i.Id).Order(StringComparer.Ordinal));
        Assert.Equal(["Gallery", "Primer", "The report's scenes", "Meshes and motion"], gallery.Groups.Take(4).Select(g => g.Title));
        GalleryItem sphere = gallery.Groups[1].Items[0];
        Assert.Equal(("primer/01-sphere.json", "Sphere", "A sphere on a plane, under a sky that shines alike from everywhere."), (sphere.Id, sphere.Name, sphere.Summary));
        Assert.Equal(["Scene 1", "Scene 2", "Scene 3"], gallery.Groups[2].Items.Select(i => i.Name));
        Assert.All(gallery.Groups.SelectMany(g => g.Items), i => Assert.False(string.IsNullOrWhiteSpace(i.Summary), i.Id));
    }

    [Fact]
    public async Task Every_shipped_scene_has_a_shipped_picture_of_it_as_it_is_and_no_other_is_shipped()
    {
        using SessionFolder folder = new();
        using Gallery gallery = new(folder.User);
        Dictionary<string, string> wanted = ShippedScenes.Paths.ToDictionary(id => Gallery.ShippedName(id, Path.Combine(ShippedScenes.Folder, id)));
        string shipped = ProjectFolder.PathOf("src", "RayTracer.Session", "Thumbnails");
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            Directory.CreateDirectory(shipped);
            foreach (string old in Directory.GetFiles(shipped).Where(f => !wanted.ContainsKey(Path.GetFileName(f))))
            {
                File.Delete(old);
            }

            foreach ((string name, string id) in wanted.Where(w => !File.Exists(Path.Combine(shipped, w.Key))))
            {
                await File.WriteAllBytesAsync(Path.Combine(shipped, name), gallery.MakeShipped(id));
            }

            // They are a part of the program after the next build.
            return;
        }

        Assert.True(
            wanted.Keys.Order(StringComparer.Ordinal).SequenceEqual(Directory.GetFiles(shipped).Select(f => Path.GetFileName(f)!).Order(StringComparer.Ordinal)),
            "A scene has changed: RAYTRACER_UPDATE=1 renders its picture for the gallery.");
        foreach ((string name, string id) in wanted)
        {
            Assert.Equal(await File.ReadAllBytesAsync(Path.Combine(shipped, name)), await gallery.Thumbnail(id));
        }

        Assert.Empty(Directory.GetFiles(folder.User.Thumbnails));

        // Of one it is seen that it is that scene's, as far as the JPEG format keeps it.
        Picture kept = ImageFile.Decode(await gallery.Thumbnail("primer/01-sphere.json"));
        Picture made = ImageFile.Decode(gallery.MakeShipped("primer/01-sphere.json"));
        Assert.InRange(kept.Pixels.Zip(made.Pixels, (a, b) => Math.Abs(a - b)).Average(), 0, 0.01f);
    }

    [Fact]
    public async Task The_picture_of_a_scene_that_was_changed_is_rendered_once_and_kept()
    {
        using SessionFolder folder = new();
        folder.Write("scenes/primer/01-sphere.json", ShippedScenes.Text("primer/01-sphere.json") + "\n// Mine.\n");
        using Gallery gallery = new(folder.User, folder["scenes"]);
        byte[][] pngs = await Task.WhenAll(Enumerable.Range(0, 3).Select(_ => gallery.Thumbnail("primer/01-sphere.json")));
        Assert.All(pngs, png => Assert.Equal(pngs[0], png));
        Picture picture = ImageFile.Decode(pngs[0]);
        Assert.Equal((240, 180), (picture.Width, picture.Height));
        string kept = Assert.Single(Directory.GetFiles(folder.User.Thumbnails));
        await File.WriteAllBytesAsync(kept, [1, 2, 3]);
        Assert.Equal([1, 2, 3], await gallery.Thumbnail("primer/01-sphere.json"));
    }

    [Theory]
    [InlineData("../README.md")]
    [InlineData("broken/empty.json")]
    [InlineData("raytracer.schema.json")]
    [InlineData("")]
    public async Task What_is_not_in_it_cannot_be_had_through_it(string id)
    {
        using SessionFolder folder = new();
        using Gallery gallery = new(folder.User);
        await Assert.ThrowsAsync<SessionException>(() => gallery.Thumbnail(id));
    }

    [Fact]
    public async Task Without_the_scenes_it_is_empty_and_a_broken_scene_is_reported()
    {
        using SessionFolder folder = new();
        using Gallery none = new(folder.User, folder["nowhere"]);
        Assert.Empty(none.Groups);
        folder.Write("scenes/mine/bad.json", "// Bad.\n{ \"shapes\": 5 }");
        using Gallery broken = new(folder.User, folder["scenes"]);
        Assert.Equal("Mine", broken.Groups.Single().Title);
        await Assert.ThrowsAsync<SessionException>(() => broken.Thumbnail("mine/bad.json"));
    }
}
