using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

/// <summary>The scenes that show cameras, filters, caustics, media and textures.</summary>
public class FeatureScenesTests
{
    public static TheoryData<string> Files => new(new[] { "cameras", "caustics", "media", "textures" }.SelectMany(folder =>
        Directory.GetFiles(ProjectFolder.PathOf("scenes", folder), "*.json").Select(file => $"{folder}/{Path.GetFileName(file)}")));

    [Theory]
    [MemberData(nameof(Files))]
    public void Scene_loads_without_diagnostics_and_says_what_it_shows(string file)
    {
        string path = ProjectFolder.PathOf(["scenes", .. file.Split('/')]);
        SceneLoadResult result = SceneLoader.Load(path);
        Assert.Empty(result.Diagnostics);
        Assert.NotNull(result.Scene);
        Assert.StartsWith("// ", File.ReadAllText(path), StringComparison.Ordinal);
        Assert.Contains("\"$schema\": \"../raytracer.schema.json\"", File.ReadAllText(path), StringComparison.Ordinal);
    }
}
