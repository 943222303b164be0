using System.CommandLine;
using System.Text;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Labs;
using RayTracer.Scenes;
using RayTracer.Study;

namespace RayTracer.Cli;

/// <summary><c>raytracer selftest DLL</c></summary>
internal static class SelfTestVerb
{
    private const string Page = "report.html";

    public static void Build(Command command, Streams streams)
    {
        Argument<string> file = new("DLL") { Description = "The plug-in: a .NET assembly whose public materials, shapes and lights are tested." };
        Option<string?> output = new("-o", "--output") { Description = $"Writes {Page}, with drawings of what differs, into this folder; created if it is missing.", HelpName = "FOLDER" };
        ParsedOption<long?> seed = OptionValues.Integer("--seed", "Seed of the random numbers. Default: 1.", 0, int.MaxValue);
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.Arguments.Add(file);
        command.AddOptions(output, seed, json);
        command.SetAction(result => Run(result.GetValue(file)!, result.GetValue(output), seed.Value(result) ?? 1, result.GetValue(json), streams));
    }

    private static int Run(string file, string? folder, long seed, bool isJson, Streams streams)
    {
        if (folder is not null)
        {
            Directory.CreateDirectory(folder);
            AtomicFile.Check(Path.Combine(folder, Page));
        }

        IReadOnlyList<TestedClass> tested = [];
        PluginFile.Read(file, assembly => tested = SelfTest.Of(assembly, seed, isJson ? null : t => Write(t, streams.Output)));
        if (tested.Count == 0)
        {
            throw new PluginException($"{file}: there is nothing to test: it needs public materials, shapes or lights with a constructor without parameters, or records that describe them");
        }

        string[] drawings = folder is null ? [] : [.. WriteReport(folder, Path.GetFileName(file), tested)];
        if (isJson)
        {
            JsonText.Write(streams, new() { ["classes"] = JsonText.List(tested.Select(Json)) });
        }
        else
        {
            int wrong = tested.Sum(t => t.Facts.Count(f => !f.Holds));
            streams.Output.WriteLine(wrong == 0 ? "all facts hold" : $"{wrong} of {tested.Sum(t => t.Facts.Count)} facts do not hold");
            streams.Wrote(drawings);
        }

        return tested.All(t => t.Holds) ? ExitStatus.Fine : ExitStatus.Different;
    }

    private static void Write(TestedClass tested, TextWriter output)
    {
        output.WriteLine(tested.Name);
        foreach (Fact fact in tested.Facts)
        {
            output.WriteLine($"  {(fact.Holds ? "holds" : "FAILS")}  {fact.Name}");
            if (!fact.Holds)
            {
                output.WriteLine($"         {fact.Case}: {fact.Sentence}");
            }
        }
    }

    private static IEnumerable<string> WriteReport(string folder, string file, IReadOnlyList<TestedClass> tested)
    {
        HtmlPage page = new($"Self-test of {file}");
        foreach ((TestedClass one, int number) in tested.Select((t, i) => (t, i)))
        {
            page.Heading(one.Name);
            page.Table(["fact", "holds", "case", "expected", "found"], one.Facts.Select(f => (IReadOnlyList<string>)[f.Name, f.Holds ? "yes" : "no", f.Case, Text(f.Expected), Text(f.Found)]));
            foreach ((Fact fact, int index) in one.Facts.Select((f, i) => (f, i)).Where(f => !f.f.Holds))
            {
                page.Paragraph($"{fact.Name}: {fact.Sentence}");
                if (fact.Drawing is { } drawing)
                {
                    string name = $"class-{number + 1}-fact-{index + 1}.svg";
                    AtomicFile.Write(Path.Combine(folder, name), stream => drawing.Save(stream));
                    page.Picture(name, $"{fact.Name}, {fact.Case}");
                    yield return Path.Combine(folder, name);
                }
            }
        }

        AtomicFile.Write(Path.Combine(folder, Page), stream => stream.Write(Encoding.UTF8.GetBytes(page.Finish())));
        yield return Path.Combine(folder, Page);
    }

    private static string Text(double value) => double.IsNaN(value) ? "" : value.ToString("G4", System.Globalization.CultureInfo.InvariantCulture);

    private static JsonObject Json(TestedClass tested) => new()
    {
        ["name"] = tested.Name,
        ["holds"] = tested.Holds,
        ["facts"] = JsonText.List(tested.Facts.Select(f => new JsonObject
        {
            ["name"] = f.Name,
            ["holds"] = f.Holds,
            ["sentence"] = f.Sentence,
            ["case"] = f.Case,
            ["expected"] = JsonText.Number(f.Expected),
            ["found"] = JsonText.Number(f.Found),
        })),
    };
}
