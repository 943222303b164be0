using System.Net.Http.Json;
using System.Text.Json;
using RayTracer.Session.Tests;

namespace RayTracer.Studio.Tests.Server;

/// <summary>A server around a session of its own, and somebody who asks it over the loopback.</summary>
internal sealed class TestServer : IAsyncDisposable
{
    private readonly HttpClient _client = new(new SocketsHttpHandler { UseProxy = false, UseCookies = false, AllowAutoRedirect = false });

    private TestServer(TestSession test, StudioServer server, StringWriter errors) => (Test, Studio, Errors) = (test, server, errors);

    public TestSession Test { get; }

    public StudioServer Studio { get; }

    public StringWriter Errors { get; }

    public static async Task<TestServer> Start(ServerOptions? options = null)
    {
        TestSession test = new();
        StringWriter errors = new();
        return new(test, await StudioServer.Start(test.Session, (options ?? new()) with { Errors = TextWriter.Synchronized(errors) }), errors);
    }

    /// <summary>Sends a request with the secret, unless headers say otherwise.</summary>
    public Task<HttpResponseMessage> Send(HttpMethod method, string path, HttpContent? content = null, params (string Name, string? Value)[] headers)
    {
        HttpRequestMessage request = new(method, new Uri(Studio.Address, path)) { Content = content };
        foreach ((string name, string? value) in headers.Prepend((LocalGuard.TokenHeader, Studio.Token)))
        {
            request.Headers.Remove(name);
            if (value is not null)
            {
                request.Headers.TryAddWithoutValidation(name, value);
            }
        }

        return _client.SendAsync(request);
    }

    public async Task<JsonElement> Get(string path)
    {
        using HttpResponseMessage response = await Send(HttpMethod.Get, path);
        string text = await response.Content.ReadAsStringAsync();
        Assert.True(response.IsSuccessStatusCode, $"{path}: {(int)response.StatusCode} {text}");
        return JsonSerializer.Deserialize<JsonElement>(text);
    }

    public async Task<JsonElement> Post(string path, object body, int status = 200)
    {
        using HttpResponseMessage response = await Send(HttpMethod.Post, path, JsonContent.Create(body));
        string text = await response.Content.ReadAsStringAsync();
        Assert.True((int)response.StatusCode == status, $"{path}: {(int)response.StatusCode} {text}");
        return text.Length > 0 ? JsonSerializer.Deserialize<JsonElement>(text) : default;
    }

    public async ValueTask DisposeAsync()
    {
        _client.Dispose();
        await Studio.DisposeAsync();
        Test.Dispose();
        Assert.DoesNotContain("error:", Errors.ToString(), StringComparison.Ordinal);
    }
}
