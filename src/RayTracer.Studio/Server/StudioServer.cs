using System.Buffers.Text;
using System.Net;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Http.HttpResults;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The server around a session: on this machine's own address, for those who know the secret.</summary>
internal sealed class StudioServer : IAsyncDisposable
{
    // Texts that are typed or pasted; uploads set their own limit.
    private const long LargestBody = 64 << 20;
    private readonly WebApplication _app;
    private readonly WindowWatch _windows;
    private readonly string _token;

    private StudioServer(StudioSession session, ServerOptions options)
    {
        session.View.HideFresh();
        _token = Base64Url.EncodeToString(RandomNumberGenerator.GetBytes(32));
        _app = Build(options);
        _windows = new(options.Grace, options.Time, () => session.Jobs.Running.Count > 0, _app.Lifetime.StopApplication);
        session.Jobs.Changed += (_, _) => _windows.WorkChanged();
        LocalGuard guard = new(_token);
        guard.Admitted += (_, _) => Connected?.Invoke(this, EventArgs.Empty);
        LongPoll poll = new(_windows, options.Patience, _app.Lifetime.ApplicationStopping);
        _app.Use(guard.Invoke);
        _app.Use(new ErrorAnswers(options.Errors).Invoke);
        _app.UseRouting();
        // Values that may be left out, and cannot be read, are only marked so.
        RouteGroupBuilder api = _app.MapGroup(LocalGuard.Api).AddEndpointFilter((call, next) => call.HttpContext.Response.StatusCode == StatusCodes.Status400BadRequest
            ? throw new BadHttpRequestException("A value in the address is of another kind than it has to be.") : next(call));
        api.MapLife(guard, _windows, options.Errors);
        api.MapFrames(session.View, poll);
        // A request that has nothing to return gets the revision that the document has now.
        RouteGroupBuilder acting = api.MapGroup("").AddEndpointFilter(async (call, next) =>
            await next(call) is var answer and not EmptyHttpResult ? answer : new { revision = session.Document.Revision });
        acting.MapState(session, poll);
        acting.MapDocument(session);
        acting.MapView(session);
        acting.MapTimeline(session);
        acting.MapInspection(session);
        acting.MapHelp(session);
        acting.MapSaving(session);
        api.MapFallback("{**path}", () => { throw new SessionException("There is no such request.", SessionFault.Missing); });
        _app.MapFallback("{**path}", new EmbeddedAssets().Serve);
        Guard = guard;
    }

    /// <summary>Raised by each request that bears the secret.</summary>
    public event EventHandler? Connected;

    /// <summary>The server's address.</summary>
    public Uri Address { get; private set; } = null!;

    /// <summary>The secret.</summary>
    public string Token => _token;

    /// <summary>The page's address, with the secret in the part that browsers send nobody.</summary>
    public string Link => $"{Address}#token={_token}";

    /// <summary>Ends when the server does: after the last window, at Ctrl-C, or when it is stopped.</summary>
    public Task Ended => _app.WaitForShutdownAsync();

    private LocalGuard Guard { get; }

    /// <summary>Starts a server.</summary>
    /// <param name="session">The session that is served.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <exception cref="IOException">The port is taken.</exception>
    public static async Task<StudioServer> Start(StudioSession session, ServerOptions? options = null)
    {
        StudioServer server = new(session, options ?? new());
        await server._app.StartAsync();
        string address = server._app.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>()!.Addresses.First();
        server.Address = new(address);
        server.Guard.Listen(server.Address.Port);
        return server;
    }

    /// <inheritdoc/>
    public async ValueTask DisposeAsync()
    {
        await _app.StopAsync();
        _windows.Dispose();
        await _app.DisposeAsync();
    }

    // Nothing but what is used: no settings from files or the environment, no log.
    private static WebApplication Build(ServerOptions options)
    {
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new() { Args = [], ContentRootPath = AppContext.BaseDirectory });
        builder.WebHost.UseKestrelCore().ConfigureKestrel(kestrel =>
        {
            kestrel.Listen(IPAddress.Loopback, options.Port);
            kestrel.AddServerHeader = false;
            kestrel.Limits.MaxRequestBodySize = LargestBody;
        });
        builder.Services.AddRoutingCore();
        builder.Services.ConfigureHttpJsonOptions(json => ApiJson.Configure(json.SerializerOptions));
        builder.Services.Configure<RouteHandlerOptions>(routes => routes.ThrowOnBadRequest = true);
        builder.Services.Configure<HostOptions>(host => host.ShutdownTimeout = TimeSpan.FromSeconds(2));
        return builder.Build();
    }
}

/// <summary>The options of the server.</summary>
internal sealed record ServerOptions
{
    /// <summary>The port; 0 for a free one.</summary>
    public int Port { get; init; }

    /// <summary>The times to wait for windows.</summary>
    public GraceTimes Grace { get; init; } = GraceTimes.Default;

    /// <summary>The longest time that a request waits for news.</summary>
    public TimeSpan Patience { get; init; } = TimeSpan.FromSeconds(20);

    /// <summary>The clock for waiting for windows.</summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>The writer that errors are reported to.</summary>
    public TextWriter Errors { get; init; } = Console.Error;
}
