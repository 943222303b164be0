using System.IO.Compression;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Bundles hold all that a scene needs, and nothing gets out of the folder that one is unpacked into.</summary>
[Trait("Category", "Thorough")]
public sealed class SceneBundleTests : IDisposable
{
    private readonly SessionFolder _folder = new();

    public static TheoryData<string> Scenes => ShippedScenes.All;

    public void Dispose() => _folder.Dispose();

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_scene_that_is_bundled_and_unpacked_looks_the_same(string path)
    {
        string full = Path.Combine(ShippedScenes.Folder, path);
        using (FileStream zip = File.Create(_folder["a.zip"]))
        {
            Assert.Empty(SceneBundle.Write(zip, JsonText.Of(ShippedScenes.Text(path)), DocumentPlace.Of(full)));
        }

        string unpacked = SceneBundle.Extract(_folder["a.zip"], _folder["out"]);
        Assert.Equal(_folder["out/scene.json"], unpacked);
        Assert.Equal(Hash(full), Hash(unpacked));
    }

    [Fact]
    public async Task Models_come_with_the_files_that_they_name()
    {
        _folder.Write("m/thing.obj", "mtllib my materials.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl red\nf 1/1 2/1 3/1\n");
        _folder.Write("m/my materials.mtl", "newmtl red\nKd 1 0 0\nmap_Kd -s 2 2 maps/globe.png\n");
        Directory.CreateDirectory(_folder["m/maps"]);
        File.Copy(Path.Combine(ShippedScenes.Folder, "report", "globe.png"), _folder["m/maps/globe.png"]);
        _folder.Write("secret.txt", "secret");
        string scene = _folder.Write("s/scene.json", """
            { "materials": { "no": { "type": "diffuse", "color": { "type": "image", "file": "../secret.txt" } } },
              "shapes": [{ "type": "model", "file": "../m/thing.obj" }, { "type": "model", "file": "../m/thing.obj" }] }
            """);
        using MemoryStream zip = new();
        Assert.Equal(["../secret.txt"], SceneBundle.Write(zip, JsonText.Of(await File.ReadAllTextAsync(scene)), DocumentPlace.Of(scene)));
        await File.WriteAllBytesAsync(_folder["b.zip"], zip.ToArray());
        SceneBundle.Extract(_folder["b.zip"], _folder["out"]);
        Assert.Equal(
            ["files/thing/maps/globe.png", "files/thing/my materials.mtl", "files/thing/thing.obj", "scene.json"],
            Directory.GetFiles(_folder["out"], "*", SearchOption.AllDirectories).Select(f => Path.GetRelativePath(_folder["out"], f).Replace('\\', '/')).Order(StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("../evil.json")]
    [InlineData("a/../../evil.json")]
    [InlineData("/evil.json")]
    [InlineData("..\\evil.json")]
    [InlineData("C:\\evil.json")]
    [InlineData("a//evil.json")]
    public void No_path_leaves_the_folder(string name)
    {
        Directory.CreateDirectory(_folder["out"]);
        Zip(("scene.json", "{}"), (name, "evil"));
        Assert.Throws<SessionException>(() => SceneBundle.Extract(_folder["z.zip"], _folder["out"]));
        Assert.Equal([_folder["z.zip"]], Directory.GetFileSystemEntries(_folder.FullName));
    }

    [Fact]
    public void Archives_without_a_scene_damaged_or_doubled_ones_are_refused()
    {
        Zip(("readme.txt", "nothing"));
        Assert.Throws<SessionException>(() => SceneBundle.Extract(_folder["z.zip"], _folder["out"]));
        Zip(("scene.json", "{}"), ("scene.json", "{}"));
        Assert.Throws<SessionException>(() => SceneBundle.Extract(_folder["z.zip"], _folder["out"]));
        Zip(("scene.json", "{}"));
        byte[] bytes = File.ReadAllBytes(_folder["z.zip"]);
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < TestSettings.Scale(200, 5000); i++)
        {
            byte[] damaged = [.. bytes];
            damaged[random.Next(damaged.Length)] = (byte)random.Next(256);
            File.WriteAllBytes(_folder["z.zip"], damaged[..random.Next(damaged.Length + 1)]);
            try
            {
                Assert.True(File.Exists(SceneBundle.Extract(_folder["z.zip"], _folder["out"])));
                Directory.Delete(_folder["out"], recursive: true);
            }
            catch (SessionException)
            {
                Assert.False(Directory.Exists(_folder["out"]));
            }
        }
    }

    [Fact]
    public void A_bundle_opens_as_a_scene_without_a_file_of_its_own()
    {
        using DocumentSession session = new(_folder.User, ShippedScenes.Folder, new FakeTime());
        Zip(("inner/scene.json", "{ \"shapes\": [] }"), ("inner/deeper/other.json", "{}"), ("a.obj", "v 0 0 0"));
        session.Files.Open(_folder["z.zip"]);
        Assert.Equal("{ \"shapes\": [] }", session.Document.Text);
        Assert.Null(session.Document.Place.Path);
    }

    private static string Hash(string path)
    {
        SceneLoadResult load = SceneLoader.Load(path, s => s with { Render = s.Render with { Width = 24, Height = 18, SamplesPerPixel = 1 } });
        Assert.True(load.Scene is not null, Diagnostic.Format(load.Diagnostics));
        return new RTracer(load.Scene, new RenderOptions { Threads = 1 }).Render().Film.ComputeHash();
    }

    private void Zip(params (string Name, string Content)[] entries)
    {
        using FileStream file = File.Create(_folder["z.zip"]);
        using ZipArchive zip = new(file, ZipArchiveMode.Create);
        foreach ((string name, string content) in entries)
        {
            using StreamWriter writer = new(zip.CreateEntry(name).Open());
            writer.Write(content);
        }
    }
}
