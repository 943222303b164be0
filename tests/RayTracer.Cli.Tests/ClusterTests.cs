using System.Text.RegularExpressions;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Cli.Tests;

/// <summary><c>cluster slurm</c>: what it writes. tests/slurm.sh runs it on a Slurm.</summary>
public sealed class ClusterTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public ClusterTests()
    {
        _scene = _folder["it's a scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [LinuxFact]
    public void Scripts_are_of_bash_and_hold_what_was_asked_for()
    {
        CliRun run = CliRun.Of(
            "cluster", "slurm", _scene, "--tasks", "3", "--spp", "8", "--crop", "1,2,3,4", "--exposure", "2", "-o", _folder["out.exr"], "-o", _folder["out.png"], "--partition", "fast",
            "--time-limit", "1:00:00", "--memory", "2G", "--sbatch=--account=lab", "--threads", "4");
        Assert.Equal((0, ""), (run.Status, run.Error));
        string render = Script("out.slurm/render.sh");
        Assert.Contains("#SBATCH --partition=fast\n#SBATCH --time=1:00:00\n#SBATCH --mem=2G\n#SBATCH --account=lab\n", render, StringComparison.Ordinal);
        Assert.Contains("#SBATCH --cpus-per-task=4\n", render, StringComparison.Ordinal);
        Assert.Contains("a scene.json' --spp 8 --crop 1,2,3,4 --part \"$SLURM_ARRAY_TASK_ID/3\" --threads 4 ", render, StringComparison.Ordinal);
        Assert.Contains($"--exposure 2 -o {_folder["out.exr"]} -o {_folder["out.png"]}\n", Script("out.slurm/merge.sh"), StringComparison.Ordinal);
    }

    [LinuxFact]
    public void Parts_of_another_scene_have_other_names()
    {
        string[] command = ["cluster", "slurm", _scene, "--tasks", "2", "-o", _folder["out.exr"], "--quiet"];
        Assert.Equal(0, CliRun.Of(command).Status);
        string before = Script("out.slurm/render.sh");
        Assert.Equal(0, CliRun.Of(command).Status);
        Assert.Equal(before, Script("out.slurm/render.sh"));

        File.WriteAllText(_scene, CliRun.Scene.Replace("skyblue", "tomato", StringComparison.Ordinal));
        Assert.Equal(0, CliRun.Of(command).Status);
        Assert.NotEqual(before, Script("out.slurm/render.sh"));
    }

    [LinuxFact]
    public void Frames_are_shared_out()
    {
        Assert.Equal(0, CliRun.Of("cluster", "slurm", _scene, "--tasks", "2", "--frames", "0..9:3", "-o", _folder["f-##.png"], "--quiet").Status);
        Assert.Contains("--frames 0..9:3  --part \"$SLURM_ARRAY_TASK_ID/2\"", Script("f-00.slurm/render.sh"), StringComparison.Ordinal);
        Script("f-00.slurm/merge.sh");
    }

    [LinuxFact]
    public void A_task_goes_on_with_what_it_had_begun()
    {
        string[] samples = ["--width", "20", "--spp", "400"];
        Assert.Equal(0, CliRun.Of(["cluster", "slurm", _scene, .. samples, "--tasks", "2", "-o", _folder["out.exr"], "--program", ProcessTests.Program, "--quiet"]).Status);
        string script = _folder["out.slurm/render.sh"];
        string name = Regex.Match(File.ReadAllText(script), @"\.[0-9a-f]{8}-400-2-", RegexOptions.None, TimeSpan.FromSeconds(1)).Value;
        string begun = _folder[$"out.slurm/{name}2.rtfilm"];
        Assert.Equal(0, CliRun.Of(["render", _scene, .. samples, "--part", "2/2", "-o", begun, "--quiet"]).Status);

        // A hundred samples that came to nothing: so it shows that they are kept.
        FilmHeader header = FilmFile.ReadHeader(begun);
        FilmFile.Write(begun, new(20, 13), header with { Samples = [new(200, 300)] });
        Assert.Equal(0, ProgramFactAttribute.Run("env", "SLURM_ARRAY_TASK_ID=2", "bash", script).ExitCode);
        string done = Assert.Single(Directory.GetFiles(_folder["out.slurm"], "*.rtfilm"));
        (FilmHeader written, Film film) = FilmFile.Read(done);
        Assert.True(written.IsComplete);
        Assert.Equal(20 * 13 * 100, film.TotalSamples);
    }

    [Theory]
    [InlineData("slurm SCENE -o out.exr", 2, "how many tasks?")]
    [InlineData("slurm SCENE --tasks 2", 2, "where to?")]
    [InlineData("slurm SCENE --tasks 5 -o out.exr", 2, "--tasks 5: 4 samples make at most 4 parts")]
    [InlineData("slurm SCENE --tasks 3 --frames 0..1 -o f#.exr", 2, "2 frames make at most 2 parts")]
    [InlineData("slurm missing.json --tasks 2 -o out.exr", 4, "missing.json: error: file not found")]
    [InlineData("slurm SCENE --tasks 2 -o out.exe", 2, "did you mean '.exr'?")]
    [InlineData("slurm SCENE --taks 2", 2, "usage: raytracer cluster slurm SCENE")]
    [InlineData("", 2, "which cluster?")]
    public void Wrong_words_are_reported(string words, int status, string message)
    {
        CliRun run = CliRun.Of(["cluster", .. words.Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(w => w == "SCENE" ? _scene : w.StartsWith("out", StringComparison.Ordinal) ? _folder[w] : w)]);

        Assert.Equal(status, run.Status);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    private string Script(string name)
    {
        Assert.Equal(0, ProgramFactAttribute.Run("bash", "-n", _folder[name]).ExitCode);
        return File.ReadAllText(_folder[name]);
    }
}
