using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

/// <summary>The scenes that show the materials.</summary>
public class MaterialScenesTests
{
    private static readonly string s_folder = ProjectFolder.PathOf("scenes", "materials");

    public static TheoryData<string> Files => new(Directory.GetFiles(s_folder, "*.json").Select(Path.GetFileName).Order(StringComparer.Ordinal)!);

    [Theory]
    [MemberData(nameof(Files))]
    public void A_material_scene_is_explained_and_loads_without_diagnostics(string file)
    {
        string path = Path.Combine(s_folder, file);
        Assert.StartsWith("// ", File.ReadAllText(path), StringComparison.Ordinal);
        SceneLoadResult result = SceneLoader.Load(path);
        Assert.Empty(result.Diagnostics);
        Assert.NotNull(result.Scene);
    }

    [Fact]
    public void Every_material_is_in_a_shipped_scene()
    {
        IEnumerable<string> folders = Directory.GetDirectories(ProjectFolder.PathOf("scenes")).Where(f => Path.GetFileName(f) != "broken");
        string all = string.Concat(folders.SelectMany(f => Directory.GetFiles(f, "*.json")).Select(File.ReadAllText));
        Assert.All(SceneTypes.Materials.Types, t => Assert.Contains($"\"type\": \"{t.Name}\"", all, StringComparison.Ordinal));
    }
}
