using System.ComponentModel;
using System.Diagnostics;

namespace RayTracer.Studio;

/// <summary>Opens the page in a browser.</summary>
internal static class BrowserLauncher
{
    /// <summary>Opens a file in a browser.</summary>
    /// <param name="page">The file.</param>
    /// <param name="kind">In which browser.</param>
    /// <returns>True if there is one; it may still fail later.</returns>
    public static bool Open(string page, BrowserKind kind) =>
        (kind == BrowserKind.App && Programs().Any(program => Start(program, AppArguments(page)))) || OpenByDefault(page);

    // A profile of its own, so that the user's windows, extensions and settings have nothing to do with it.
    private static string[] AppArguments(string page) =>
    [
        $"--app={new Uri(page).AbsoluteUri}",
        $"--user-data-dir={Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData), "raytracer-studio", "browser")}",
        "--no-first-run",
        "--no-default-browser-check",
    ];

    private static IEnumerable<string> Programs()
    {
        if (OperatingSystem.IsWindows())
        {
            Environment.SpecialFolder[] folders = [Environment.SpecialFolder.ProgramFiles, Environment.SpecialFolder.ProgramFilesX86, Environment.SpecialFolder.LocalApplicationData];
            return folders.Select(Environment.GetFolderPath)
                .SelectMany(folder => new[] { Path.Combine(folder, @"Google\Chrome\Application\chrome.exe"), Path.Combine(folder, @"Microsoft\Edge\Application\msedge.exe") })
                .Where(File.Exists);
        }

        return OperatingSystem.IsMacOS()
            ? new[] { "Google Chrome", "Chromium", "Microsoft Edge" }.Select(name => $"/Applications/{name}.app/Contents/MacOS/{name}").Where(File.Exists)
            : ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge"];
    }

    private static bool OpenByDefault(string page) =>
        OperatingSystem.IsWindows() ? Start(new ProcessStartInfo(page) { UseShellExecute = true })
        : Start(OperatingSystem.IsMacOS() ? "open" : "xdg-open", page);

    private static bool Start(string program, params string[] arguments) =>
        Start(new ProcessStartInfo(program, arguments) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true });

    // A browser that fails at once, as one without a screen does, counts as none.
    private static bool Start(ProcessStartInfo start)
    {
        const int patienceMilliseconds = 500;
        try
        {
            Process? process = Process.Start(start);
            if (process is null || start.UseShellExecute)
            {
                return true;
            }

            // What browsers say is of no use to anybody, but must be taken from them.
            process.OutputDataReceived += (_, _) => { };
            process.ErrorDataReceived += (_, _) => { };
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            return !process.WaitForExit(patienceMilliseconds) || process.ExitCode == 0;
        }
        catch (Exception e) when (e is Win32Exception or InvalidOperationException or PlatformNotSupportedException)
        {
            return false;
        }
    }
}

/// <summary>The browser that opens the page.</summary>
internal enum BrowserKind
{
    /// <summary>A separate window, of Chromium, Chrome or Edge, where there is one; else the default browser.</summary>
    App,

    /// <summary>The default browser.</summary>
    Default,
}
