using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

public class GeneratedFilesTests
{
    [Fact]
    public void Schema_is_up_to_date() =>
        RepositoryFolder.AssertHolds(ProjectFolder.PathOf("scenes", "raytracer.schema.json"), SceneSchema.Generate());

    [Fact]
    public void Reference_page_is_up_to_date() =>
        RepositoryFolder.AssertHolds(ProjectFolder.PathOf("docs", "scene-format.md"), SceneReference.Generate());

    [Fact]
    public void Every_parameter_is_explained_on_the_reference_page()
    {
        string page = SceneReference.Generate();
        IEnumerable<RecordType> types = SceneTypes.Parts.Concat(SceneTypes.Families.SelectMany(f => f.Types));
        Assert.All(types, t => Assert.Contains($"### {t.Name}\n", page, StringComparison.Ordinal));
        Assert.All(types.SelectMany(t => t.Parameters), p => Assert.Contains($"| `{p.Key}` |", page, StringComparison.Ordinal));
    }
}
