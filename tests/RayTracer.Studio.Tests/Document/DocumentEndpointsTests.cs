using System.IO.Compression;
using System.Net;
using System.Text;
using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Scenes;
using RayTracer.Session;
using RayTracer.Session.Tests;

namespace RayTracer.Studio.Tests.Document;

/// <summary>The document over HTTP: what a page may ask, and the answer where it may not.</summary>
public sealed class DocumentEndpointsTests : IAsyncLifetime
{
    private readonly SessionFolder _folder = new();
    private StudioSession _session = null!;
    private StudioServer _server = null!;
    private HttpClient _client = null!;

    public async Task InitializeAsync()
    {
        _session = new(_folder.User, ShippedScenes.Folder);
        _server = await StudioServer.Start(_session);
        _client = new() { BaseAddress = _server.Address };
        _client.DefaultRequestHeaders.Add("X-Studio-Token", _server.Token);
    }

    public async Task DisposeAsync()
    {
        _client.Dispose();
        await _server.DisposeAsync();
        _session.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public async Task A_scene_is_edited_undone_and_saved()
    {
        await Post("/api/file/open", """{ "galleryId": "primer/02-light.json" }""");
        JsonElement document = await Get("/api/document");
        int revision = document.GetProperty("revision").GetInt32();
        string text = document.GetProperty("text").GetString()!;
        Assert.Equal(ShippedScenes.Text("primer/02-light.json"), text);
        await Post("/api/document/set", """{ "pointer": "/shapes/0/radius", "value": 0.9, "gesture": "g" }""");
        await Post("/api/document/set", """{ "pointer": "/shapes/0/radius", "value": 0.95, "gesture": "g" }""");
        await Post("/api/document/set", """{ "pointer": "/camera/lens", "json": "{ /* thin */ \"apertureRadius\": 0.1 }" }""");
        Assert.Contains("\"lens\": { /* thin */ \"apertureRadius\": 0.1 }", _session.Document.Text, StringComparison.Ordinal);
        await Post("/api/document/set", """{ "pointer": "/camera/lens", "value": null, "reset": true }""");
        Assert.Equal(text.Replace("\"radius\": 0.7,", "\"radius\": 0.95,", StringComparison.Ordinal), _session.Document.Text);
        string copy = (await Post("/api/document/duplicate", """{ "pointers": ["/shapes/1"] }""")).GetProperty("pointers")[0].GetString()!;
        await Post("/api/document/place", $$"""{ "pointer": "{{copy}}", "translate": [0, 1, 0], "rotate": { "axis": [0, 1, 0], "degrees": 90 }, "scale": [2, 2, 2], "gesture": "h" }""");
        Assert.Equal("1", (await Get($"/api/value?pointer={copy}")).GetProperty("effective").GetProperty("radius").GetRawText());
        await Post("/api/select", $$"""{ "pointer": "{{copy}}" }""");
        Assert.Equal(copy, _session.Selection.Pointer);
        await Post("/api/select", """{ "pointer": "/shapes/0", "adds": true }""");
        Assert.Equal([copy, "/shapes/0"], _session.Selection.All);
        await Post("/api/select", """{ "pointers": [] }""");
        Assert.Null(_session.Selection.Pointer);
        await Post("/api/document/rename", """{ "pointer": "/materials/clay", "name": "mud" }""");
        JsonElement deleted = await Post("/api/document/delete", """{ "pointers": ["/materials/mud"] }""");
        Assert.Contains("3 references", deleted.GetProperty("notes")[0].GetString(), StringComparison.Ordinal);
        string added = (await Post("/api/document/add", """{ "family": "light", "type": "disk" }""")).GetProperty("pointer").GetString()!;
        Assert.Equal("/lights/1", added);
        Assert.Equal(5, (await Get("/api/outline")).GetProperty("shapes").GetArrayLength());
        for (int i = 0; i < 9; i++)
        {
            await Post("/api/document/undo", "");
        }

        Assert.Equal(text, _session.Document.Text);
        await Post("/api/document/redo", "");
        Assert.Contains("\"radius\": 0.95,", _session.Document.Text, StringComparison.Ordinal);
        await Post("/api/file/save", JsonSerializer.Serialize(new { path = _folder["mine.json"] }));
        Assert.Equal("mine.json", (await Get("/api/file/recent")).GetProperty("files")[0].GetProperty("name").GetString());
        Assert.True(_session.Document.Revision > revision);
        Assert.NotNull(SceneLoader.Load(_folder["mine.json"]).Scene);
    }

    [Fact]
    public async Task An_editor_that_is_behind_gets_the_newest_text()
    {
        await Post("/api/document/text", """{ "baseRevision": 1, "from": 0, "to": 0, "insert": "// a\n", "gesture": "t" }""");
        (HttpStatusCode status, string body) = await Send("/api/document/text", """{ "baseRevision": 1, "from": 0, "to": 0, "insert": "// b\n" }""");
        Assert.Equal(HttpStatusCode.Conflict, status);
        JsonElement answer = JsonDocument.Parse(body).RootElement;
        Assert.Equal((2, _session.Document.Text), (answer.GetProperty("revision").GetInt32(), answer.GetProperty("text").GetString()));
    }

    [Fact]
    public async Task Requests_that_make_no_sense_are_answered_with_a_sentence_and_change_nothing()
    {
        (string Path, string Body)[] requests =
        [
            ("/api/document/set", "{}"),
            ("/api/document/set", "null"),
            ("/api/document/set", "not json"),
            ("/api/document/set", """{ "pointer": "/camera" }"""),
            ("/api/document/set", """{ "pointer": "camera", "value": 1 }"""),
            ("/api/document/set", """{ "pointer": "/shapes/99", "value": 1 }"""),
            ("/api/document/set", """{ "pointer": "/camera", "json": "{ open" }"""),
            ("/api/document/text", """{ "baseRevision": 1, "from": -5, "to": 0, "insert": "" }"""),
            ("/api/document/text", """{ "baseRevision": "x" }"""),
            ("/api/document/add", """{ "family": "shape", "type": "teapot" }"""),
            ("/api/document/add", """{ "family": "shape", "type": "sphere", "at": [1] }"""),
            ("/api/document/add", """{ "family": "shape", "type": "sphere", "at": ["x", null] }"""),
            ("/api/document/apply", "{}"),
            ("/api/document/apply", """{ "pointer": "/materials/none", "things": ["/shapes/0"] }"""),
            ("/api/document/apply", """{ "pointer": "materials", "things": ["/shapes/0"] }"""),
            ("/api/document/apply", """{ "pointer": "/materials/red", "things": [] }"""),
            ("/api/document/apply", """{ "pointer": "/materials/red", "things": [null] }"""),
            ("/api/document/apply", """{ "pointer": "/materials/red", "things": ["/shapes/99", ""] }"""),
            ("/api/document/duplicate", """{ "pointer": "/camera" }"""),
            ("/api/document/delete", """{ "pointers": [""] }"""),
            ("/api/document/rename", """{ "pointer": "/shapes/0" }"""),
            ("/api/document/place", """{ "pointer": "/shapes/0", "translate": [1, 2] }"""),
            ("/api/document/place", """{ "pointer": "/shapes/0", "rotate": { "degrees": 5 } }"""),
            ("/api/select", """{ "pointer": "/nothing" }"""),
            ("/api/file/open", "{}"),
            ("/api/file/open", """{ "path": "a.json" }"""),
            ("/api/file/open", """{ "galleryId": "../README.md" }"""),
            ("/api/file/save", """{ "path": "/nowhere/a.json" }"""),
            ("/api/file/save", "{}"),
            ("/api/recovery/discard", """{ "id": "../../x" }"""),
            ("/api/file/upload", "x"),
            ("/api/file/upload?name=..", "x"),
        ];
        string text = _session.Document.Text;
        foreach ((string path, string body) in requests)
        {
            (HttpStatusCode status, string answer) = await Send(path, body);
            Assert.True(status == HttpStatusCode.BadRequest, $"{path} {body}: {status} {answer}");
            Assert.False(string.IsNullOrWhiteSpace(JsonDocument.Parse(answer).RootElement.GetProperty("error").GetString()));
            Assert.Equal(text, _session.Document.Text);
        }
    }

    [Fact]
    public async Task Unsaved_changes_and_other_files_are_asked_about()
    {
        _folder.Write("other.json", "{}");
        await Post("/api/document/set", """{ "pointer": "/render/width", "value": 100 }""");
        foreach ((string path, string body, string flag) in new[]
        {
            ("/api/file/new", "{}", "unsaved"),
            ("/api/file/open", """{ "galleryId": "minimal.json" }""", "unsaved"),
            ("/api/file/upload?name=a.json", "{}", "unsaved"),
            ("/api/file/save", JsonSerializer.Serialize(new { path = _folder["other.json"] }), "exists"),
        })
        {
            (HttpStatusCode status, string answer) = await Send(path, body);
            Assert.Equal(HttpStatusCode.Conflict, status);
            Assert.True(JsonDocument.Parse(answer).RootElement.GetProperty(flag).GetBoolean(), path);
        }

        await Post("/api/file/upload?name=a.json&discard=true", "{ }");
        Assert.Equal("{ }", _session.Document.Text);
        await Post("/api/file/new", """{ "discard": true }""");
    }

    [Fact]
    public async Task Gallery_schema_listing_and_bundle_are_served()
    {
        Assert.Equal(ShippedScenes.Paths.Count(), (await Get("/api/gallery")).GetProperty("groups").EnumerateArray().Sum(g => g.GetProperty("items").GetArrayLength()));
        HttpResponseMessage picture = await _client.GetAsync(new Uri("/api/gallery/thumbnail?id=primer/01-sphere.json", UriKind.Relative));
        Assert.Equal("image/jpeg", picture.Content.Headers.ContentType!.MediaType);
        Assert.Equal(240, ImageFile.Decode(await picture.Content.ReadAsByteArrayAsync()).Width);
        JsonElement schema = await Get("/api/schema");
        JsonElement radius = schema.GetProperty("types").GetProperty("shape").EnumerateArray().Single(t => t.GetProperty("name").GetString() == "sphere")
            .GetProperty("parameters").EnumerateArray().Single(p => p.GetProperty("key").GetString() == "radius");
        Assert.Equal(("number", 0, true, "1"), (radius.GetProperty("kind").GetString(), radius.GetProperty("minimum").GetInt32(), radius.GetProperty("minimumIsExclusive").GetBoolean(), radius.GetProperty("default").GetRawText()));
        Assert.Equal(JsonValueKind.Null, radius.GetProperty("maximum").ValueKind);
        Assert.Equal(_folder.FullName, (await Get("/api/file/list")).GetProperty("path").GetString());
        using HttpResponseMessage small = await _client.GetAsync(new Uri($"/api/file/thumbnail?path={Uri.EscapeDataString(ProjectFolder.PathOf("docs", "studio", "start.png"))}", UriKind.Relative));
        Assert.Equal("image/png", small.Content.Headers.ContentType!.MediaType);
        await Post("/api/file/open", """{ "galleryId": "report/scene1.json" }""");
        using ZipArchive zip = new(new MemoryStream(await _client.GetByteArrayAsync("/api/file/bundle")));
        Assert.Equal(["files/globe.png", "scene.json"], zip.Entries.Select(e => e.FullName).Order(StringComparer.Ordinal));
    }

    private async Task<JsonElement> Get(string path) => JsonDocument.Parse(await _client.GetStringAsync(path)).RootElement;

    private async Task<JsonElement> Post(string path, string body)
    {
        (HttpStatusCode status, string answer) = await Send(path, body);
        Assert.True(status == HttpStatusCode.OK, $"{path} {body}: {status} {answer}");
        JsonElement json = JsonDocument.Parse(answer).RootElement;
        Assert.Equal(_session.Document.Revision, json.GetProperty("revision").GetInt32());
        return json;
    }

    private async Task<(HttpStatusCode Status, string Body)> Send(string path, string body)
    {
        using StringContent content = new(body, Encoding.UTF8, "application/json");
        using HttpResponseMessage answer = await _client.PostAsync(path, content);
        return (answer.StatusCode, await answer.Content.ReadAsStringAsync());
    }
}
