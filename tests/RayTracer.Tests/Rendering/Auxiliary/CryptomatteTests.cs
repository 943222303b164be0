using System.Text;
using RayTracer.Rendering;
using RayTracer.Testing;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `CryptomatteImage`, `MatteCounts`, `MatteNames`.</summary>
public class CryptomatteTests
{
    private static readonly CryptomatteImage s_objects = new(CryptomatteKind.Object);
    private static readonly CryptomatteImage s_materials = new(CryptomatteKind.Material);

    // Values of the reference implementation, and of lengths with one to three letters over a multiple of four.
    [Theory]
    [InlineData("", 0u)]
    [InlineData("hello", 0x248BFA47u)]
    [InlineData("hello, world", 0x149BBB7Fu)]
    [InlineData("The quick brown fox jumps over the lazy dog.", 0xD5C48BFCu)]
    [InlineData("abc", 0xB3DD93FAu)]
    [InlineData("ab", 0x9BBFD75Fu)]
    public void Names_are_hashed_by_MurmurHash3(string name, uint hash) => Assert.Equal(hash, MatteNames.MurmurHash(Encoding.UTF8.GetBytes(name)));

    [Fact]
    public void Numbers_of_names_are_bits_of_ordinary_floats()
    {
        for (int i = 0; i < 20_000; i++)
        {
            uint id = MatteNames.IdOf($"thing {i}");
            Assert.True(float.IsNormal(BitConverter.UInt32BitsToSingle(id)));
            uint hash = MatteNames.MurmurHash(Encoding.UTF8.GetBytes($"thing {i}"));
            Assert.True(id == hash || (id ^ hash) == 1u << 23);
        }
    }

    // A board over the left three eighths of the picture, and its halves of two materials.
    [Fact]
    public void Coverage_is_a_part_of_the_samples()
    {
        Scene scene = Build("""
            { "name": "board", "type": "group", "shapes": [
              { "type": "rectangle", "name": "left half", "corner": [-2, -2, 0], "edgeU": [1, 0, 0], "edgeV": [0, 4, 0], "material": "red" },
              { "type": "rectangle", "corner": [-1, -2, 0], "edgeU": [0.5, 0, 0], "edgeV": [0, 4, 0], "material": { "type": "diffuse" } }
            ] }
            """);
        AovFilm film = Render(scene);
        Assert.Equal([("left half", 1)], Of(film, s_objects, 0, 1));
        Assert.Equal([("board", 0.5)], Of(film, s_objects, 1, 1));
        Assert.Equal([("red", 1)], Of(film, s_materials, 0, 2));
        Assert.Equal([("diffuse 1", 0.5)], Of(film, s_materials, 1, 2));
        Assert.Empty(Of(film, s_objects, 2, 0));
        double[] row = new double[3 * film.Width];
        film.ReadRow(s_objects, 0, row);
        Assert.Equal(0, row[6]);
        Assert.True(row[0] + row[1] + row[2] > 0.3);
    }

    [Fact]
    public void What_an_instance_shows_has_its_name_or_else_its_own_or_that_of_the_object()
    {
        Scene scene = Build("""
            { "type": "instance", "of": "tree", "name": "oak", "transform": [{ "translate": [-1.5, 0, 0] }] },
            { "type": "instance", "of": "tree", "transform": [{ "translate": [-0.5, 0, 0] }] },
            { "type": "instance", "of": "bush", "transform": [{ "translate": [0.5, 0, 0] }] },
            { "type": "sphere", "center": [1.5, 0, 0], "radius": 0.4, "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [0, 1, 0] }] }] }
            """, """ "objects": { "tree": { "type": "sphere", "name": "crown", "center": [0, 0, 0], "radius": 0.4 }, "bush": { "type": "sphere", "center": [0, 0, 0], "radius": 0.4 } }, """);
        AovFilm film = Render(scene);
        string[] names = [.. Enumerable.Range(0, 4).Select(x => Of(film, s_objects, x, 1).Concat(Of(film, s_objects, x, 2)).First().Name)];
        Assert.Equal(["oak", "crown", "bush", "sphere 1"], names);
    }

    [Fact]
    public void Threads_tiles_and_the_order_of_samples_change_nothing()
    {
        Scene scene = TestScenes.BuildEverything();
        AovFilm one = Empty(scene);
        AovFilm other = Empty(scene);
        new FirstHitPass(scene, new() { Threads = 1 }).Render(one);
        foreach (SampleRange part in new SampleRange[] { new(10, 16), new(0, 3), new(3, 10) })
        {
            new FirstHitPass(scene, new() { Threads = 3, TileSize = 7, Samples = part }).Render(other);
        }

        Assert.Equal(one.Content(), other.Content());
        for (int i = 0; i < one.Width * one.Height; i++)
        {
            Assert.Equal(one.Covering(s_objects, i % one.Width, i / one.Width), other.Covering(s_objects, i % one.Width, i / one.Width));
        }

        Assert.True(one.Shown(s_objects).Count() > 3);
    }

    private static (string Name, double Part)[] Of(AovFilm film, CryptomatteImage image, int x, int y) => [.. film.Covering(image, x, y).Select(c => (film.Names!.NameOf(c.Id), c.Part))];

    private static AovFilm Empty(Scene scene) => new(new(scene.Render.Width, scene.Render.Height), [s_objects, s_materials]);

    private static AovFilm Render(Scene scene)
    {
        AovFilm film = Empty(scene);
        new FirstHitPass(scene).Render(film);
        return film;
    }

    private static Scene Build(string shapes, string more = "") => TestScenes.Build($$"""
        { {{more}} "render": { "width": 4, "height": 4, "samplesPerPixel": 64, "sampler": "regular" },
          "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "projection": "orthographic", "viewSize": 4 },
          "materials": { "red": { "type": "diffuse", "color": [1, 0, 0] } }, "shapes": [ {{shapes}} ] }
        """);
}
