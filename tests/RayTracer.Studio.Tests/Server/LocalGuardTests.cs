using System.Net;
using System.Net.Sockets;
using System.Text;

namespace RayTracer.Studio.Tests.Server;

public sealed class LocalGuardTests
{
    [Theory]
    [InlineData("X-Studio-Token", null, 401)]
    [InlineData("X-Studio-Token", "", 401)]
    [InlineData("X-Studio-Token", "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA", 401)]
    [InlineData("Host", "localhost:{port}", 421)]
    [InlineData("Host", "127.0.0.1", 421)]
    [InlineData("Host", "127.0.0.1:{other}", 421)]
    [InlineData("Host", "evil.example:{port}", 421)]
    [InlineData("Host", "127.0.0.1.evil.example:{port}", 421)]
    [InlineData("Host", "[::1]:{port}", 421)]
    [InlineData("Origin", "http://evil.example", 403)]
    [InlineData("Origin", "http://127.0.0.1:{other}", 403)]
    [InlineData("Origin", "https://127.0.0.1:{port}", 403)]
    [InlineData("Origin", "http://127.0.0.1:{port}.evil.example", 403)]
    [InlineData("Origin", "null", 403)]
    [InlineData("Origin", "http://127.0.0.1:{port}", 200)]
    [InlineData("Sec-Fetch-Site", "cross-site", 403)]
    [InlineData("Sec-Fetch-Site", "same-site", 403)]
    [InlineData("Sec-Fetch-Site", "same-origin", 200)]
    [InlineData("Sec-Fetch-Site", "none", 200)]
    public async Task Requests_for_data_are_refused_unless_they_are_the_pages_own(string header, string? value, int status)
    {
        await using TestServer server = await TestServer.Start();
        int port = server.Studio.Address.Port;
        string? text = value?.Replace("{port}", $"{port}", StringComparison.Ordinal).Replace("{other}", $"{port ^ 1}", StringComparison.Ordinal);
        using HttpResponseMessage response = await server.Send(HttpMethod.Get, "/api/command", null, (header, text));
        Assert.Equal(status, (int)response.StatusCode);
        Assert.Equal(status == 200, !(await response.Content.ReadAsStringAsync()).Contains("error", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("/API/command")]
    [InlineData("/Api/state")]
    [InlineData("/api")]
    [InlineData("/api/nothing")]
    public async Task No_spelling_of_a_request_gets_around_the_secret(string path)
    {
        await using TestServer server = await TestServer.Start();
        using HttpResponseMessage response = await server.Send(HttpMethod.Get, path, null, (LocalGuard.TokenHeader, null));
        Assert.Equal(HttpStatusCode.Unauthorized, response.StatusCode);
    }

    [Theory]
    [InlineData("/../../../../etc/passwd")]
    [InlineData("/%2e%2e/%2e%2e/etc/passwd")]
    [InlineData("/assets/..%2f..%2f..%2fetc/passwd")]
    [InlineData("//etc/passwd")]
    [InlineData("/index.html/../../RayTracer.Studio.dll")]
    [InlineData("/wwwroot/index.html")]
    [InlineData("/RayTracer.Studio.dll")]
    [InlineData("/index.html%00.js")]
    [InlineData("/INDEX.HTML")]
    public async Task There_is_no_way_out_of_the_table_of_pages(string path)
    {
        await using TestServer server = await TestServer.Start();
        string answer = await Raw(server, $"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{server.Studio.Address.Port}\r\nConnection: close\r\n\r\n");
        Assert.Matches("^HTTP/1.1 (400|404) ", answer);
        Assert.DoesNotContain("root:", answer, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Doubled_hosts_and_origins_are_refused()
    {
        await using TestServer server = await TestServer.Start();
        string host = $"127.0.0.1:{server.Studio.Address.Port}";
        Assert.Matches("^HTTP/1.1 (400|421) ", await Raw(server, $"GET / HTTP/1.1\r\nHost: {host}\r\nHost: evil.example\r\nConnection: close\r\n\r\n"));
        string origins = await Raw(server, $"GET /api/command HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nOrigin: http://evil.example\r\n{LocalGuard.TokenHeader}: {server.Studio.Token}\r\nConnection: close\r\n\r\n");
        Assert.StartsWith("HTTP/1.1 403 ", origins, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_page_may_be_gone_to_from_elsewhere_but_not_be_used_there()
    {
        await using TestServer server = await TestServer.Start();
        async Task<HttpStatusCode> Status(string mode, string destination)
        {
            using HttpResponseMessage response = await server.Send(
                HttpMethod.Get, "/", null, ("Sec-Fetch-Site", "cross-site"), ("Sec-Fetch-Mode", mode), ("Sec-Fetch-Dest", destination));
            return response.StatusCode;
        }

        Assert.Equal(HttpStatusCode.OK, await Status("navigate", "document"));
        Assert.Equal(HttpStatusCode.Forbidden, await Status("navigate", "iframe"));
        Assert.Equal(HttpStatusCode.Forbidden, await Status("no-cors", "script"));
    }

    [Fact]
    public async Task Every_answer_says_what_browsers_must_not_do()
    {
        await using TestServer server = await TestServer.Start();
        foreach (string path in new[] { "/", "/api/command", "/nothing" })
        {
            using HttpResponseMessage response = await server.Send(HttpMethod.Get, path);
            string policy = Assert.Single(response.Headers.GetValues("Content-Security-Policy"));
            Assert.StartsWith("default-src 'none'; script-src 'self'; ", policy, StringComparison.Ordinal);
            Assert.DoesNotContain("unsafe", policy, StringComparison.Ordinal);
            Assert.Contains("frame-ancestors 'none'", policy, StringComparison.Ordinal);
            Assert.Equal("nosniff", Assert.Single(response.Headers.GetValues("X-Content-Type-Options")));
            Assert.Equal("no-referrer", Assert.Single(response.Headers.GetValues("Referrer-Policy")));
            Assert.False(response.Headers.Contains("Set-Cookie"));
            Assert.False(response.Headers.Contains("Access-Control-Allow-Origin"));
            Assert.Equal(path.StartsWith("/api", StringComparison.Ordinal), response.Headers.CacheControl is { NoStore: true });
        }
    }

    [Fact]
    public async Task Pages_are_not_sent_again_to_whoever_has_them()
    {
        await using TestServer server = await TestServer.Start();
        using HttpResponseMessage first = await server.Send(HttpMethod.Get, "/");
        using HttpResponseMessage again = await server.Send(HttpMethod.Get, "/index.html", null, ("If-None-Match", first.Headers.ETag!.ToString()));
        Assert.Equal(HttpStatusCode.NotModified, again.StatusCode);
        using HttpResponseMessage posted = await server.Send(HttpMethod.Post, "/");
        Assert.Equal(HttpStatusCode.MethodNotAllowed, posted.StatusCode);
    }

    [Fact]
    public async Task The_server_listens_on_this_machines_own_address_only()
    {
        await using TestServer server = await TestServer.Start();
        Assert.Equal("127.0.0.1", server.Studio.Address.Host);
        foreach (IPAddress address in (await Dns.GetHostAddressesAsync(Dns.GetHostName())).Where(a => !IPAddress.IsLoopback(a)))
        {
            using TcpClient client = new(address.AddressFamily);
            await Assert.ThrowsAnyAsync<SocketException>(() => client.ConnectAsync(address, server.Studio.Address.Port));
        }
    }

    [Fact]
    public void Only_the_secret_itself_passes_for_it()
    {
        LocalGuard guard = new("right");
        Assert.True(guard.IsToken("right"));
        Assert.All(new[] { null, "", "righ", "right ", "RIGHT" }, wrong => Assert.False(guard.IsToken(wrong)));
    }

    private static async Task<string> Raw(TestServer server, string request)
    {
        using TcpClient client = new();
        await client.ConnectAsync(IPAddress.Loopback, server.Studio.Address.Port);
        using NetworkStream stream = client.GetStream();
        await stream.WriteAsync(Encoding.ASCII.GetBytes(request));
        using StreamReader reader = new(stream, Encoding.Latin1);
        return await reader.ReadToEndAsync();
    }
}
