using System.Text.Json;
using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

public class SceneSchemaTests
{
    private static readonly JsonDocumentOptions WithComments = new() { CommentHandling = JsonCommentHandling.Skip, AllowTrailingCommas = true };
    private static readonly SchemaValidator Schema = new(JsonDocument.Parse(SceneSchema.Generate()).RootElement);

    [Fact]
    public void The_reference_pages_example_is_accepted() => Assert.True(Accepts(SceneReference.Example));

    [Fact]
    public void Every_shipped_scene_is_accepted() => Assert.All(
        Directory.EnumerateFiles(ProjectFolder.PathOf("scenes"), "*.json", SearchOption.AllDirectories)
            .Where(f => Path.GetFileName(Path.GetDirectoryName(f)) != "broken" && !f.EndsWith(".schema.json", StringComparison.Ordinal)),
        f => Assert.True(Accepts(File.ReadAllText(f)), f));

    [Theory]
    [InlineData("bad-color")]
    [InlineData("background-out-of-range")]
    [InlineData("empty-path")]
    [InlineData("missing-required")]
    [InlineData("missing-type")]
    [InlineData("misspelt-key")]
    [InlineData("misspelt-section")]
    [InlineData("not-an-object")]
    [InlineData("radius-out-of-range")]
    [InlineData("render-out-of-range")]
    [InlineData("size-out-of-range")]
    [InlineData("type-of-another-family")]
    [InlineData("unknown-choice")]
    [InlineData("unknown-type")]
    [InlineData("vector-length")]
    [InlineData("wrong-boolean")]
    [InlineData("wrong-type")]
    [InlineData("wrong-type-of-section")]
    public void A_scene_that_is_broken_in_its_form_is_refused(string name) =>
        Assert.False(Accepts(File.ReadAllText(ProjectFolder.PathOf("scenes", "broken", name + ".json"))));

    private static bool Accepts(string text) => Schema.Accepts(JsonDocument.Parse(text, WithComments).RootElement);
}
