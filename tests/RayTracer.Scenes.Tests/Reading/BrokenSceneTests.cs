using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

public class BrokenSceneTests
{
    private static readonly string Folder = ProjectFolder.PathOf("scenes", "broken");

    public static TheoryData<string> Names => new(
        new[] { "*.json", "*.xml", "*.pbrt" }.SelectMany(p => Directory.GetFiles(Folder, p)).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));

    [Theory]
    [MemberData(nameof(Names))]
    public void Broken_scene_gives_exactly_its_expected_diagnostics(string name)
    {
        SceneLoadResult result = SceneLoader.Load(Path.Combine(Folder, name));

        IEnumerable<Diagnostic> relative = result.Diagnostics.Select(d => d with { File = Path.GetFileName(d.File) });
        RepositoryFolder.AssertHolds(Path.Combine(Folder, Path.ChangeExtension(name, ".expected")), Diagnostic.Format([.. relative]) + "\n");
        Assert.Equal(result.Diagnostics.Any(d => d.Severity == Severity.Error), result.Scene is null);
        Assert.NotEmpty(result.Diagnostics);
    }
}
