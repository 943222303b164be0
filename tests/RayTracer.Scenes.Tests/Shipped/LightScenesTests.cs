using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

/// <summary>The scenes of lights.</summary>
public class LightScenesTests
{
    public static TheoryData<string> Files => new(Directory.GetFiles(ProjectFolder.PathOf("scenes", "lights"), "*.json").Select(f => Path.GetFileName(f)));

    [Theory]
    [MemberData(nameof(Files))]
    public void Light_scene_loads_without_diagnostics_and_says_what_it_shows(string file)
    {
        string path = ProjectFolder.PathOf("scenes", "lights", file);
        SceneLoadResult result = SceneLoader.Load(path);
        Assert.Empty(result.Diagnostics);
        Assert.NotNull(result.Scene);
        Assert.StartsWith("// ", File.ReadAllText(path), StringComparison.Ordinal);
        Assert.Contains("\"$schema\": \"../raytracer.schema.json\"", File.ReadAllText(path), StringComparison.Ordinal);
    }
}
