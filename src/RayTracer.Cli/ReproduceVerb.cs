using System.CommandLine;
using RayTracer.Cli.Reproduce;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary><c>raytracer reproduce report -o FOLDER</c></summary>
internal static class ReproduceVerb
{
    private const string Report = "report";

    public static void Build(Command command, Streams streams)
    {
        Argument<string> what = new("WHAT") { Description = $"What is reproduced: {Report}, the figures and tables of its section 6.3." };
        Option<string?> output = new("-o", "--output") { Description = "The folder for pictures, chart and pages; made if it is missing.", HelpName = "FOLDER" };
        Option<bool> quick = new("--quick") { Description = "Smaller pictures and fewer samples: some seconds." };
        command.Arguments.Add(what);
        command.Options.Add(output);
        command.Options.Add(quick);
        command.SetAction(result =>
        {
            string word = result.GetValue(what)!;
            if (word != Report)
            {
                throw new CommandException(ExitStatus.Usage, $"unknown word {Quotation.Of(word)}{Spelling.DidYouMean(word, [Report])}: expected {Report}");
            }

            string folder = result.GetValue(output) ?? throw new CommandException(ExitStatus.Usage, "where to? Give -o FOLDER");
            ReproductionPlan plan = result.GetValue(quick) ? ReproductionPlan.Quick : ReproductionPlan.Full;
            return new Reproduction(plan, folder, Shell.Command(result.Tokens.Select(t => t.Value)), streams).Run();
        });
    }
}
