using System.Text.Json;
using RayTracer.Cli.Tests;

namespace RayTracer.Labs.Tests;

/// <summary>The verb <c>lab</c>, with processes as a student and a teacher have them.</summary>
[Trait("Category", "Slow")]
public sealed class LabCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void A_lab_from_beginning_to_end()
    {
        string lab = _folder["lab"];
        CliRun.Fine("lab", "new", "1", "--folder", lab, "--name", "Ada");
        Assert.Equal("Lab 1: Rays and shapes", CliRun.Fine("lab", "list").Output.Split('\n')[0].TrimEnd()[3..]);
        CliRun.Refused(4, "is not empty", "lab", "new", "1", "--folder", lab);

        // By itself, from the packages beside it.
        (int status, string output) = ProgramFactAttribute.Run("dotnet", "build", lab, "-v", "q", "-nologo");
        Assert.True(status == 0, output);

        CliRun begun = CliRun.Of("lab", "check", "--folder", lab);
        Assert.Equal(1, begun.Status);
        Assert.Contains("Not written yet: Camera.RayThrough", begun.Output, StringComparison.Ordinal);
        Assert.Contains("0 of 10 points", begun.Output, StringComparison.Ordinal);

        foreach (string file in Directory.GetFiles(Path.Combine(LabVariants.FolderOf(Lab.Of(1)), "solution")))
        {
            File.Copy(file, Path.Combine(lab, Path.GetFileName(file)), overwrite: true);
        }

        Assert.Contains("10 of 10 points", CliRun.Fine("lab", "check", "--folder", lab).Output, StringComparison.Ordinal);
        Assert.Contains("data:image/png;base64,", File.ReadAllText(Path.Combine(lab, "report.html")), StringComparison.Ordinal);
        CliRun.Fine("lab", "hand-in", "--folder", lab);
        Directory.CreateDirectory(_folder["in"]);
        File.Move(Path.Combine(lab, "lab1-ada.zip"), _folder["in/lab1-ada.zip"]);
        Assert.Contains("Ada, lab 1: 10 of 10 points", CliRun.Fine("lab", "grade", _folder["in"], "--trust", "--csv", _folder["marks.csv"]).Output, StringComparison.Ordinal);
        Assert.Contains("lab1-ada.zip,Ada,1,10,10,,", File.ReadAllText(_folder["marks.csv"]), StringComparison.Ordinal);

        // A function that calls itself without end ends the process: the other checks have another one.
        Edit(lab, "Shapes.cs", "double t = Vector.Dot(point - ray.Origin, normal)", "double t = Plane(ray, point, normal) ?? Vector.Dot(point - ray.Origin, normal)");
        JsonElement checks = JsonDocument.Parse(CliRun.Of("lab", "check", "--folder", lab, "--json").Output).RootElement.GetProperty("checks");
        Assert.Equal([true, true, true, false, true, true, false], checks.EnumerateArray().Select(c => c.GetProperty("right").GetBoolean()));
        Assert.Contains("does a function call itself without end", checks[3].GetProperty("sentence").GetString(), StringComparison.Ordinal);

        Edit(lab, "Camera.cs", "window.Unit", "window.Unitt");
        Assert.Matches(@"\n  Camera\.cs:\d+:\d+: CS1061: ", CliRun.Of("lab", "check", "--folder", lab).Output);
        CliRun.Refused(4, "it does not compile, and would get no points", "lab", "hand-in", "--folder", lab);
        CliRun.Fine("lab", "hand-in", "--folder", lab, "--anyway");
    }

    [SkippableFact]
    public void Hostile_hand_ins_are_graded_and_harm_nothing()
    {
        Skip.If(Sandbox.Obstacle() is not null, Sandbox.Obstacle());
        File.WriteAllText(_folder["secret.txt"], "other's");
        Hostile("loop", "while (true) { }");
        Hostile("memory", "List<byte[]> all = []; while (true) { all.Add(new byte[100_000_000]); Array.Fill(all[^1], (byte)1); }");
        Hostile("spy", $$"""
            List<string> done = [];
            foreach (string path in new[] { "{{_folder.Path}}", "{{AppContext.BaseDirectory}}", "/usr/bin/env", typeof(Hostile).Assembly.Location })
            {
                try { if (Directory.Exists(path)) { Directory.Delete(path, true); } else { File.Delete(path); } if (!path.StartsWith("{{_folder.Path}}")) { done.Add("deleted " + path); } } catch (Exception) { }
            }
            if (File.Exists("{{_folder["secret.txt"]}}") || File.Exists("/etc/passwd")) { done.Add("read"); }
            try { using System.Net.Sockets.TcpClient client = new(); client.Connect("{{"127.0.0.1"}}", {{Listening()}}); done.Add("connected"); } catch (System.Net.Sockets.SocketException) { }
            throw new Exception("done: " + string.Join(", ", done) + ".");
            """);
        CliRun.Fine("lab", "grade", _folder["in"], "--seconds", "3", "--json", _folder["marks.json"]);
        Dictionary<string, string> said = JsonDocument.Parse(File.ReadAllText(_folder["marks.json"])).RootElement.EnumerateArray()
            .ToDictionary(m => m.GetProperty("handIn").GetString()!, m => m.TryGetProperty("checks", out JsonElement checks) ? checks[0].GetProperty("sentence").GetString()! : $"{m.GetProperty("note")}");
        Assert.Contains("took longer than 3 seconds", said["loop"], StringComparison.Ordinal);
        Assert.Matches("OutOfMemoryException|ended the program|took longer", said["memory"]);
        Assert.EndsWith("done: .", said["spy"], StringComparison.Ordinal);
        Assert.True(File.Exists(_folder["secret.txt"]));
    }

    [Fact]
    public void Wrong_words_are_told_kindly()
    {
        CliRun.Refused(4, "there is no lab 9: there are 1", "lab", "new", "9");
        CliRun.Refused(2, "which of list, new, check, hand-in, grade?", "lab");
        CliRun.Refused(4, "is no lab, as it has no lab.json", "lab", "check", "--folder", _folder.Path);
        CliRun.Refused(4, "there are no hand-ins in", "lab", "grade", _folder.Path, "--trust");
    }

    private static int Listening()
    {
        System.Net.Sockets.TcpListener listener = new(System.Net.IPAddress.Loopback, 0);
        listener.Start();
        return ((System.Net.IPEndPoint)listener.LocalEndpoint).Port;
    }

    private static void Edit(string folder, string file, string from, string to)
    {
        string path = Path.Combine(folder, file);
        string text = File.ReadAllText(path);
        Assert.Contains(from, text, StringComparison.Ordinal);
        File.WriteAllText(path, text.Replace(from, to, StringComparison.Ordinal));
    }

    // A solution that does something as soon as it is loaded.
    private void Hostile(string name, string code)
    {
        string folder = Directory.CreateDirectory(_folder[$"in/{name}"]).FullName;
        File.WriteAllText(Path.Combine(folder, "lab.json"), $$"""{ "Lab": 1, "Name": "{{name}}", "Version": "0.1.0" }""");
        foreach (string file in Directory.GetFiles(Path.Combine(LabVariants.FolderOf(Lab.Of(1)), "solution")))
        {
            File.Copy(file, Path.Combine(folder, Path.GetFileName(file)));
        }

        File.WriteAllText(Path.Combine(folder, "Hostile.cs"), $$"""
            namespace Lab1;
            public static class Hostile
            {
                [System.Runtime.CompilerServices.ModuleInitializer]
                public static void Run()
                {
                    {{code}}
                }
            }
            """);
    }
}
