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
    public async Task Its_panels_offer_the_things_of_plug_ins_and_their_scenes_are_opened()
    {
        string scene = Path.Combine(_folder.FullName, "velvet.json");
        await File.WriteAllTextAsync(scene, """{ "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "velvet" } }] }""");
        using Process process = Start(Command, scene, "--plugin", Path.Combine(AppContext.BaseDirectory, "RayTracer.SamplePlugin.dll"));
        try
        {
            string line = await process.StandardOutput.ReadLineAsync() ?? await process.StandardError.ReadToEndAsync();
            Uri link = new(line["The Studio is at ".Length..]);
            using HttpClient client = new() { BaseAddress = link };
            client.DefaultRequestHeaders.Add(LocalGuard.TokenHeader, link.Fragment["#token=".Length..]);
            Assert.Contains("\"velvet\"", await client.GetStringAsync(new Uri("api/schema", UriKind.Relative)), StringComparison.Ordinal);
            Assert.Contains("velvet.json", await client.GetStringAsync(new Uri("api/state", UriKind.Relative)), StringComparison.Ordinal);
        }
        finally
        {
            process.Kill(entireProcessTree: true);
        }
    }

    [Fact]
    public void What_is_no_plug_in_is_refused_before_a_window_opens()
    {
        using Process process = Start(Command, "--plugin", "missing.dll");
        string error = process.StandardError.ReadToEnd();
        process.WaitForExit();
        Assert.Equal(4, process.ExitCode);
        Assert.Contains("missing.dll: cannot be loaded", error, StringComparison.Ordinal);
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

    private static Process Start(string folder, params string[] words) => Process.Start(new ProcessStartInfo("dotnet", [Path.Combine(folder, "raytracer.dll"), "studio", "--no-browser", .. words])
    {
        UseShellExecute = false,
        RedirectStandardOutput = true,
        RedirectStandardError = true,
    })!;
}
