using System.Diagnostics;

namespace RayTracer.RenderTests;

/// <summary>Runs a program of this folder in a process of its own, and ends it.</summary>
internal static class ChildProcess
{
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(4);

    /// <summary>What it prints; it must end well.</summary>
    /// <param name="program">File name of the program.</param>
    /// <param name="setting">A setting of the runtime, "NAME=value", or "".</param>
    /// <param name="args">Its arguments.</param>
    public static string Run(string program, string setting, params string[] args)
    {
        ProcessStartInfo start = new("dotnet", [Path.Combine(AppContext.BaseDirectory, program), .. args])
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
        };
        start.Environment.Remove("DOTNET_MaxVectorTBitWidth");
        if (setting.Split('=') is [string name, string value])
        {
            start.Environment[name] = value;
        }

        using Process process = Process.Start(start)!;
        try
        {
            Task<string> output = process.StandardOutput.ReadToEndAsync();
            Assert.True(process.WaitForExit(s_patience), $"still running with {setting}");
            Assert.Equal(0, process.ExitCode);
            return output.Result;
        }
        finally
        {
            process.Kill(entireProcessTree: true);
        }
    }
}
