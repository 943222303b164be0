using System.CommandLine;
using System.Text.Json.Nodes;
using RayTracer.Labs;

namespace RayTracer.Cli;

/// <summary><c>raytracer lab list | new N | check | hand-in | grade FOLDER</c>: the labs of the course, for students and for teachers.</summary>
internal static class LabVerb
{
    public static void Build(Command command, Streams streams)
    {
        command.Subcommands.Add(Listing(streams));
        command.Subcommands.Add(New(streams));
        command.Subcommands.Add(Check(streams));
        command.Subcommands.Add(HandIn(streams));
        command.Subcommands.Add(Grade(streams));
        command.Subcommands.Add(Run(streams));
        command.SetAction(int (_) => throw new CommandException(
            ExitStatus.Usage, $"which of {string.Join(", ", command.Subcommands.Where(c => !c.Hidden).Select(c => c.Name))}? Begin with: raytracer lab list"));
    }

    // The command itself, as a program of its own.
    private static string[] Program => [Path.Combine(Compiler.DotNet, "dotnet"), Path.Combine(AppContext.BaseDirectory, "raytracer.dll")];

    private static Option<string> Folder => new("--folder") { Description = "The folder of the lab. Default: the current one.", HelpName = "FOLDER", DefaultValueFactory = _ => "." };

    private static Command Listing(Streams streams)
    {
        Command list = new("list", "Lists the labs.");
        list.SetAction(_ => Lab.All.ToList().ForEach(l => streams.Output.WriteLine($"{l.Number}  {l.Title}")));
        return list;
    }

    private static Command New(Streams streams)
    {
        Command command = new("new", "Makes a folder for a lab: handout, code with holes, checks, and a project that builds by itself.");
        Argument<int> number = new("N") { Description = "The number of the lab." };
        Option<string?> target = new("--folder") { Description = "The folder to make. Default: labN.", HelpName = "FOLDER" };
        Option<string?> name = new("--name") { Description = "The student's name, which selects the random numbers of the checks. Default: that of the account.", HelpName = "NAME" };
        command.Arguments.Add(number);
        command.AddOptions(target, name);
        command.SetAction(result =>
        {
            Lab lab = Lab.Of(result.GetValue(number));
            LabFolder folder = LabFolder.Make(lab, result.GetValue(target) ?? $"lab{lab.Number}", result.GetValue(name) ?? Environment.UserName);
            streams.Output.WriteLine($"{lab.Title}, for {folder.Card.Name}, is in {folder.Path}");
            streams.Output.WriteLine("Read handout.html (or handout.md), fill the holes, and run \"raytracer lab check\" there.");
        });
        return command;
    }

    private static Command Check(Streams streams)
    {
        Command command = new("check", "Compiles a lab, checks it, and shows what is wrong in words and pictures (report.html).");
        Option<string> place = Folder;
        ParsedOption<long?> seconds = Seconds();
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.AddOptions(place, seconds, json);
        command.SetAction(result =>
        {
            LabFolder folder = LabFolder.Open(result.GetValue(place)!);
            LabCheck check = LabCheck.Run(folder, Program, Limit(seconds.Value(result)));
            (string page, IReadOnlyList<IReadOnlyList<string>> commands) = Report.Write(folder, check);
            if (result.GetValue(json))
            {
                JsonObject all = MarkTables.Json(check);
                all["report"] = page;
                JsonText.Write(streams, all);
            }
            else
            {
                Print(check, page, commands, streams);
            }

            return check.IsRight ? ExitStatus.Fine : ExitStatus.Different;
        });
        return command;
    }

    private static Command HandIn(Streams streams)
    {
        Command command = new("hand-in", "Puts the sources of a lab into one file for the teacher.");
        Option<string> place = Folder;
        Option<bool> anyway = new("--anyway") { Description = "Hands in what does not compile, too." };
        command.AddOptions(place, anyway);
        command.SetAction(result =>
        {
            LabFolder folder = LabFolder.Open(result.GetValue(place)!);
            if (!result.GetValue(anyway) && folder.Errors() is [var error, ..])
            {
                throw new CommandException(ExitStatus.InputOutput, $"it does not compile, and would get no points (--anyway hands it in all the same): {error}");
            }

            streams.Wrote([Labs.HandIn.Write(folder)]);
        });
        return command;
    }

    private static Command Grade(Streams streams)
    {
        Command command = new("grade", "Checks all hand-ins of a folder, each in a sandbox, and makes a table.");
        Argument<string> place = new("FOLDER") { Description = "The folder with the hand-ins: their files, or folders that students worked in." };
        Option<string?> csv = new("--csv") { Description = "Writes the table as comma-separated values, for spreadsheets.", HelpName = "FILE" };
        Option<string?> junit = new("--junit") { Description = "Writes it as JUnit XML, for classroom systems and CI.", HelpName = "FILE" };
        Option<string?> json = new("--json") { Description = "Writes it as JSON, with all that the students would read.", HelpName = "FILE" };
        Option<bool> trust = new("--trust") { Description = "Runs the hand-ins without a sandbox: they can do whatever you can." };
        ParsedOption<long?> seconds = Seconds();
        command.Arguments.Add(place);
        command.AddOptions(csv, junit, json, trust, seconds);
        command.SetAction(result =>
        {
            using StopSignals signals = new(streams);
            Grading grading = new(Program, Limit(seconds.Value(result)), result.GetValue(trust));
            IReadOnlyList<Mark> marks = grading.Run(result.GetValue(place)!, mark => streams.Output.WriteLine(mark.Line), signals.Token);
            (string? File, Func<IReadOnlyList<Mark>, string> Text)[] tables =
                [(result.GetValue(csv), MarkTables.Csv), (result.GetValue(junit), MarkTables.JUnit), (result.GetValue(json), MarkTables.Json)];
            foreach ((string? file, Func<IReadOnlyList<Mark>, string> text) in tables.Where(t => t.File is not null))
            {
                Imaging.AtomicFile.Write(file!, stream => stream.Write(System.Text.Encoding.UTF8.GetBytes(text(marks))));
                streams.Wrote([file!]);
            }

            return signals.Status;
        });
        return command;
    }

    // What "check" and "grade" start: it runs the checks of one assembly, of which the student's code is a part.
    private static Command Run(Streams streams)
    {
        Command command = new("run", "Runs the checks of a compiled lab in this process.") { Hidden = true };
        Argument<string> assembly = new("ASSEMBLY");
        Option<string> name = new("--name") { Required = true };
        Option<int> from = new("--from");
        command.Arguments.Add(assembly);
        command.AddOptions(name, from);
        command.SetAction(result =>
        {
            // What the student's code writes would be taken for findings.
            Console.SetOut(TextWriter.Null);
            CheckHost.Run(result.GetValue(assembly)!, result.GetValue(name)!, result.GetValue(from), streams.Output);
        });
        return command;
    }

    private static ParsedOption<long?> Seconds() => OptionValues.Integer("--seconds", $"How long one check may take. Default: {LabCheck.Limit.TotalSeconds}.", 1, 3600);

    private static TimeSpan Limit(long? seconds) => seconds is { } given ? TimeSpan.FromSeconds(given) : LabCheck.Limit;

    private static void Print(LabCheck check, string page, IReadOnlyList<IReadOnlyList<string>> commands, Streams streams)
    {
        streams.Output.WriteLine($"{Lab.Of(check.Card.Lab).Title}: {check.Card.Name}");
        foreach (string error in check.Errors)
        {
            streams.Output.WriteLine($"  {error}");
        }

        foreach ((Finding finding, IReadOnlyList<string> own) in check.Findings.Zip(commands))
        {
            streams.Output.WriteLine($"  {(finding.IsRight ? "✓" : "✗")} {(finding.IsRight ? finding.Points : 0)}/{finding.Points}  {finding.Title}");
            (string Name, string? Text)[] lines = [("", finding.Sentence), ("case: ", finding.Case), ("expected: ", finding.Expected), ("found: ", finding.Found)];
            foreach (string line in lines.Where(l => l.Text is not null).Select(l => l.Name + l.Text).Concat(own.Select(c => $"in 3D: {c}")))
            {
                streams.Output.WriteLine($"         {PlainText.Of(line)}");
            }
        }

        streams.Output.WriteLine(check.Errors.Count > 0 ? "It does not compile." : $"{check.Points} of {check.Most} points. Pictures: {page}");
    }
}
