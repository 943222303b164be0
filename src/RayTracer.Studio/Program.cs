using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The Studio: a session, a server around it, and a browser to see it with.</summary>
internal static class Program
{
    private const int WrongUsage = 2;
    private const int InputOutput = 4;

    private static async Task<int> Main(string[] args)
    {
        WideVectors.Enable(args);
        try
        {
            args = PluginFile.LoadAll(args);
        }
        catch (PluginException e)
        {
            await Console.Error.WriteLineAsync($"error: {e.Message}");
            return InputOutput;
        }

        StudioOptions options = StudioOptions.Parse(args, out string? complaint);
        if (complaint is not null)
        {
            await Console.Error.WriteLineAsync($"error: {complaint}\n{StudioOptions.Usage}");
            return WrongUsage;
        }

        if (options.IsHelp)
        {
            await Console.Out.WriteLineAsync(StudioOptions.Help);
            return 0;
        }

        UserFolders folders = UserFolders.OfUser();
        using StudioSession session = new(folders);
        try
        {
            if (options.Scene is { } scene)
            {
                session.Files.Open(Path.GetFullPath(scene));
            }

            await using StudioServer server = await Start(session, options.Port, folders);
            using LaunchPage page = new(server.Link);
            server.Connected += (_, _) => page.Dispose();
            Show(server, page, options.Browser);
            await server.Ended;
            return 0;
        }
        catch (Exception e) when (e is IOException or SessionException or JobException)
        {
            await Console.Error.WriteLineAsync($"error: {e.Message}");
            return InputOutput;
        }
    }

    // At the same address as the last time, where the browser has kept the layout of the window, and what was typed last.
    private static async Task<StudioServer> Start(StudioSession session, int? port, UserFolders folders)
    {
        LastPort last = new(folders);
        StudioServer server = await StudioServer.Start(session, new() { Port = port ?? last.Free() });
        last.Keep(server.Address.Port);
        return server;
    }

    private static void Show(StudioServer server, LaunchPage page, BrowserKind? browser)
    {
        bool isOpen = browser is { } kind && BrowserLauncher.Open(page.FilePath, kind);
        Console.WriteLine(isOpen
            ? $"The Studio opens in a browser window; if it does not, open {server.Link}"
            : $"The Studio is at {server.Link}");
        Console.WriteLine("It ends when its last window is closed and no job runs, or with Ctrl-C.");
    }
}
