using System.Diagnostics;

namespace RayTracer.RenderTests;

/// <summary>Runs a program of this folder in a process of its own, and ends it.</summary>
internal static class ChildProcess
{
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(4);

    /// <summary>What it prints; it must end well.</summary>
    /// <param name="program">File name of the program.</param>
    /// <param name="settings">Settings of the runtime, "NAME=value", with spaces between them.</param>
    /// <param name="args">Its arguments.</param>
    public static string Run(string program, string settings, params string[] args)
    {
        ProcessStartInfo start = new("dotnet", [Path.Combine(AppContext.BaseDirectory, program), .. args])
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
        };
        start.Environment.Remove("DOTNET_MaxVectorTBitWidth");
        foreach (string setting in settings.Split(' ', StringSplitOptions.RemoveEmptyEntries))
        {
            string[] parts = setting.Split('=');
            start.Environment[parts[0]] = parts[1];
        }

        using Process process = Process.Start(start)!;
        try
        {
            Task<string> output = process.StandardOutput.ReadToEndAsync();
            Assert.True(process.WaitForExit(s_patience), $"still running with {settings}");
            Assert.Equal(0, process.ExitCode);
            return output.Result;
        }
        finally
        {
            process.Kill(entireProcessTree: true);
        }
    }
}
