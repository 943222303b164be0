using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using RayTracer.Session.Tests;

namespace RayTracer.Studio.Tests.Server;

public sealed class LifeTests
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(1);

    [Fact]
    public async Task The_server_ends_by_itself_where_no_window_ever_comes()
    {
        ManualTime time = new();
        await using TestServer server = await TestServer.Start(new() { Time = time });
        time.Pass(TimeSpan.FromSeconds(59));
        await server.Get("/api/command");
        Assert.False(server.Studio.Ended.IsCompleted);
        time.Pass(TimeSpan.FromSeconds(2));
        await server.Studio.Ended.WaitAsync(Patience);
    }

    [Fact]
    public async Task The_server_ends_a_while_after_its_last_window_and_not_before()
    {
        ManualTime time = new();
        await using TestServer server = await TestServer.Start(new() { Time = time });
        Task<HttpResponseMessage> window = await Open(server);
        time.Pass(TimeSpan.FromHours(10));
        Assert.False(server.Studio.Ended.IsCompleted);
        while (!window.IsCompleted)
        {
            server.Test.Session.Notices.Post("info", "one of the changes that the window waits for");
            await Task.Delay(1);
        }

        (await window).Dispose();

        // The window has not asked again yet.
        time.Pass(TimeSpan.FromSeconds(9));
        Assert.False(server.Studio.Ended.IsCompleted);
        time.Pass(TimeSpan.FromSeconds(2));
        await server.Studio.Ended.WaitAsync(Patience);
    }

    [Fact]
    public async Task A_window_that_says_farewell_is_not_waited_for_long()
    {
        ManualTime time = new();
        await using TestServer server = await TestServer.Start(new() { Time = time });
        using HttpResponseMessage wrong = await server.Send(HttpMethod.Post, "/api/bye", new StringContent("guess"), (LocalGuard.TokenHeader, null));
        Assert.Equal(HttpStatusCode.Unauthorized, wrong.StatusCode);
        time.Pass(TimeSpan.FromSeconds(4));
        Assert.False(server.Studio.Ended.IsCompleted);
        using HttpResponseMessage right = await server.Send(HttpMethod.Post, "/api/bye", new StringContent(server.Studio.Token), (LocalGuard.TokenHeader, null));
        Assert.Equal(HttpStatusCode.NoContent, right.StatusCode);
        time.Pass(TimeSpan.FromSeconds(4));
        await server.Studio.Ended.WaitAsync(Patience);
    }

    [Fact]
    public async Task A_window_that_comes_back_after_a_farewell_keeps_the_server()
    {
        ManualTime time = new();
        await using TestServer server = await TestServer.Start(new() { Time = time });
        (await server.Send(HttpMethod.Post, "/api/bye", new StringContent(server.Studio.Token))).Dispose();
        Task<HttpResponseMessage> window = await Open(server);
        time.Pass(TimeSpan.FromHours(1));
        Assert.False(server.Studio.Ended.IsCompleted);
        await server.Studio.DisposeAsync();
        (await window).Dispose();
    }

    [Fact]
    public async Task The_server_lives_as_long_as_a_job_does_and_then_a_while_for_its_window()
    {
        ManualTime time = new();
        await using TestServer server = await TestServer.Start(new() { Time = time });
        using ManualResetEventSlim end = new();
        server.Test.Session.Jobs.Start("a long job", (_, _) =>
        {
            end.Wait(CancellationToken.None);
            return "done";
        });
        (await server.Send(HttpMethod.Post, "/api/bye", new StringContent(server.Studio.Token))).Dispose();
        time.Pass(TimeSpan.FromHours(10));
        JsonElement job = (await server.Get("/api/state?after=-1")).GetProperty("jobs")[0];
        Assert.Equal("a long job", job.GetProperty("text").GetString());
        time.Pass(TimeSpan.FromHours(10));
        Assert.False(server.Studio.Ended.IsCompleted);
        end.Set();
        await server.Test.Until(() => server.Test.Session.Jobs.Running.Count == 0 ? "none" : null);
        Assert.False(server.Studio.Ended.IsCompleted);
        while (!server.Studio.Ended.IsCompleted)
        {
            time.Pass(TimeSpan.FromSeconds(11));
            await Task.Delay(1);
        }
    }

    [Fact]
    public async Task Help_is_no_error()
    {
        ProcessStartInfo start = new("dotnet", [typeof(StudioServer).Assembly.Location, "--help"]) { UseShellExecute = false, RedirectStandardOutput = true };
        using Process program = Process.Start(start)!;
        string text = await program.StandardOutput.ReadToEndAsync().WaitAsync(Patience);
        await program.WaitForExitAsync().WaitAsync(Patience);
        Assert.Equal(0, program.ExitCode);
        Assert.All(["--port N", "--no-browser", "--open app|browser", "--plugin FILE", "--help"], option => Assert.Contains(option, text, StringComparison.Ordinal));
    }

    [Fact]
    public void The_port_of_the_last_time_is_taken_again_unless_it_is_taken()
    {
        string folder = Directory.CreateTempSubdirectory("raytracer-studio-test-").FullName;
        try
        {
            LastPort last = new(new(folder, folder, folder));
            Assert.Equal(0, last.Free());
            using TcpListener other = new(IPAddress.Loopback, 0);
            other.Start();
            int port = ((IPEndPoint)other.LocalEndpoint).Port;
            last.Keep(port);
            Assert.Equal(0, last.Free());
            other.Stop();
            Assert.Equal(port, last.Free());
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public async Task Two_studios_at_once_know_nothing_of_each_other()
    {
        await using TestServer one = await TestServer.Start();
        await using TestServer two = await TestServer.Start();
        Assert.NotEqual(one.Studio.Address, two.Studio.Address);
        Assert.NotEqual(one.Studio.Token, two.Studio.Token);
        Assert.Equal(43, one.Studio.Token.Length);
        using HttpResponseMessage crossed = await one.Send(HttpMethod.Get, "/api/command", null, (LocalGuard.TokenHeader, two.Studio.Token));
        Assert.Equal(HttpStatusCode.Unauthorized, crossed.StatusCode);
        await one.Test.Open("""{ "shapes": [], "render": { "integrator": "report", "width": 8, "height": 8 } }""");
        Assert.NotEqual((await one.Get("/api/state")).GetProperty("document").GetProperty("name").GetString(), (await two.Get("/api/state")).GetProperty("document").GetProperty("name").GetString());
    }

    [SkippableFact]
    public async Task The_page_that_hands_over_the_secret_is_for_its_user_only_and_goes_away()
    {
        Skip.If(OperatingSystem.IsWindows(), "Windows has no modes of files; the temporary folder is the user's own.");
        string folder;
        using (LaunchPage page = new("http://127.0.0.1:1/#token=secret"))
        {
            folder = Path.GetDirectoryName(page.FilePath)!;
            Assert.Equal(UnixFileMode.UserRead | UnixFileMode.UserWrite, new FileInfo(page.FilePath).UnixFileMode);
            Assert.Equal(UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute, new DirectoryInfo(folder).UnixFileMode);
            Assert.Contains("http://127.0.0.1:1/#token=secret", await File.ReadAllTextAsync(page.FilePath), StringComparison.Ordinal);
        }

        Assert.False(Directory.Exists(folder));
    }

    [Fact]
    public async Task The_program_serves_and_ends_when_its_window_says_farewell()
    {
        ProcessStartInfo start = new("dotnet", [typeof(StudioServer).Assembly.Location, "--no-browser"]) { UseShellExecute = false, RedirectStandardOutput = true };
        string folder = Directory.CreateTempSubdirectory("raytracer-studio-test-").FullName;
        (start.Environment["XDG_STATE_HOME"], start.Environment["XDG_CACHE_HOME"]) = (folder, folder);
        using Process program = Process.Start(start)!;
        try
        {
            string line = (await program.StandardOutput.ReadLineAsync().WaitAsync(Patience))!;
            Uri link = new(line[line.IndexOf("http", StringComparison.Ordinal)..]);
            using HttpClient client = new();
            string token = link.Fragment["#token=".Length..];
            using HttpResponseMessage farewell = await client.PostAsync(new Uri(link, "/api/bye"), new StringContent(token));
            Assert.Equal(HttpStatusCode.NoContent, farewell.StatusCode);
            await program.WaitForExitAsync().WaitAsync(Patience);
            Assert.Equal(0, program.ExitCode);
        }
        finally
        {
            program.Kill(entireProcessTree: true);
            Directory.Delete(folder, recursive: true);
        }
    }

    [Theory]
    [InlineData("", null, null, true)]
    [InlineData("a.json --port 80", "a.json", 80, true)]
    [InlineData("--no-browser a.json", "a.json", null, false)]
    public void Command_lines_are_understood(string line, string? scene, int? port, bool opens)
    {
        StudioOptions options = StudioOptions.Parse(line.Split(' ', StringSplitOptions.RemoveEmptyEntries), out string? complaint);
        Assert.Null(complaint);
        Assert.Equal((scene, port, opens), (options.Scene, options.Port, options.Browser is not null));
    }

    [Theory]
    [InlineData("--port")]
    [InlineData("--port 65536")]
    [InlineData("--port -1")]
    [InlineData("--open door")]
    [InlineData("--nobrowser")]
    [InlineData("a.json b.json")]
    public void Wrong_command_lines_are_refused(string line)
    {
        StudioOptions.Parse(line.Split(' '), out string? complaint);
        Assert.NotNull(complaint);
    }

    // A window that waits for news.
    private static async Task<Task<HttpResponseMessage>> Open(TestServer server)
    {
        long version = (await server.Get("/api/state?after=-1")).GetProperty("version").GetInt64();
        Task<HttpResponseMessage> waiting = server.Send(HttpMethod.Get, $"/api/state?after={version + 100}");
        while (server.Test.Session.Changes.Waiting == 0)
        {
            await Task.Delay(5);
        }

        return waiting;
    }
}
