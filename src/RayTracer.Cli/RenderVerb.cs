using System.CommandLine;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary><c>raytracer render SCENE -o FILE</c>: words become a job, which <see cref="ConsoleRun"/> carries out.</summary>
internal sealed class RenderVerb
{
    private readonly Argument<string> _scene = new("SCENE") { Description = "The scene file: native (.json), of Mitsuba (.xml) or pbrt (.pbrt), or a model." };
    private readonly Option<string[]> _outputs = new("-o", "--output")
    {
        HelpName = "FILE",
        Description = $"The image file: {ImageFormat.Endings()}; or .rtfilm, the film itself. May be given several times.",
    };

    private readonly JobOptionSet _options;
    private readonly DisplayOptions _display;

    private RenderVerb(Command command)
    {
        command.Arguments.Add(_scene);
        command.Options.Add(_outputs);
        _options = new(command, JobOptions.All);
        _display = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        RenderVerb verb = new(command);
        command.SetAction(result =>
        {
            (RenderJob job, Display display) = (verb.Job(result), verb._display.Of(result));
            return new ConsoleRun(display, streams) { Warn = () => verb.WarnOfUnused(result, job, display, streams) }.Run(job);
        });
    }

    private void WarnOfUnused(ParseResult result, RenderJob job, Display display, Streams streams)
    {
        _options.WarnOfUnused(result, job.Outputs, streams, isSeen: display.Preview);
        if (job.Checkpoint is null && _options.Has(result, "--checkpoint-interval"))
        {
            streams.Warn("--checkpoint-interval has no effect: there are no checkpoints without --checkpoint FILE");
        }

        if (job.FramesPerSecond is not null && !FrameFiles.MakeAnimation(job))
        {
            streams.Warn("--fps has no effect: it is for animated PNGs (-o FILE.png or FILE.apng), and none is written");
        }
    }

    private RenderJob Job(ParseResult result)
    {
        RenderJob job = _options.Put(result, new() { Scene = result.GetValue(_scene)!, Outputs = result.GetValue(_outputs) ?? [] });
        return JobRules.Complaint(job, _display.Of(result).Options) is { } complaint
            ? throw new CommandException(ExitStatus.Usage, complaint) : job.Sized();
    }
}
