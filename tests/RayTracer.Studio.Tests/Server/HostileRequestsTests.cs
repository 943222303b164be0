using System.Text;
using System.Text.Json;
using RayTracer.Session;

namespace RayTracer.Studio.Tests.Server;

/// <summary>What cannot be meant is refused in a sentence or changes nothing: it breaks no request after it, and nothing of it stands in the text.</summary>
public sealed class HostileRequestsTests
{
    private const string Scene = """
        {
          "render": { "width": 24, "height": 16, "samplesPerPixel": 1, "maxDepth": 2 },
          "camera": { "position": [0, 2, 6], "lookAt": [0, 0, 0] },
          "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }, { "type": "sphere", "name": "ball", "center": [0, 1, 0], "radius": 1 }],
          "lights": [
            { "type": "spot", "position": [0, 4, 0], "direction": [0, -1, 0], "intensity": 9, "cutoffAngle": 30 },
            { "type": "sphere", "center": [3, 3, 0], "radius": 0.5, "material": { "type": "luminaire" } }
          ],
          "environment": { "type": "sky" },
          "animation": [{ "property": "shapes.ball.radius", "keys": [{ "time": 0, "value": 1 }, { "time": 1, "value": 2 }] }]
        }
        """;

    // Too large for a float, for a double and for an integer; no number; other kinds of values; too long.
    private static readonly string[] s_values =
    [
        "1e39", "-1e39", "3e38", "1e400", "-1e400", "1e-46", "2147483647", "-2147483648", "99999999999", "-1", "0", "3.5", "NaN", "\"NaN\"", "\"Infinity\"", "null", "true", "\"\"", "\"/\"", "\"x\"", "{}", "[]",
        "[null]", "[[]]", "[1, 1]", "[1e39, 1e400]", "[1, 2, 3, 4]", "[\"a\"]", $"\"{new string('~', 100_000)}\"", new string('[', 1000),
    ];

    [Theory]
    [InlineData("""/api/view/light/drag { "pointer": "/lights/0", "kind": "cone", "to": ?, "gesture": "g" }""")]
    [InlineData("""/api/view/light/drag { "pointer": "/lights/0", "kind": "beam", "to": [?, 1], "gesture": "g" }""")]
    [InlineData("""/api/view/light/drag { "pointer": "/lights/0", "kind": "direction", "to": [?, ?], "gesture": "g" }""")]
    [InlineData("""/api/view/light/drag { "pointer": "/lights/1", "kind": "radius", "to": [1, ?], "gesture": "g" }""")]
    [InlineData("""/api/view/light/drag { "pointer": "/environment", "kind": "direction", "to": [?, 1], "gesture": "g" }""")]
    [InlineData("""/api/view/light/drag { "pointer": ?, "kind": ?, "to": [1, 1], "gesture": ? }""")]
    [InlineData("""/api/view/gizmo { "pointer": "/lights/0", "kind": "move", "length": ? }""")]
    [InlineData("""/api/view/gizmo { "pointer": ?, "kind": "rotate", "length": 10 }""")]
    [InlineData("""/api/view/drag { "pointer": "/lights/0", "kind": "move", "axis": 0, "from": [1, 1], "to": [?, 2], "gesture": ? }""")]
    [InlineData("""/api/view/drag { "pointer": "/lights/0", "kind": "rotate", "axis": ?, "from": [?, 1], "to": [9, 2], "gesture": "g" }""")]
    [InlineData("""/api/view/drag { "pointer": "/shapes/1", "kind": "scale", "axis": 1, "from": [1, ?], "to": [2, ?], "gesture": "h" }""")]
    [InlineData("""/api/view/lights/mix { "factors": { "sphere": ?, "spot": [?, 1, 1] } }""")]
    [InlineData("""/api/document/place { "pointer": "/lights/0", "translate": [?, 0, 0], "gesture": "g" }""")]
    [InlineData("""/api/document/apply { "pointer": "/lights/0", "at": [?, 1] }""")]
    [InlineData("""/api/timeline/frame { "frame": ? }""")]
    [InlineData("""/api/timeline/play { "isPlaying": ? }""")]
    [InlineData("""/api/timeline/key { "pointer": ? }""")]
    [InlineData("""/api/timeline/move { "keys": [{ "keys": "/animation/0/keys", "numbers": [1] }], "frames": ?, "copies": ?, "gesture": "g" }""")]
    [InlineData("""/api/timeline/move { "keys": [{ "keys": ?, "numbers": ? }], "frames": 1 }""")]
    [InlineData("""/api/timeline/move { "keys": ?, "frames": 1 }""")]
    [InlineData("""/api/timeline/ease { "keys": [{ "keys": "/animation/0/keys", "numbers": [?] }], "ease": ? }""")]
    [InlineData("""/api/timeline/remove { "keys": [{ "keys": "/animation/0/keys", "numbers": [?] }] }""")]
    [InlineData("""/api/view/render { "edition": ?, "map": ? }""")]
    [InlineData("""/api/view/render { "samples": ?, "threads": ?, "region": [0, ?, 4, ?] }""")]
    [InlineData("""/api/view/camera { "kind": "orbit", "dx": ?, "dy": ?, "gesture": "g", "around": [?, 1] }""")]
    [InlineData("""/api/view/camera { "kind": "dolly", "dx": ?, "gesture": ? }""")]
    [InlineData("""/api/background/frames { "first": ?, "last": ?, "path": ? }""")]
    public async Task Bodies_with_other_values_than_meant_do_no_harm(string request)
    {
        string[] parts = request.Split(' ', 2);
        await using TestServer server = await TestServer.Start();
        await server.Test.Open(Scene);
        server.Test.Session.View.Change(s => s with { Threads = 1 });
        foreach (string value in s_values)
        {
            await Harmless(server, parts[0], Body(parts[1].Replace("?", value, StringComparison.Ordinal)), value);
            string text = server.Test.Session.Document.Text;
            Assert.True(text.Length < 10_000 && !text.Contains("Infinity", StringComparison.Ordinal) && !text.Contains("NaN", StringComparison.Ordinal), $"{Short(value)} came into the text:\n{text[..Math.Min(text.Length, 2000)]}");
            Assert.NotNull(server.Test.Session.Document.Read.Root);
            while (server.Test.Session.Document.Text != Scene)
            {
                server.Test.Session.Document.Undo();
            }
        }
    }

    [Theory]
    [InlineData("/api/paths?x=@&y=@&first=@&count=@")]
    [InlineData("/api/paths?x=1&y=1&first=0&count=@")]
    [InlineData("/api/paths/summary?x=@&y=1")]
    [InlineData("/api/paths/tree?x=1&y=1&sample=@&ray=1&tree=bvh")]
    [InlineData("/api/paths/tree?x=1&y=1&sample=0&ray=@&tree=@")]
    [InlineData("/api/pick?x=@&y=@")]
    [InlineData("/api/view/mask?pointer=@&step=@")]
    [InlineData("/api/view/pixels?x=@&y=@&width=@&height=@")]
    [InlineData("/api/view/pixels?x=0&y=0&width=@&height=2147483647")]
    [InlineData("/api/timeline/paths?pointer=@")]
    [InlineData("/api/frame?after=0&width=@&height=@")]
    [InlineData("/api/help/page?id=@")]
    public async Task Addresses_with_other_values_than_meant_do_no_harm(string request)
    {
        await using TestServer server = await TestServer.Start(new() { Patience = TimeSpan.FromMilliseconds(10) });
        await server.Test.Open(Scene);
        foreach (string? edition in new[] { "fast", ViewSettings.Editions[1] })
        {
            await server.Post("/api/view/render", new { edition });
            foreach (string value in s_values.Where(v => v.Length < 2000))
            {
                await Harmless(server, request.Replace("@", Uri.EscapeDataString(value), StringComparison.Ordinal), null, value);
            }
        }
    }

    [Fact]
    public async Task Many_at_once_are_all_answered_while_the_scene_becomes_another()
    {
        await using TestServer server = await TestServer.Start();
        await server.Test.Open(Scene);
        await server.Post("/api/view/render", new { edition = ViewSettings.Editions[1] });
        Task[] many = [.. Enumerable.Range(0, 120).Select(i => (i % 4) switch
        {
            0 => Harmless(server, $"/api/paths/tree?x={i % 24}&y=9&sample=0&ray=1&tree={TreeWalks.Names[i % TreeWalks.Names.Count]}", null, ""),
            1 => Harmless(server, $"/api/paths/summary?x={i % 24}&y=9", null, ""),
            2 => Harmless(server, "/api/timeline/frame", Body($$"""{ "frame": {{i % 24}} }"""), ""),
            _ => Harmless(server, "/api/view/light/drag", Body($$"""{ "pointer": "/lights/0", "kind": "cone", "to": [{{i}}, 9], "gesture": "{{i}}" }"""), ""),
        })];
        await Task.WhenAll(many);
        await server.Get("/api/state");
    }

    private static StringContent Body(string json) => new(json, Encoding.UTF8, "application/json");

    private static async Task Harmless(TestServer server, string path, HttpContent? body, string value)
    {
        using HttpResponseMessage response = await server.Send(body is null ? HttpMethod.Get : HttpMethod.Post, path, body);
        string answer = await response.Content.ReadAsStringAsync();
        Assert.True((int)response.StatusCode is 200 or 204 or 400 or 404 or 409 or 414, $"{Short(value)}: {(int)response.StatusCode} {Short(answer)}");
        if ((int)response.StatusCode is >= 400 and < 414)
        {
            string? error = answer.Contains("\"error\"", StringComparison.Ordinal) ? JsonSerializer.Deserialize<JsonElement>(answer).GetProperty("error").GetString() : null;
            Assert.True(error?.Length < 2000 && error[^1] is '.' or '…' && !char.IsLower(error[0]), $"{Short(value)}: {(int)response.StatusCode} {Short(answer)}");
        }
    }

    private static string Short(string text) => text.Length < 300 ? text : $"{text[..300]} …";
}
