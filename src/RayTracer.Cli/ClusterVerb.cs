using System.CommandLine;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary><c>raytracer cluster slurm SCENE</c>: the options. The work is in <see cref="SlurmJob"/>.</summary>
internal sealed class ClusterVerb
{
    private readonly Argument<string> _scene = new("SCENE") { Description = "The scene file, in a folder that all nodes see." };
    private readonly ParsedOption<long?> _tasks = OptionValues.Integer("--tasks", "How many tasks share the samples, or with --frames the frames.", 1, 100_000);
    private readonly ParsedOption<long?> _threads = OptionValues.Integer("--threads", "Processor cores for each task; 1 without it.", 1, 1024);
    private readonly Option<string?> _partition = new("--partition") { Description = "The partition of the cluster.", HelpName = "NAME" };
    private readonly Option<string?> _time = new("--time-limit") { Description = "The time limit of a task, as Slurm writes it: 30 (minutes), 2:00:00, 1-12:00:00.", HelpName = "TIME" };
    private readonly Option<string?> _memory = new("--memory") { Description = "Memory of a task, as Slurm writes it: 4G.", HelpName = "SIZE" };
    private readonly Option<string[]> _lines = new("--sbatch") { Description = "Another option for sbatch, such as --account=lab. Repeatable.", HelpName = "OPTION" };
    private readonly ParsedOption<long?> _retries = OptionValues.Integer("--retries", "Number of times that failed parts are rendered again. Default: 2.", 0, 100);
    private readonly Option<string?> _folder = new("--folder") { Description = "The folder for scripts, parts and logs. Default: a folder .slurm beside the output.", HelpName = "FOLDER" };
    private readonly Option<string?> _program = new("--program") { Description = "The raytracer command on the nodes. Default: the one running here.", HelpName = "COMMAND" };
    private readonly Option<bool> _submit = new("--submit") { Description = "Submits the jobs with sbatch; otherwise they are only written." };
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Prints errors and warnings only." };
    private readonly JobOptionSet _overrides;
    private readonly WritingOptions _writing;

    private ClusterVerb(Command command)
    {
        command.Arguments.Add(_scene);
        _writing = new(command);
        _overrides = new(command, [.. JobOptions.OfScenes, JobOptions.Crop, JobOptions.Frames, JobOptions.Halves]);
        command.AddOptions(
            [.. _writing.Looks, _tasks, _threads, _partition, _time, _memory, _lines, _retries, _folder, _program, _submit, _quiet]);
    }

    public static void Build(Command command, Streams streams)
    {
        Command slurm = new("slurm", "Writes the jobs of a Slurm cluster that render the parts of a picture, or frames, and merge them.");
        ClusterVerb verb = new(slurm);
        slurm.SetAction(result =>
        {
            SlurmJob job = verb.Job(result);
            verb._writing.WarnOfUnused(result, verb._writing.Files(result), streams);
            return job.Run(result.GetValue(verb._submit), result.GetValue(verb._quiet), streams);
        });
        command.Subcommands.Add(slurm);
        command.SetAction(int (_) => throw new CommandException(
            ExitStatus.Usage, "which cluster? Available: raytracer cluster slurm SCENE --tasks 16 -o out.exr"));
    }

    private SlurmJob Job(ParseResult result)
    {
        IReadOnlyList<string> outputs = _writing.Files(result);
        if (outputs.Count == 0)
        {
            throw new CommandException(ExitStatus.Usage, "where to? Give -o FILE");
        }

        if (_tasks.Value(result) is not { } tasks)
        {
            throw new CommandException(ExitStatus.Usage, "how many tasks? Give --tasks N");
        }

        RenderJob given = _overrides.Given(result) with { Scene = Path.GetFullPath(result.GetValue(_scene)!), Outputs = [.. outputs.Select(Path.GetFullPath)], Writing = _writing.Writing(result) };
        if (JobRules.Complaint(given.Frames is null ? given : given with { Part = (1, (int)tasks) }) is { } complaint)
        {
            // Reported here, not by every task.
            throw new CommandException(ExitStatus.Usage, complaint);
        }

        return new()
        {
            Job = given.Sized(),
            Tasks = (int)tasks,
            Render = [given.Scene, .. _overrides.Words(result)],
            Looks = [.. _writing.Words(result)],
            Folder = Path.GetFullPath(result.GetValue(_folder) ?? Path.ChangeExtension(FrameRange.Name(outputs[0], 0), ".slurm")),
            Program = result.GetValue(_program),
            Threads = (int)(_threads.Value(result) ?? 1),
            Retries = (int)(_retries.Value(result) ?? 2),
            Lines =
            [
                .. Line("--partition", result.GetValue(_partition)),
                .. Line("--time", result.GetValue(_time)),
                .. Line("--mem", result.GetValue(_memory)),
                .. result.GetValue(_lines) ?? [],
            ],
        };
    }

    private static string[] Line(string name, string? value) => value is null ? [] : [$"{name}={value}"];
}
