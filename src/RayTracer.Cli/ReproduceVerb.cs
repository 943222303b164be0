using System.CommandLine;
using RayTracer.Description;
using RayTracer.Study;

namespace RayTracer.Cli;

/// <summary><c>raytracer reproduce report|complexity -o FOLDER</c></summary>
internal static class ReproduceVerb
{
    private const string Report = "report";
    private const string Complexity = "complexity";

    public static void Build(Command command, Streams streams)
    {
        Argument<string> what = new($"{Report}|{Complexity}")
        {
            Description = $"What to reproduce: {Report}, the figures and tables of its section 6.3, or {Complexity}, time per ray against the number of triangles.",
        };
        Option<string?> output = new("-o", "--output") { Description = "The folder for pictures, charts and pages; created if it is missing.", HelpName = "FOLDER" };
        Option<bool> quick = new("--quick") { Description = "Smaller pictures, fewer samples and triangles: takes seconds." };
        command.Arguments.Add(what);
        command.AddOptions(output, quick);
        command.SetAction(result =>
        {
            string word = result.GetValue(what)!;
            if (word is not Report and not Complexity)
            {
                string hint = $"{Quotation.Of(word)}{Spelling.DidYouMean(word, [Report, Complexity])}";
                throw new CommandException(ExitStatus.Usage, $"unknown word {hint}: expected {Report} or {Complexity}");
            }

            string folder = result.GetValue(output) ?? throw new CommandException(ExitStatus.Usage, "where to? Give -o FOLDER");
            return Run(word == Report, result.GetValue(quick), folder, streams);
        });
    }

    private static int Run(bool isReport, bool isQuick, string folder, Streams streams)
    {
        using StopSignals signals = new(streams);
        try
        {
            if (isReport)
            {
                new Reproduction(isQuick ? ReproductionPlan.Quick : ReproductionPlan.Full, folder, streams.Output, streams)
                    .Run(signals.Token);
            }
            else
            {
                new ComplexityRun(isQuick ? ComplexityPlan.Quick : ComplexityPlan.Full, folder, streams.Output).Run(signals.Token);
            }
        }
        catch (OperationCanceledException)
        {
            streams.Warn($"stopped: the pages were not written{(isReport ? $", but finished pictures are in {folder}" : "")}");
        }

        return signals.Status;
    }
}
