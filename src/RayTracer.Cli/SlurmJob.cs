using System.ComponentModel;
using System.Diagnostics;
using System.Text;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>
/// Two scripts for Slurm: an array of tasks, each of which renders a part and gives the file its name only when it is whole, and a job
/// after them that
/// renders parts again that are missing, and then merges. What a task does may be done twice at once: the last rename wins, and both have
/// the same bits.
/// </summary>
internal sealed record SlurmJob
{
    private const string Array = "render.sh";
    private const string Merge = "merge.sh";

    /// <summary>The job of a single render.</summary>
    public required RenderJob Job { get; init; }

    /// <summary>The number of tasks.</summary>
    public required int Tasks { get; init; }

    /// <summary>The words after <c>render</c> that decide on samples, with the scene first.</summary>
    public required IReadOnlyList<string> Render { get; init; }

    /// <summary>The words that say how images look.</summary>
    public required IReadOnlyList<string> Looks { get; init; }

    /// <summary>The folder of scripts, parts and logs.</summary>
    public required string Folder { get; init; }

    /// <summary>The command as nodes know it; null for this program.</summary>
    public string? Program { get; init; }

    /// <summary>Cores for each task.</summary>
    public required int Threads { get; init; }

    /// <summary>The number of times that failed parts are rendered again.</summary>
    public required int Retries { get; init; }

    /// <summary>Options of sbatch.</summary>
    public required IReadOnlyList<string> Lines { get; init; }

    private bool HasFrames => Job.Frames is not null;

    private string Command => Program ?? ProgramHere();

    /// <summary>Writes the scripts, and hands them in.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public int Run(bool submit, bool quiet, Streams streams)
    {
        SceneLoadResult scene = (Job.Frames is { } frames ? Job with { Frames = new(frames.First, frames.First, 1) } : Job).Load();
        streams.Read(scene.Diagnostics);
        if (scene.Scene is null)
        {
            return SceneFile.FailureStatus(Job.Scene);
        }

        int samples = scene.Description!.Render.SamplesPerPixel;
        if (!HasFrames && Tasks > samples)
        {
            throw new CommandException(ExitStatus.Usage, $"--tasks {Tasks}: {samples} samples make at most {samples} parts");
        }

        foreach (string output in Job.Outputs)
        {
            JobFiles.CheckFilm(output);
        }

        // Parts of another scene, or another number of them, have other names: what was rendered before of this one counts.
        string name = $"{ContentHash.Of(scene.Description, Job.Scene, Job.Crop)[..8]}-{(HasFrames ? $"{Job.Frames}" : samples)}-{Tasks}".Replace("..", "to", StringComparison.Ordinal).Replace(':', 'x');
        WriteScripts(name);
        if (!quiet)
        {
            streams.Output.WriteLine($"wrote {Path.Combine(Folder, Array)} and {Path.Combine(Folder, Merge)}");
        }

        return submit ? Submit(quiet, streams) : Hint(quiet, streams);
    }

    private int Hint(bool quiet, Streams streams)
    {
        if (!quiet)
        {
            streams.Output.WriteLine($"to submit them: bash {Path.Combine(Folder, Merge)}");
        }

        return ExitStatus.Fine;
    }

    private int Submit(bool quiet, Streams streams)
    {
        try
        {
            using Process process = Process.Start(new ProcessStartInfo("bash", [Path.Combine(Folder, Merge)]) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true })!;
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string said = process.StandardOutput.ReadToEnd().Trim();
            process.WaitForExit();
            if (process.ExitCode != 0)
            {
                throw new CommandException(
                    ExitStatus.InputOutput, $"the jobs could not be submitted: {errors.Result.ReplaceLineEndings(" ").Trim()}");
            }

            if (!quiet)
            {
                streams.Output.WriteLine($"{said}: squeue shows the tasks, and {Path.Combine(Folder, "merge.log")} how it ends");
            }

            return ExitStatus.Fine;
        }
        catch (Win32Exception)
        {
            throw new CommandException(
                ExitStatus.InputOutput, $"bash is not installed here: run \"bash {Path.Combine(Folder, Merge)}\" where Slurm is");
        }
    }

    private void WriteScripts(string name)
    {
        try
        {
            Directory.CreateDirectory(Folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new ImageWriteException($"Cannot make the folder '{Folder}': {e.Message.TrimEnd('.')}.", e);
        }

        Write(Array, ArrayScript(name));
        Write(Merge, MergeScript(name));
    }

    private void Write(string file, string text) =>
        AtomicFile.Write(Path.Combine(Folder, file), stream => stream.Write(Encoding.UTF8.GetBytes(text.ReplaceLineEndings("\n"))));

    // $done is there once a task has done its work. Each run has another name for what becomes $done: a node that was taken for dead may
    // still be rendering. What is begun
    // may be of either: its bits are those of the part's first samples, whatever run wrote it. Five minutes, so that many tasks do not keep
    // a file system busy.
    private string ArrayScript(string name)
    {
        string work = HasFrames
            ? $$"""
              raytracer render {{Words(Render)}} {{Words(Looks)}} --part "$SLURM_ARRAY_TASK_ID/{{Tasks}}" --threads {{Threads}} {{Words(Job.Outputs.SelectMany(o => new[] { "-o", o }))}}
              touch "$done"
              """
            : $$"""
              film={{Quote(Folder)}}/.{{name}}-$SLURM_ARRAY_TASK_ID.${SLURMD_NODENAME:-$(hostname)}-$$.rtfilm
              begun={{Quote(Folder)}}/.{{name}}-$SLURM_ARRAY_TASK_ID.rtfilm
              trap 'rm -f "$film"' EXIT
              raytracer render {{Words(Render)}} --part "$SLURM_ARRAY_TASK_ID/{{Tasks}}" --threads {{Threads}} --quiet --checkpoint "$begun" --checkpoint-interval 5m --resume -o "$film"
              mv -f "$film" "$done"
              rm -f "$begun"
              """;
        return $$"""
            #!/bin/bash
            # Renders one of {{Tasks}} parts. Written by raytracer cluster slurm; merge.sh hands it in.
            #SBATCH --job-name=render
            #SBATCH --requeue
            #SBATCH --open-mode=append
            #SBATCH --cpus-per-task={{Threads}}
            #SBATCH --output="{{Folder}}/part-%a.log"
            {{Options()}}set -euo pipefail
            raytracer() { {{Command}} "$@"; }
            done={{Quote(Folder)}}/{{Done(name)}}
            [ -e "$done" ] && exit 0
            {{work}}

            """;
    }

    // Run here at first, then as a job after the array.
    private string MergeScript(string name)
    {
        return $$"""
            #!/bin/bash
            # Hands in render.sh for the parts that are missing, and itself to follow; where none is, merges. To begin with: bash merge.sh. Written by raytracer cluster slurm.
            #SBATCH --job-name=merge
            #SBATCH --requeue
            #SBATCH --open-mode=append
            #SBATCH --output="{{Folder}}/merge.log"
            {{Options()}}set -euo pipefail
            raytracer() { {{Command}} "$@"; }
            folder={{Quote(Folder)}}
            round=${RAYTRACER_ROUND:-0}
            {{(HasFrames ? $"[ \"$round\" != 0 ] || rm -f \"$folder\"/{name}-*.done" : "# Existing parts count.")}}
            missing=()
            for SLURM_ARRAY_TASK_ID in $(seq {{Tasks}}); do
                [ -e "$folder/{{Done(name)}}" ] || missing+=("$SLURM_ARRAY_TASK_ID")
            done
            if [ ${#missing[@]} -gt 0 ]; then
                if [ "$round" -gt {{Retries}} ]; then
                    echo "parts ${missing[*]} failed $round times: see $folder/part-*.log"
                    exit 1
                fi
                [ "$round" = 0 ] || echo "parts ${missing[*]} are missing and are rendered again"
                list=$(IFS=,; echo "${missing[*]}")
                [ ${#missing[@]} -lt {{Tasks}} ] || list=1-{{Tasks}}
                array=$(sbatch --parsable --array="$list" "$folder/{{Array}}")
                RAYTRACER_ROUND=$((round + 1)) sbatch --export=ALL --dependency="afterany:${array%%;*}" "$folder/{{Merge}}"
                exit 0
            fi
            {{Finish(name)}}

            """;
    }

    private string Finish(string name)
    {
        if (HasFrames)
        {
            return $"echo 'frames {Job.Frames} are there'";
        }

        return $$"""
            parts=()
            for SLURM_ARRAY_TASK_ID in $(seq {{Tasks}}); do
                parts+=("$folder/{{Done(name)}}")
            done
            raytracer merge "${parts[@]}" {{Words(Looks)}} {{Words(Job.Outputs.SelectMany(o => new[] { "-o", o }))}}
            rm -f "$folder"/.{{name}}-* "$folder"/..{{name}}-*
            """;
    }

    private string Options() => string.Concat(Lines.Select(l => $"#SBATCH {l}\n"));

    private string Done(string name) => $"{name}-$SLURM_ARRAY_TASK_ID.{(HasFrames ? "done" : "rtfilm")}";

    private static string Words(IEnumerable<string> words) => string.Join(' ', words.Select(Quote));

    private static string Quote(string word) => Shell.Command([word])["raytracer ".Length..];

    // Not of the folder beside it where it is run by the host "dotnet".
    private static string ProgramHere()
    {
        string process = Environment.ProcessPath ?? "raytracer";
        return Path.GetFileNameWithoutExtension(process) == "dotnet"
            ? $"{Quote(process)} {Quote(Path.Combine(AppContext.BaseDirectory, "raytracer.dll"))}" : Quote(process);
    }
}
