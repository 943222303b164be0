using System.Diagnostics;

namespace RayTracer.Studio.Tests.Server;

/// <summary><c>raytracer studio</c>, from where the command and the Studio are built to.</summary>
public sealed class StudioVerbTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("studio-verb-");

    // bin/CONFIGURATION/FRAMEWORK, as of these tests.
    private static string[] Built { get; } = AppContext.BaseDirectory.TrimEnd(Path.DirectorySeparatorChar).Split(Path.DirectorySeparatorChar)[^3..];

    private static string Command { get; } = ProjectFolder.PathOf(["src", "RayTracer.Cli", .. Built]);

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void A_built_command_opens_the_built_Studio()
    {
        using Process process = Start(Command);
        string? line = process.StandardOutput.ReadLine();
        process.Kill(entireProcessTree: true);
        Assert.True(line?.StartsWith("The Studio is at http://", StringComparison.Ordinal), $"{line}{process.StandardError.ReadToEnd()}");
    }

    [Fact]
    public void Where_only_the_command_is_built_it_names_the_command_that_builds_the_Studio()
    {
        string here = Path.Combine([_folder.FullName, "RayTracer.Cli", .. Built]);
        string studio = Directory.CreateDirectory(Path.Combine(_folder.FullName, "RayTracer.Studio")).FullName;
        Directory.CreateDirectory(here);
        foreach (string file in Directory.EnumerateFiles(Command))
        {
            File.Copy(file, Path.Combine(here, Path.GetFileName(file)));
        }

        using Process process = Start(here);
        string error = process.StandardError.ReadToEnd();
        process.WaitForExit();
        Assert.Equal(4, process.ExitCode);
        Assert.Contains($"\"dotnet build -c {Built[1]} {studio}\" builds it", error, StringComparison.Ordinal);
    }

    private static Process Start(string folder) => Process.Start(new ProcessStartInfo("dotnet", [Path.Combine(folder, "raytracer.dll"), "studio", "--no-browser"])
    {
        UseShellExecute = false,
        RedirectStandardOutput = true,
        RedirectStandardError = true,
    })!;
}
