using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>A document under edits: what is good stays, what is built is the newest, nothing throws.</summary>
public sealed class SceneDocumentTests
{
    private const string Ball = """{ "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1 }] }""";

    private static DocumentPlace Nowhere => new("scene.json", null, ShippedScenes.Folder);

    [Fact]
    public async Task A_malformed_scene_typed_character_by_character_never_throws_nor_loses_the_last_good_scene()
    {
        string[] texts =
        [
            "{ \"shapes\": [{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": -1 }], // \"\\u12\n /* open",
            "{ \"materials\": { \"a\": \"b\", \"b\": \"a\" }, \"camera\": [[[[", "nul", "\"", "{ \"$schema\": 5, \"lights\": [{ \"type\": \"plane\", \"point\": [0, 0, 0], \"normal\": [0, 0, 0] }] }",
        ];
        using SceneDocument document = new(Ball, Nowhere);
        GoodScene good = (await document.WhenBuilt()).LastGood!;
        document.TryReplace(document.Revision, 0, document.Text.Length, "", "typing");
        foreach (string text in texts)
        {
            foreach (char c in text)
            {
                Assert.True(document.TryReplace(document.Revision, document.Text.Length, document.Text.Length, c.ToString(), "typing"));
                DocumentContent content = await document.WhenBuilt();
                Assert.Equal(document.Text, content.Text);
                Assert.NotNull(content.LastGood);
                Assert.True(content.Load.Scene is not null || content.Load.Diagnostics.Count > 0);
                Assert.All(document.Status.Diagnostics, d => Assert.InRange(d.To, d.From, content.Text.Length));
            }

            document.TryReplace(document.Revision, 0, document.Text.Length, "", "typing");
        }

        Assert.NotEqual(good.Text, (await document.WhenBuilt()).Text);
        document.Undo();
        Assert.Equal(Ball, document.Text);
        Assert.False(document.IsDirty);
        Assert.NotNull((await document.WhenBuilt()).Load.Scene);
    }

    [Theory]
    [MemberData(nameof(Broken))]
    public async Task Broken_scenes_become_diagnostics_beside_the_last_good_scene(string path)
    {
        using SceneDocument document = new(Ball, Nowhere);
        await document.WhenBuilt();
        document.TryReplace(1, 0, document.Text.Length, File.ReadAllText(Path.Combine(ShippedScenes.Folder, path)), null);
        DocumentContent content = await document.WhenBuilt();
        Assert.Equal(Ball, content.LastGood!.Text);
        Assert.False(document.Status.IsGood);
        Assert.NotEmpty(document.Status.Diagnostics);
    }

    [Fact]
    public async Task An_old_revision_is_refused_and_changes_nothing()
    {
        using SceneDocument document = new(Ball, Nowhere);
        Assert.True(document.TryReplace(1, 0, 0, " ", null));
        Assert.False(document.TryReplace(1, 0, 0, "x", null));
        Assert.Equal(" " + Ball, document.Text);
        Assert.Throws<SessionException>(() => document.TryReplace(2, 5, 3, "", null));
        Assert.Throws<SessionException>(() => document.TryReplace(2, 0, 10_000, "", null));
        await document.WhenBuilt();
    }

    [Fact]
    public async Task Pictures_and_models_are_read_once_for_many_edits()
    {
        using SessionFolder folder = new();
        File.Copy(Path.Combine(ShippedScenes.Folder, "report", "globe.png"), folder["globe.png"]);
        folder.Write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const string Text = """
            { "materials": { "m": { "type": "diffuse", "color": { "type": "image", "file": "globe.png" } }, "n": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } },
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": "m" }, { "type": "model", "file": "triangle.obj" }] }
            """;
        using SceneDocument document = new(Text, new("s.json", null, folder.FullName));
        Assert.NotNull((await document.WhenBuilt()).Load.Scene);
        for (int i = 0; i < 10; i++)
        {
            document.Change("color", "drag", text => text.Set("/materials/n/color/0", System.Text.Json.Nodes.JsonValue.Create(i / 10.0)));
            Assert.NotNull((await document.WhenBuilt()).Load.Scene);
        }

        Assert.Equal(2, document.FilesRead);
        File.SetLastWriteTimeUtc(folder["triangle.obj"], DateTime.UtcNow.AddSeconds(5));
        document.Undo();
        await document.WhenBuilt();
        Assert.Equal(3, document.FilesRead);
    }

    [Fact]
    public async Task Opening_another_document_ends_all_that_was_of_the_first()
    {
        using SceneDocument document = new(Ball, Nowhere);
        await document.WhenBuilt();
        document.TryReplace(1, 0, 0, " ", null);
        document.Open("{", Nowhere with { Name = "other.json" }, isSaved: true);
        DocumentContent content = await document.WhenBuilt();
        Assert.Null(content.LastGood);
        Assert.Equal("{", content.Text);
        Assert.Equal((false, false, "other.json"), (document.Status.CanUndo, document.IsDirty, document.Status.Name));
    }

    [Fact]
    public async Task Edits_by_many_threads_are_all_in_the_text_and_all_undone()
    {
        using SceneDocument document = new(Ball, Nowhere);
        await Task.WhenAll(Enumerable.Range(0, 4).Select(thread => Task.Run(() =>
        {
            for (int i = 0; i < 50; i++)
            {
                document.Change("m", null, text => text.Set($"/materials/t{thread}n{i}", new System.Text.Json.Nodes.JsonObject { ["type"] = "diffuse" }));
                _ = document.Status;
            }
        })));
        DocumentContent content = await document.WhenBuilt();
        Assert.Equal(200, content.Load.Description!.Materials.Count);
        while (document.Status.CanUndo)
        {
            document.Undo();
        }

        Assert.Equal(Ball, document.Text);
    }

    [Fact]
    public void Line_ends_are_one_character_and_the_byte_order_mark_is_no_part_of_the_text()
    {
        using SceneDocument document = new("\uFEFF{\r\n}\r", Nowhere);
        Assert.Equal("{\n}\n", document.Text);
        document.TryReplace(1, 1, 1, "\r\n// x\r\n", null);
        Assert.Equal("{\n// x\n\n}\n", document.Text);
    }

    public static TheoryData<string> Broken => [.. Directory.EnumerateFiles(Path.Combine(ShippedScenes.Folder, "broken"), "*.json").Select(p => "broken/" + Path.GetFileName(p))
        .Where(p => SceneReader.ReadText(File.ReadAllText(Path.Combine(ShippedScenes.Folder, p)), p) is { Source: not null, Description: null }).Order(StringComparer.Ordinal)];
}
