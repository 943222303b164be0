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
        Assert.All(gallery.Groups.SelectMany(g => g.Items), i => Assert.False(string.IsNullOrWhiteSpace(i.Summary), i.Id));
    }

    [Fact]
    public async Task A_thumbnail_is_rendered_once_and_kept()
    {
        using SessionFolder folder = new();
        using Gallery gallery = new(folder.User);
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
