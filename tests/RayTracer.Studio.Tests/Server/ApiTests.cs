using System.Buffers.Binary;
using System.Text.Json;
using RayTracer.Session;

namespace RayTracer.Studio.Tests.Server;

public sealed class ApiTests
{
    private const string Scene2 = "report/scene2.json";

    [Fact]
    public async Task The_state_is_sent_at_once_and_then_when_it_changes()
    {
        await using TestServer server = await TestServer.Start();
        await server.Test.OpenShipped(Scene2, 32, 4);
        await server.Test.Done();
        JsonElement state = await server.Get("/api/state");
        long version = state.GetProperty("version").GetInt64();
        Assert.Equal("test.json", state.GetProperty("document").GetProperty("name").GetString());
        Assert.Equal(("done", 4, 32), (state.GetProperty("render").GetProperty("status").GetString(), state.GetProperty("render").GetProperty("samples").GetInt32(), state.GetProperty("render").GetProperty("width").GetInt32()));
        Assert.Equal("light", state.GetProperty("render").GetProperty("map").GetString());
        Assert.Equal(["clamp", "soft", "reinhard", "aces", "agx"], state.GetProperty("tone").GetProperty("choices").EnumerateArray().Select(c => c.GetString()));
        Task<JsonElement> waiting = server.Get($"/api/state?after={version + 1}");
        await server.Post("/api/view/tone", new { exposure = 1.5, toneMap = "aces" });
        await server.Post("/api/view/tone", new { exposure = 1.25 });
        JsonElement tone = (await waiting).GetProperty("tone");
        Assert.Equal("aces", tone.GetProperty("toneMap").GetString());
    }

    [Fact]
    public async Task A_state_without_news_is_sent_after_a_while()
    {
        await using TestServer server = await TestServer.Start(new() { Patience = TimeSpan.FromMilliseconds(50) });
        JsonElement state = await server.Get("/api/state?after=1000000");
        Assert.True(state.GetProperty("version").GetInt64() < 1000000);
        using HttpResponseMessage frame = await server.Send(HttpMethod.Get, "/api/frame?after=1000000");
        Assert.Equal(System.Net.HttpStatusCode.NoContent, frame.StatusCode);
    }

    [Fact]
    public async Task Frames_have_a_header_and_the_bytes_of_the_picture()
    {
        await using TestServer server = await TestServer.Start();
        await server.Test.OpenShipped(Scene2, 48, 4);
        uint[] header;
        byte[] bytes;
        long version = 0;
        do
        {
            using HttpResponseMessage response = await server.Send(HttpMethod.Get, $"/api/frame?after={version}&width=48&height=48");
            bytes = await response.Content.ReadAsByteArrayAsync();
            header = [.. Enumerable.Range(0, 8).Select(i => BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(4 * i)))];
            version = header[1];
        }
        while ((header[6] & 2) == 0);

        Assert.Equal("RTF1", System.Text.Encoding.ASCII.GetString(bytes, 0, 4));
        using FrameLease frame = server.Test.Session.View.Frames.Borrow()!;
        Assert.Equal(server.Test.Session.Document.Status.Document, frame.Document);
        Assert.Equal([48u, 48u, 48u, 48u, ((uint)frame.Document << 8) | 2u, 4u], header[2..]);
        byte[] expected = new byte[4 * 48 * 48];
        FramePixels.Write(frame.Picture, Tone.Plain, 1, expected);
        Assert.Equal(expected, bytes[32..]);
    }

    [Fact]
    public async Task The_view_is_looked_into_by_requests()
    {
        await using TestServer server = await TestServer.Start();
        await server.Test.OpenShipped(Scene2, 60, 9);
        await server.Test.Done();
        JsonElement pick = await server.Get("/api/pick?x=30&y=30");
        string pointer = pick.GetProperty("pointer").GetString()!;
        Assert.StartsWith("/shapes/", pointer, StringComparison.Ordinal);
        Assert.Equal(3, pick.GetProperty("position").GetArrayLength());
        JsonElement mask = await server.Get($"/api/view/mask?pointer={pointer}");
        Assert.Equal(60, mask.GetProperty("width").GetInt32());
        Assert.NotEqual(0, mask.GetProperty("runs").GetArrayLength());
        JsonElement gizmo = await server.Post("/api/view/gizmo", new { pointer, kind = "rotate", length = 12 });
        Assert.Equal("rotate", gizmo.GetProperty("kind").GetString());
        Assert.Equal(2, gizmo.GetProperty("center").GetArrayLength());
        Assert.Equal(3, gizmo.GetProperty("handles").GetArrayLength());
        JsonElement paths = await server.Get("/api/paths?x=30&y=30&first=2&count=3");
        Assert.Equal([2, 3, 4], paths.GetProperty("samples").EnumerateArray().Select(s => s.GetProperty("sample").GetInt32()));
        Assert.Equal(9 + 4, (await server.Get("/api/wireframe")).GetProperty("shapes").GetArrayLength());
        Assert.Equal(4, (await server.Get("/api/convergence")).GetProperty("points").GetArrayLength());
        Assert.Equal("raytracer render test.json -o test.png", (await server.Get("/api/command")).GetProperty("text").GetString());
    }

    [Fact]
    public async Task The_view_is_changed_by_requests()
    {
        await using TestServer server = await TestServer.Start();
        await server.Test.OpenShipped(Scene2, 60, 4);
        int revision = (await server.Post("/api/view/camera", new { kind = "orbit", dx = 0.1, dy = 0, gesture = "g" })).GetProperty("revision").GetInt32();
        await server.Post("/api/view/camera", new { kind = "orbit", dx = 0.1, dy = 0, gesture = "g", around = new[] { 3, 4 }, end = true });
        await server.Post("/api/view/bookmark/add", new { name = "here" });
        JsonElement seen = (await server.Get("/api/state")).GetProperty("view");
        Assert.False(seen.GetProperty("isSceneCamera").GetBoolean());
        int bookmark = seen.GetProperty("bookmarks")[0].GetProperty("id").GetInt32();
        await server.Post("/api/view/bookmark/show", new { id = bookmark });
        await server.Post("/api/view/bookmark/remove", new { id = bookmark });
        Assert.True((await server.Post("/api/view/camera/write", new { })).GetProperty("revision").GetInt32() > revision);
        await server.Post("/api/view/focus", new { x = 30, y = 30 });
        await server.Post("/api/view/render", new { action = "pause", quality = "draft", threads = 2, region = new[] { 1, 2, 3, 4 }, map = "bvhCost" });
        JsonElement render = (await server.Get("/api/state")).GetProperty("render");
        Assert.Equal(("draft", 2, "bvhCost", 4), (render.GetProperty("quality").GetString(), render.GetProperty("threads").GetInt32(), render.GetProperty("map").GetString(), render.GetProperty("region").GetArrayLength()));
        await server.Post("/api/view/render", new { region = Array.Empty<int>() });
        Assert.Equal(JsonValueKind.Null, (await server.Get("/api/state")).GetProperty("render").GetProperty("region").ValueKind);
        int id = (await server.Post("/api/view/snapshot", new { })).GetProperty("id").GetInt32();
        using HttpResponseMessage png = await server.Send(HttpMethod.Get, $"/api/view/snapshot?id={id}");
        Assert.Equal("image/png", png.Content.Headers.ContentType!.MediaType);
        Assert.Equal(0, (await server.Get($"/api/view/compare?image={id}&reference={id}")).GetProperty("flip").GetDouble());
        using HttpResponseMessage map = await server.Send(HttpMethod.Get, $"/api/view/compare/picture?image={id}&reference={id}&map=flip");
        Assert.Equal("image/png", map.Content.Headers.ContentType!.MediaType);
        await server.Post("/api/view/snapshot/rename", new { id, name = "kept" });
        Assert.Equal("kept", (await server.Get("/api/state")).GetProperty("snapshots")[0].GetProperty("name").GetString());
    }

    [Fact]
    public async Task Pictures_are_saved_and_downloaded()
    {
        await using TestServer server = await TestServer.Start();
        await server.Test.OpenShipped(Scene2, 20, 1);
        await server.Test.Done();
        string path = Path.Combine(server.Test.Folder, "a.png");
        await server.Post("/api/save/picture", new { path, bitDepth = 16 });
        await server.Test.Until(() => server.Test.Session.Notices.Newest);
        JsonElement refused = await server.Post("/api/save/picture", new { path }, 409);
        Assert.True(refused.GetProperty("exists").GetBoolean());
        using HttpResponseMessage exr = await server.Send(HttpMethod.Get, "/api/picture?format=exr&layers=depth,normal");
        Assert.Equal([0x76, 0x2f, 0x31, 0x01], (await exr.Content.ReadAsByteArrayAsync())[..4]);
    }

    [Theory]
    [InlineData("/api/view/camera", """{ "kind": "somersault" }""")]
    [InlineData("/api/view/camera", """{ "kind": """)]
    [InlineData("/api/view/render", """{ "action": "explode" }""")]
    [InlineData("/api/view/render", """{ "threads": 0 }""")]
    [InlineData("/api/view/render", """{ "region": [0, 0, 0, 0] }""")]
    [InlineData("/api/view/tone", """{ "exposure": 1000 }""")]
    [InlineData("/api/view/drag", """{ "pointer": "/shapes/6", "kind": "move", "axis": 3, "from": [0, 0], "to": [1, 1], "gesture": "g" }""")]
    [InlineData("/api/view/hide", """{ }""")]
    [InlineData("/api/view/hide", """{ "pointers": ["/camera"], "isMarked": true }""")]
    [InlineData("/api/view/hide", """{ "pointers": [null], "isMarked": true }""")]
    [InlineData("/api/view/lock", """{ "pointers": ["/shapes/99", "shapes"], "isMarked": true }""")]
    [InlineData("/api/view/lock", """{ "pointers": "/shapes/0", "isMarked": true }""")]
    [InlineData("/api/view/gizmo", """{ "kind": "move", "length": 10 }""")]
    [InlineData("/api/view/drag", """{ "pointer": null, "kind": "move", "axis": 0, "from": [0, 0], "to": [1, 1], "gesture": "g" }""")]
    [InlineData("/api/view/light/drag", """{ "kind": "cone", "to": [1, 1], "gesture": "g" }""")]
    [InlineData("/api/select", """{ "pointers": ["/shapes/0", null] }""")]
    [InlineData("/api/document/apply", """{ "pointer": "/materials/floor", "things": [null] }""")]
    [InlineData("/api/timeline/move", """{ "keys": [null] }""")]
    [InlineData("/api/timeline/record", """{ "isOn": 1 }""")]
    [InlineData("/api/save/picture", """{ "path": "a.jpg", "transparent": true }""")]
    [InlineData("/api/save/picture", """{ "path": "a.bmp" }""")]
    [InlineData("/api/save/picture", """{ }""")]
    public async Task Nonsense_is_refused_in_a_sentence(string path, string json)
    {
        await using TestServer server = await TestServer.Start();
        await server.Test.OpenShipped(Scene2, 20, 1);
        using HttpResponseMessage response = await server.Send(HttpMethod.Post, path, new StringContent(json, null, "application/json"));
        Assert.Equal(400, (int)response.StatusCode);
        string error = JsonSerializer.Deserialize<JsonElement>(await response.Content.ReadAsStringAsync()).GetProperty("error").GetString()!;
        Assert.Matches("^[A-Z].*\\.$", error);
    }

    [Fact]
    public async Task What_the_page_complains_about_is_logged_without_control_characters()
    {
        await using TestServer server = await TestServer.Start();
        await server.Post("/api/log", new { text = "went \u001b[31mwrong" }, 204);
        Assert.Contains("page: went  [31mwrong", server.Errors.ToString(), StringComparison.Ordinal);
    }
}
