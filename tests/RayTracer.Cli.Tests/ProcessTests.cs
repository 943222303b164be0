using System.Diagnostics;
using System.Numerics;
using System.Runtime.Intrinsics;
using System.Text.Json;
using RayTracer.Cli;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Cli.Tests;

/// <summary>The command as a process of its own.</summary>
public sealed class ProcessTests : IDisposable
{
    private const int Patience = 240_000;
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public ProcessTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Exit_status_and_streams_are_those_of_the_command()
    {
        (int status, string output, string error) = Finish(Start("check", _scene));
        Assert.Equal((0, $"{_scene}: fine\n", ""), (status, output.ReplaceLineEndings("\n"), error));
        Assert.Equal(2, Finish(Start("--foo")).Status);
        Assert.Equal(4, Finish(Start("check", _folder["missing.json"])).Status);
    }

    [Theory]
    [InlineData("-", "PNG")]
    [InlineData("-.exr", "OpenEXR")]
    public void A_picture_goes_to_standard_output_alone(string output, string format)
    {
        using Process process = Process.Start(new ProcessStartInfo(Program, ["render", _scene, "-o", output, "--json", "--spp", "1"]) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true })!;
        using MemoryStream bytes = new();
        process.StandardOutput.BaseStream.CopyTo(bytes);
        Assert.True(process.WaitForExit(Patience));
        Assert.Equal(0, process.ExitCode);
        File.WriteAllBytes(_folder["out"], bytes.ToArray());
        ImageDescription picture = ImageFile.Describe(_folder["out"]);
        Assert.Equal((format, 24, 16), (picture.Format, picture.Width, picture.Height));
        CliRun.Fine("render", _scene, "-o", _folder[$"same{(output == "-" ? ".png" : ".exr")}"], "--quiet", "--spp", "1");
        Assert.Equal(ImageFile.Read(_folder[$"same{(output == "-" ? ".png" : ".exr")}"]).Pixels, ImageFile.Read(_folder["out"]).Pixels);
        Assert.False(File.Exists("-.png"));
    }

    [Fact]
    public void A_scene_from_standard_input_is_called_so()
    {
        foreach ((string text, int expected, string said) in new[] { (CliRun.Scene, 0, "<stdin>: fine"), ("{ \"a\": 1 }", 3, "<stdin>:1:3: error: unknown key") })
        {
            using Process process = Process.Start(new ProcessStartInfo(Program, ["check", "-"]) { UseShellExecute = false, RedirectStandardInput = true, RedirectStandardOutput = true })!;
            process.StandardInput.Write(text);
            process.StandardInput.Close();
            string output = process.StandardOutput.ReadToEnd();
            Assert.True(process.WaitForExit(Patience));
            Assert.Equal(expected, process.ExitCode);
            Assert.StartsWith(said, output, StringComparison.Ordinal);
        }
    }

    [LinuxFact]
    public void Full_standard_output_is_an_error()
    {
        using Process process = Process.Start(new ProcessStartInfo("/bin/sh", ["-c", "exec \"$0\" \"$@\" > /dev/full", Program, "schema"]) { UseShellExecute = false, RedirectStandardError = true })!;
        (int status, string error) = End(process, process.StandardError.ReadToEndAsync());
        Assert.Equal(4, status);
        Assert.StartsWith("raytracer: error: ", error);
        Assert.Single(error.TrimEnd().Split('\n'));
    }

    [ProgramFact("bash")]
    public void A_scene_comes_through_a_pipe() =>
        Assert.Equal((0, "/dev/stdin: fine\n"), ProgramFactAttribute.Run("bash", "-c", $"cat '{_scene}' | '{Program}' check /dev/stdin"));

    [LinuxFact]
    public void Full_standard_error_costs_no_picture()
    {
        string image = _folder["picture.png"];
        using Process process = Process.Start(new ProcessStartInfo("/bin/sh", ["-c", "exec \"$0\" \"$@\" 2> /dev/full", Program, "render", _scene, "-o", image]) { UseShellExecute = false, RedirectStandardError = true })!;
        (int status, _) = End(process, process.StandardError.ReadToEndAsync());
        Assert.Equal(0, status);
        Assert.True(File.Exists(image));
    }

    [RootFact]
    public void A_full_disk_ends_with_one_line_and_leaves_nothing()
    {
        string disk = _folder["disk"];
        Directory.CreateDirectory(disk);
        Assert.Equal(0, ProgramFactAttribute.Run("mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", disk).ExitCode);
        try
        {
            (int status, _, string error) = Finish(Start("render", _scene, "-o", Path.Combine(disk, "a.pfm"), "--width", "200", "--height", "200", "--spp", "1", "--quiet"));
            Assert.Equal(4, status);
            Assert.Contains("No space left on device", Assert.Single(error.TrimEnd().Split('\n')), StringComparison.Ordinal);
            Assert.Empty(Directory.GetFileSystemEntries(disk));
        }
        finally
        {
            ProgramFactAttribute.Run("umount", disk);
        }
    }

    [ProgramFact("script")]
    public void A_terminal_gets_the_picture_and_colours_only_where_they_are_wanted()
    {
        string command = $"'{Program}' render '{_scene}' -o '{_folder["a.png"]}' --preview";
        (int status, string shown) = ProgramFactAttribute.Run("/usr/bin/env", "-u", "NO_COLOR", "TERM=xterm-256color", "script", "-qec", command, "/dev/null");
        Assert.Equal(0, status);
        Assert.Contains("\e[38;2;", shown, StringComparison.Ordinal);
        Assert.Contains("\e[?25h", shown, StringComparison.Ordinal);
        (_, string plain) = ProgramFactAttribute.Run("/usr/bin/env", "NO_COLOR=1", "TERM=xterm-256color", "script", "-qec", command, "/dev/null");
        Assert.DoesNotMatch("\e\\[[0-9;]*m", plain);
        Assert.Matches("[-=+*#%@]{8}", plain);
        (_, string redirected) = ProgramFactAttribute.Run("/usr/bin/env", "TERM=xterm-256color", "script", "-qec", $"{command} --verbose 2> '{_folder["error.txt"]}'", "/dev/null");
        Assert.DoesNotContain("▀", redirected, StringComparison.Ordinal);
        string error = File.ReadAllText(_folder["error.txt"]);
        Assert.DoesNotContain("\e[", error, StringComparison.Ordinal);
        Assert.Contains("--preview: standard error is not a terminal", error, StringComparison.Ordinal);
    }

    [LinuxFact]
    public void Ctrl_C_writes_the_image_so_far() => SignalWritesTheImage("INT", 130);

    [LinuxFact]
    public void Termination_writes_the_image_so_far() => SignalWritesTheImage("TERM", 143);

    [LinuxFact]
    public void A_closed_terminal_leaves_the_image_so_far() => SignalWritesTheImage("HUP", 129, "> /dev/full");

    [LinuxFact]
    public void Ctrl_C_leaves_the_reproduced_pictures_so_far()
    {
        using Process process = StartInterruptible("", "reproduce", "report", "-o", _folder["report"]);
        try
        {
            Task<string?> first = process.StandardOutput.ReadLineAsync();
            Assert.True(first.Wait(Patience) && first.Result?.StartsWith("figure-6-3-a.png", StringComparison.Ordinal) == true, first.Result);
            ProgramFactAttribute.Run("kill", "-INT", $"{process.Id}");
            (int status, string error) = End(process, process.StandardError.ReadToEndAsync());
            Assert.Equal(130, status);
            Assert.Contains("pictures are in", error, StringComparison.Ordinal);
            Assert.Equal(600, ImageFile.Read(_folder["report/figure-6-3-a.png"]).Width);
            Assert.False(File.Exists(_folder["report/index.md"]));
        }
        finally
        {
            if (!process.HasExited)
            {
                process.Kill();
            }
        }
    }

    [LinuxFact]
    public void Wide_vectors_change_no_bit_and_the_environment_wins()
    {
        JsonElement chosen = Bench(null);
        JsonElement narrow = Bench("256");
        bool isWide = Vector512.IsHardwareAccelerated && Vector<float>.Count >= 8;
        Assert.Equal(Vector256.IsHardwareAccelerated ? 8 : Vector<float>.Count, narrow.GetProperty("lanes").GetInt32());
        Assert.Equal(isWide ? 16 : narrow.GetProperty("lanes").GetInt32(), chosen.GetProperty("lanes").GetInt32());
        Assert.Equal(Hash(null), Hash("256"));
    }

    [LinuxFact]
    public void The_number_of_lanes_is_the_users_choice_and_short_renders_keep_what_the_program_starts_with()
    {
        if (!Vector256.IsHardwareAccelerated || Vector<float>.Count < 8)
        {
            return;
        }

        JsonElement Render(params string[] more) => JsonDocument.Parse(Finish(Start(null, ["render", _scene, "--json", .. more])).Output).RootElement;
        int widest = WideVectors.Widest;
        JsonElement[] renders = [Render("--lanes", "8"), Render($"--lanes={widest}"), Render("--width", "24"), Render("--width", "24", "--spp", "20000")];
        Assert.Equal([8, widest, 8, widest], renders.Select(r => r.GetProperty("lanes").GetInt32()));
        Assert.Single(renders[..3].Select(r => r.GetProperty("filmHash").GetString()).Distinct());

        // No warning is printed twice.
        (int status, _, string error) = Finish(Start("render", _scene, "-o", _folder["a.png"], "--width", "24", "--spp", "20000", "--checkpoint-interval", "5m", "--preview"));
        Assert.Equal(0, status);
        Assert.Equal(2, error.Split('\n').Count(line => line.Contains("warning", StringComparison.Ordinal)));
    }

    internal static string Program { get; } = Path.Combine(AppContext.BaseDirectory, OperatingSystem.IsWindows() ? "raytracer.exe" : "raytracer");

    internal static Process Start(params string[] args) => Start(null, args);

    private static Process Start(string? vectorWidth, string[] args)
    {
        ProcessStartInfo start = new(Program, args) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true };
        start.Environment.Remove(WideVectors.Variable);
        if (vectorWidth is not null)
        {
            start.Environment[WideVectors.Variable] = vectorWidth;
        }

        return Process.Start(start)!;
    }

    internal static (int Status, string Output, string Error) Finish(Process process)
    {
        using (process)
        {
            Task<string> output = process.StandardOutput.ReadToEndAsync();
            (int status, string error) = End(process, process.StandardError.ReadToEndAsync());
            return (status, output.Result, error);
        }
    }

    private static (int Status, string Error) End(Process process, Task<string> error)
    {
        bool ended = process.WaitForExit(Patience);
        if (!ended)
        {
            process.Kill();
        }

        Assert.True(ended, "the process did not end");
        return (process.ExitCode, error.Result);
    }

    // Tests that a shell runs in the background ignore Ctrl-C or a closed terminal, and so would their children.
    private static Process StartInterruptible(string redirection, params string[] args)
    {
        const string heed = "env --default-signal=INT,HUP";
        string[] words = ["-c", $"if {heed} true 2> /dev/null; then exec {heed} \"$0\" \"$@\" {redirection}; else exec \"$0\" \"$@\" {redirection}; fi", Program, .. args];
        return Process.Start(new ProcessStartInfo("/bin/sh", words) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true })!;
    }

    private void SignalWritesTheImage(string signal, int status, string redirection = "")
    {
        using Process process = StartInterruptible(redirection, "render", _scene, "-o", _folder["a.png"], "-o", _folder["a.pfm"], "--spp", "16777216");
        try
        {
            // The first line of progress is proof that samples are in the film.
            Task<string?> first = process.StandardError.ReadLineAsync();
            Assert.True(first.Wait(Patience) && first.Result?.Contains("rays/s", StringComparison.Ordinal) == true, first.Result);
            ProgramFactAttribute.Run("kill", $"-{signal}", $"{process.Id}");
            (int actual, string error) = End(process, process.StandardError.ReadToEndAsync());
            Assert.Equal(status, actual);
            Assert.Equal(redirection.Length == 0, error.Contains("the image so far is in", StringComparison.Ordinal));
            Assert.True(ImageFile.Read(_folder["a.pfm"]).Pixels.Max() > 0);
            Assert.Equal(24, ImageFile.Read(_folder["a.png"]).Width);
            Dictionary<string, string> texts = new(ImageFile.ReadText(_folder["a.png"]));
            Assert.Contains("unfinished", texts["Samples"], StringComparison.Ordinal);
            Assert.StartsWith("0..", texts["SampleRange"], StringComparison.Ordinal);

            // All pixels have those samples.
            CliRun.Fine("verify", _folder["a.png"]);
        }
        finally
        {
            if (!process.HasExited)
            {
                process.Kill();
            }
        }
    }

    private JsonElement Bench(string? width) =>
        JsonDocument.Parse(Finish(Start(width, ["bench", _scene, "--json", "--repeat", "1", "--spp", "1"])).Output).RootElement;

    private string Hash(string? width) => JsonDocument.Parse(Finish(Start(width, ["render", _scene, "--json"])).Output).RootElement.GetProperty("filmHash").GetString()!;
}
